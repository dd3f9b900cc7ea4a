import { Facts } from '../ui/facts';
import { nameOf } from '../ui/names';
import { moment } from '../ui/units';
import { words } from '../words';
import { result, run } from './run';

/** What a printed result has to say of itself: when, which run and order, who answers for it, made by what. */
export function RunRecord() {
  const said = words.value.record;
  const shown = run.value;
  if (shown === null) return null;
  const accepted = shown.accepted_by === null ? said.notAccepted : nameOf(shown.accepted_by);
  const facts: [name: string, value: string | null | undefined, note?: string | null][] = [
    [said.date, moment(shown.ended_at ?? shown.requested_at)],
    [said.run, shown.run],
    [said.order, shown.order_id],
    [said.workOrder, shown.work_order],
    [said.serialNumber, shown.serial_number],
    [said.releasedBy, shown.released_by && nameOf(shown.released_by)],
    [said.acceptedBy, accepted, shown.accepted_at && moment(shown.accepted_at)],
    [said.cell, shown.cell],
    [said.software, result.value?.version && `Heft ${result.value.version}`],
    [said.plan, shown.plan_sha256],
  ];
  return (
    <section class="record">
      <h2>{said.title}</h2>
      <Facts facts={facts.flatMap(([name, value, note]) => (value ? [{ name, value, note }] : []))} />
    </section>
  );
}
