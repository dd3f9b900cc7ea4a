/** What is wrong with a file, as the engine says it in English: its own words, `{}` for what they name. English needs no others. */
export const flaws: Record<string, string> = {};
