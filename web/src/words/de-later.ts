/** Messages in German that are fetched when the first of them is to be said: those of diagnoses and trials. */
export const messages = import.meta.glob<string>(
  '../../../core/words/de/{advice,gap,instruction,symptom,trial}.ftl',
  { query: '?raw', import: 'default', eager: true },
);
