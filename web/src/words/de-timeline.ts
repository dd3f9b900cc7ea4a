import type * as en from './en-timeline';

export const timeline: typeof en.timeline = {
  title: 'Effekte im Lauf der Zeit',
  next: 'Öffnen Sie eine Diagnose, oder diagnostizieren Sie die fehlenden Läufe.',
  back: 'Zurück zum Verlauf',
  tooFew: 'Mindestens zwei dieser Läufe müssen diagnostiziert sein.',
  missing: 'Noch nicht diagnostiziert',
  diagnose: 'Diagnostizieren',
  each: 'Lauf für Lauf',
  none: 'Keiner dieser Läufe zeigt einen Effekt, der zählt.',
  effect: 'Effekt',
  interval: '± ist die Hälfte des 95-%-Intervalls.',
  states: {
    present: '✓ da',
    possible: '? vielleicht',
    minor: '○ da, ohne Belang',
    absent: '– nicht gesehen',
    unclear: '· nicht zu sagen',
  },
};
