import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { OrderPublic, RunPublic } from '../api';
import { may } from '../session/session';
import { type Fact, Facts } from '../ui/facts';
import { nameOf } from '../ui/names';
import { NothingYet } from '../ui/nothing-yet';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { StateMark } from '../ui/state-mark';
import { moment } from '../ui/units';
import { words } from '../words';
import { cancelOrder, orders } from './orders';

const LONGEST_WHY = 200;

/** The queue of each cell: who sent what, what it waits for, what STOP would end, and how to take an order back. */
function Orders() {
  const said = words.value.orders;
  const all = orders.value ?? [];
  const cells = [...new Set(all.map(({ cell }) => cell))];
  return (
    <div class="page orders">
      <h1>{said.title}</h1>
      {orders.value?.length === 0 && (
        <NothingYet href={to()} act={words.value.setup.begin}>
          {said.none}
        </NothingYet>
      )}
      {cells.map((cell) => (
        <section key={cell}>
          <h2>{cell}</h2>
          <ol class="order-list">
            {all
              .filter((order) => order.cell === cell)
              .map((order) => (
                <Order key={order.run.run} {...order} />
              ))}
          </ol>
        </section>
      ))}
    </div>
  );
}

function Order({ cell, position, waits_for, ended_by_stop, run }: OrderPublic) {
  const said = words.value.orders;
  const cancelling = useSignal(false);
  const cancellable = (run.state === 'Resetting' || run.state === 'Idle') && may('operator', 'mes');
  return (
    <li class="tile order" data-run={run.run}>
      <div class="order-head">
        <b>{position === 0 ? said.first : said.position(position + 1)}</b>
        {position === 0 && <StateMark state={run.state} />}
      </div>
      <p class="order-waits">
        <b>{waits_for == null ? said.goesOn : said.waits[waits_for]}</b>{' '}
        {ended_by_stop ? said.endedByStop(cell) : said.keptByStop(cell)}
      </p>
      <Facts facts={factsOf(run)} />
      {cancelling.value ? (
        <Cancelling
          run={run.run}
          end={() => {
            cancelling.value = false;
          }}
        />
      ) : (
        <p class="order-answers">
          <a class="press" href={to('runs', run.run)}>
            {said.open}
          </a>
          {cancellable && (
            <Press
              act={() => {
                cancelling.value = true;
              }}
            >
              {said.cancel}
            </Press>
          )}
        </p>
      )}
    </li>
  );
}

/** Asks why, then takes the order back. */
function Cancelling({ run, end }: { run: string; end: () => void }) {
  const said = words.value.orders;
  const why = useSignal('');
  const form = useRef<HTMLDivElement>(null);
  useEffect(() => form.current?.scrollIntoView({ block: 'nearest' }), []);
  const cancel = async () => {
    await cancelOrder(run, why.value.trim());
    say(() => words.value.orders.cancelled, 'passes');
    end();
  };
  return (
    <div class="order-cancelling" ref={form}>
      <label class="field">
        <span>{said.why}</span>
        <input
          maxLength={LONGEST_WHY}
          autocomplete="off"
          onInput={({ currentTarget }) => {
            why.value = currentTarget.value;
          }}
        />
        <small class="hint">{said.whyHint}</small>
      </label>
      <p class="order-answers">
        <Press kind="primary" act={cancel}>
          {said.cancelNow}
        </Press>
        <Press act={end}>{said.keep}</Press>
      </p>
    </div>
  );
}

/** What the sender calls it, where they say so. */
interface Named {
  order_id?: string | null;
  work_order?: string | null;
  serial_number?: string | null;
}

function factsOf(run: RunPublic): Fact[] {
  const said = words.value.orders;
  const named = run as RunPublic & Named;
  const given: [string, string | null | undefined][] = [
    [said.orderId, named.order_id],
    [said.workOrder, named.work_order],
    [said.serialNumber, named.serial_number],
    [said.sender, senderOf(run.requested_by)],
    [said.sent, moment(run.requested_at)],
    [said.payload, run.order.empty ? words.value.setup.empty : run.payload],
  ];
  const facts = given.flatMap(([name, value]) => (value ? [{ name, value }] : []));
  const kind = run.diagnosis ? said.proposed : run.continues ? said.rest : null;
  return kind === null ? facts : [...facts, { name: said.title, value: kind }];
}

function senderOf(who: string): string {
  const machine = /^key:(.*)$/.exec(who);
  return machine ? words.value.orders.machine(machine[1] ?? '') : nameOf(who);
}

export const ordersScreen: Screen = { Page: Orders, next: () => words.value.orders.next };
