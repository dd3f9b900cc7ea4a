import { Fragment } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { RunPublic } from '../api';
import { session } from '../session/session';
import { lostSince_ms, now_ms } from '../ui/connection';
import { StateMark } from '../ui/state-mark';
import { clock, seconds, timeOfDay } from '../ui/units';
import { words } from '../words';
import { control, holder, mine } from './control';
import { robots } from './now';
import { current } from './run';
import { isOver } from './runs';

const MOVES = new Set<RunPublic['state']>([
  'Starting',
  'Execute',
  'Holding',
  'Unholding',
  'Suspending',
  'Suspended',
  'Unsuspending',
]);

/** Over the whole page while there is no connection: what was known last, what the robot does by itself, and that STOP does not work here. */
export function LostLayer() {
  const since_ms = lostSince_ms.value;
  return since_ms === null ? null : <Layer since_ms={since_ms} />;
}

function Layer({ since_ms }: { since_ms: number }) {
  const said = words.value.lost;
  const layer = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const shown = layer.current;
    shown?.showModal();
    return () => shown?.close(); // gives the focus back
  }, []);
  return (
    <dialog
      ref={layer}
      role="alertdialog"
      class="lost-layer"
      aria-labelledby="lost-title"
      aria-describedby="lost-robot"
      onCancel={(event) => event.preventDefault()}
    >
      <h1 id="lost-title" class="abnormal">
        <span aria-hidden="true">✕</span> {said.title}
      </h1>
      <p class="lost-since">{said.since(timeOfDay(since_ms), clock((now_ms.value - since_ms) / 1000))}</p>
      <LastKnown />
      <div id="lost-robot" class="lost-robot">
        <p>{whatTheRobotDoes()}</p>
        <p class="lost-stop">
          <b>{said.noStop}</b>
        </p>
      </div>
      <p class="hint">{said.again}</p>
    </dialog>
  );
}

/** Of the robot in front of this screen; before anybody has signed in, of every one that a run had. */
function LastKnown() {
  const said = words.value.lost;
  const run = current.value;
  const known = session.value ? (run === null ? [] : [run]) : (robots.value ?? []);
  return (
    <dl class="facts lost-known">
      {known.map(({ cell, state }) => (
        <Fragment key={cell}>
          <div>
            <dt>{said.cell}</dt>
            <dd>{cell}</dd>
          </div>
          <div>
            <dt>{said.state}</dt>
            <dd>{state && <StateMark state={state} />}</dd>
          </div>
        </Fragment>
      ))}
    </dl>
  );
}

/** Only a robot that this screen was in control of is known to stop; whoever else is in control may still be. */
function whatTheRobotDoes(): string {
  const said = words.value.lost;
  const run = current.value;
  if (!session.value || run === null || isOver(run)) return said.notKnown;
  if (!mine.value) return holder.value === null ? said.notKnown : said.others(holder.value);
  if (run.state === 'Held') return said.keepsPlace;
  return MOVES.has(run.state) ? said.stopsItself(seconds(control.value?.lease_s ?? 1)) : said.notKnown;
}
