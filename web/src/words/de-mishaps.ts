import type { mishaps as enMishaps } from './en-mishaps';

/** Was allein auf diesem Bildschirm schiefgeht. */
export const mishaps: typeof enMishaps = {
  unreachable: 'Der Dienst antwortet nicht. Prüfen Sie das Netz und versuchen Sie es noch einmal.',
  'not-in-control':
    'Dieser Bildschirm hat die Bedienung nicht. Übernehmen Sie sie und versuchen Sie es noch einmal.',
  'control-not-taken': 'Die Bedienung ging verloren, bevor sie begann. Übernehmen Sie sie noch einmal.',
};
