/** Why nothing is asked of two bodies, as the engine says it in English. English needs no others. */
export const leftOut: Record<string, string> = {};
