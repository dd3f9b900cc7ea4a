import type * as en from './en-timeline';

export const timeline: typeof en.timeline = {
  title: 'Effekte im Lauf der Zeit',
  next: 'Öffnen Sie eine Diagnose, diagnostizieren Sie die fehlenden Läufe, oder nehmen Sie eine hochgeladene Aufzeichnung hinzu.',
  back: 'Zurück zum Verlauf',
  tooFew: 'Mindestens zwei diagnostizierte Aufzeichnungen sind nötig.',
  missing: 'Noch nicht diagnostiziert',
  diagnose: 'Diagnostizieren',
  uploads: 'Hochgeladene Aufzeichnungen',
  uploadsHint: 'Eine hochgeladene Aufzeichnung steht dort, wo der Zeitpunkt ihres Hochladens liegt.',
  add: 'Hinzunehmen',
  each: 'Aufzeichnung für Aufzeichnung',
  none: 'Keine dieser Aufzeichnungen zeigt einen Effekt, der zählt.',
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
