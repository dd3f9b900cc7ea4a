import type * as en from './en-charts';

export const charts: typeof en.charts = {
  tools: (chart) => `${chart}: Zoom, Linien, Herunterladen`,
  whole: 'Alles zeigen',
  closer: 'Vergrößern',
  farther: 'Verkleinern',
  lower: 'unteres Ende des 95-%-Intervalls',
  upper: 'oberes Ende des 95-%-Intervalls',
  crosshair: 'Werte am Fadenkreuz',
};
