/** Which effect came when. */
export const timeline = {
  title: 'Effects over time',
  next: 'Open a diagnosis, diagnose the runs that are missing, or add an uploaded recording.',
  back: 'Back to the history',
  tooFew: 'At least two diagnosed recordings are needed.',
  missing: 'Not diagnosed yet',
  diagnose: 'Diagnose',
  uploads: 'Uploaded recordings',
  uploadsHint: 'An uploaded recording takes its place by the time of its upload.',
  add: 'Add',
  each: 'Recording by recording',
  none: 'None of these recordings shows an effect that matters.',
  effect: 'Effect',
  interval: '± is half of the 95 % interval.',
  states: {
    present: '✓ there',
    possible: '? perhaps',
    minor: '○ there, not material',
    absent: '– not seen',
    unclear: '· cannot be told',
  },
};
