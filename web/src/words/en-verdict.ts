/** The verdict of a diagnosis, what it stands on, and what a twin does to a result. */
export const verdict = {
  from: (recording: string) => `from ${recording}`,
  unsettledNext: 'Ask an engineer, or record the motion that is proposed.',
  besides: 'Besides',
  evidence: 'Evidence for the engineer',
  rejected: (count: number) =>
    `Sizes of the ${count === 1 ? 'effect' : `${count} effects`} that the verdict does not name`,
  notSignificant: 'not significant',
  significant: (times: string) => `significant (${times} × both intervals)`,
  changeNote: 'A change is held against both intervals together.',
  timesNoise: '× noise',
  uploadName: 'Name of the recording',
  twinShare: {
    title: 'Share of the twin',
    note: 'The estimate takes these effects of the cell’s twin into account. Each line says what that changes.',
    changed: (mass: string, moment: string, inertia: string) =>
      `mass ${mass}, first moment ${moment}, inertia up to ${inertia}`,
  },
};
