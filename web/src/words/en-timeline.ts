/** Which effect came when. */
export const timeline = {
  title: 'Effects over time',
  next: 'Open a diagnosis, or diagnose the runs that are missing.',
  back: 'Back to the history',
  tooFew: 'At least two of these runs have to be diagnosed.',
  missing: 'Not diagnosed yet',
  diagnose: 'Diagnose',
  each: 'Run by run',
  none: 'None of these runs shows an effect that matters.',
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
