/** The picture of the cell in three dimensions. */
export const view = {
  from: 'View',
  looks: { front: 'Front', top: 'Top', operator: 'Operator', fit: 'Fit', reset: 'Reset' },
  path: 'Planned path',
  play: 'Play',
  pause: 'Pause',
  of: (whole: string) => `of ${whole} of motion`,
};
