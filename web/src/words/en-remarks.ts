/** What a remark of the engine names, as text: numbers with their unit. */
export type Named = Record<string, string>;

/** What the engine says in sentences of its own; in English it does so itself. */
export const remarks = {
  /** To be minded with a result, by the identifier of the remark. */
  warnings: {} as Record<string, (named: Named) => string>,
  /** Why a parameter is not determined, by the part of the payload. */
  undetermined: {} as Record<string, string>,
  /** What an export holds, by its target. */
  exports: {} as Record<string, string>,
  /** Why a recording cannot show an effect, by the engine's sentence. */
  limits: {} as Record<string, string>,
};
