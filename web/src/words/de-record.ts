import type * as en from './en-record';

export const record: typeof en.record = {
  title: 'Nachweis',
  date: 'Datum',
  run: 'Lauf',
  order: 'Auftrag',
  workOrder: 'Fertigungsauftrag',
  serialNumber: 'Seriennummer',
  releasedBy: 'Freigegeben von',
  acceptedBy: 'Angenommen von',
  notAccepted: 'nicht angenommen',
  cell: 'Zelle',
  software: 'Software',
  plan: 'Plan (SHA-256)',
};
