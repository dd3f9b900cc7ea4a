/** What every chart can do. */
export const charts = {
  tools: (chart: string) => `${chart}: zoom, lines, download`,
  whole: 'Show all',
  closer: 'Zoom in',
  farther: 'Zoom out',
  lower: 'lower end of the 95 % interval',
  upper: 'upper end of the 95 % interval',
  crosshair: 'Values at the crosshair',
};
