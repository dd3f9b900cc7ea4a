/** Refusals, stops and their reasons, as the engine says them in English: its own words, `{}` for what they name. English needs no others. */
export const sentences: Record<string, string> = {};
