import type { RunPublic } from '../api';
import { nameOf } from '../ui/names';
import { moment } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';

/** What a plant knows a run by. */
export interface Identifiers {
  serial_number: string;
  order_id: string;
  work_order: string;
}

const NAMES = ['serial_number', 'order_id', 'work_order'] as const;

/** Of a run, as far as whoever ordered it has said; empty where not. */
export function identifiersOf(run: RunPublic): Identifiers {
  const said = { ...run.order, ...run } as Record<string, unknown>;
  const [serial_number, order_id, work_order] = NAMES.map((name) =>
    typeof said[name] === 'string' ? said[name] : '',
  );
  return { serial_number: serial_number ?? '', order_id: order_id ?? '', work_order: work_order ?? '' };
}

/** Whether a run contains every word that is searched for, wherever it stands on its line. */
export function matches(run: RunPublic, search: string): boolean {
  const wanted = search.toLocaleLowerCase().split(/\s+/).filter(Boolean);
  if (wanted.length === 0) return true;
  const text = textOf(run).toLocaleLowerCase();
  return wanted.every((word) => text.includes(word));
}

function textOf(run: RunPublic): string {
  const people = [run.requested_by, run.released_by, run.accepted_by].map((who) => (who ? nameOf(who) : ''));
  const when = moment(run.ended_at ?? run.requested_at);
  const reason = run.reason ? say(run.reason) : '';
  const day = (run.ended_at ?? run.requested_at).slice(0, 10);
  const state = words.value.states[run.state];
  return [
    run.run,
    run.payload,
    state,
    when,
    day,
    reason,
    ...people,
    ...Object.values(identifiersOf(run)),
  ].join(' ');
}
