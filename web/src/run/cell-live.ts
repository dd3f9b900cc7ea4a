import { effect, signal } from '@preact/signals';
import type { ControlPublic, RunPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { session } from '../session/session';
import { hearAll } from '../ui/socket';

/** What `/api/cells/{cell}/live` sends: the run that has the cell, null where none has, and who is in control of it. */
export interface CellLive {
  run: RunPublic | null;
  control: ControlPublic;
}

/** The same of the chosen cell, as the service said last; null until it is known. */
export const cellLive = signal<CellLive | null>(null);

effect(() => {
  const name = chosenCell.value;
  cellLive.value = null;
  if (!session.value || !name) return undefined;
  return hearAll<CellLive>(`/api/cells/${encodeURIComponent(name)}/live`, (message) => {
    cellLive.value = message;
  });
});
