import type * as en from './en-verdict';

export const verdict: typeof en.verdict = {
  from: (recording) => `aus ${recording}`,
  unsettledNext: 'Fragen Sie eine Fachkraft, oder zeichnen Sie die vorgeschlagene Bewegung auf.',
  besides: 'Außerdem',
  evidence: 'Belege für die Fachkraft',
  rejected: (count) =>
    count === 1
      ? 'Größe des Effekts, den das Urteil nicht nennt'
      : `Größen der ${count} Effekte, die das Urteil nicht nennt`,
  notSignificant: 'nicht signifikant',
  significant: (times) => `signifikant (das ${times}-fache beider Intervalle)`,
  changeNote: 'Eine Änderung wird an beiden Intervallen zusammen gemessen.',
  timesNoise: '× Rauschen',
  uploadName: 'Name der Aufzeichnung',
  twinShare: {
    title: 'Anteil des Zwillings',
    note: 'Die Schätzung berücksichtigt diese Effekte des Zwillings der Zelle. Jede Zeile sagt, was das ändert.',
    changed: (mass, moment, inertia) => `Masse ${mass}, statisches Moment ${moment}, Trägheit bis ${inertia}`,
  },
};
