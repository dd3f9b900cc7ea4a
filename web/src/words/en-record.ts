/** What a result says of itself on paper. */
export const record = {
  title: 'Record',
  date: 'Date',
  run: 'Run',
  order: 'Order',
  workOrder: 'Work order',
  serialNumber: 'Serial number',
  releasedBy: 'Released by',
  acceptedBy: 'Accepted by',
  notAccepted: 'not accepted',
  cell: 'Cell',
  software: 'Software',
  plan: 'Plan (SHA-256)',
};
