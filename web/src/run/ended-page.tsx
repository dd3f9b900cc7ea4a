import { may } from '../session/session';
import { addressOf } from '../ui/client';
import { Press } from '../ui/press';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { StateMark } from '../ui/state-mark';
import { Told } from '../ui/told';
import { words } from '../words';
import { holder, mine, takeControl } from './control';
import { latenessSaid } from './lateness';
import { ProposedBy } from './proposed-by';
import { refusalSaid } from './refusal';
import { RefusalRemedies } from './refusal-remedies';
import { run } from './run';
import { commandRun, continueRun } from './runs';

type End = 'stopped' | 'refused' | 'cancelled' | 'aborted';

/** How a run ended that did not come through. */
function endOf(): End {
  if (run.value?.state !== 'Stopped') return 'aborted';
  if (run.value.reason_kind === 'cancelled') return 'cancelled';
  return run.value.outcome === 'refused' ? 'refused' : 'stopped';
}

function Ended() {
  const said = words.value.ended;
  const shown = run.value;
  if (shown === null) return null;
  const end = endOf();
  const sentence = shown.reason && refusalSaid(shown.reason);
  return (
    <section class={`verdict verdict-${end}`}>
      <StateMark state={shown.state} />
      <h1>{end === 'cancelled' ? words.value.refusal.cancelled : said[end]}</h1>
      <ProposedBy />
      {shown.reason && <Told message={shown.reason} said={latenessSaid(shown) ?? sentence} />}
      {shown.in_the_way && (
        <p class="in-the-way">
          <span aria-hidden="true">▲</span> {said.inTheWay}: <b>{shown.in_the_way}</b>
        </p>
      )}
      {end === 'refused' && <RefusalRemedies run={shown} />}
      {sentence && shown.reason && (
        <details class="others">
          <summary>{words.value.refusal.details}</summary>
          <Told message={shown.reason} />
        </details>
      )}
      {shown.released && (
        <p>
          {shown.may_continue && words.value.continuing.finished(shown.finished_steps, shown.steps)}{' '}
          {said.samples}{' '}
          <a class="download" href={addressOf('/api/runs/{run}/recording', { run: shown.run })} download>
            {words.value.result.recording}
          </a>
        </p>
      )}
    </section>
  );
}

function Actions() {
  if (run.value?.state !== 'Stopped') return <ClearButton />;
  const continues = mayContinue();
  return (
    <>
      {continues && <ContinueButton />}
      <Press kind={continues ? 'plain' : 'primary'} act={() => go()}>
        {words.value.ended.again}
      </Press>
    </>
  );
}

function mayContinue(): boolean {
  return Boolean(run.value?.may_continue) && may('operator', 'mes');
}

/** The rest of the run as a new one, which is planned, shown and released like any other. */
function ContinueButton() {
  const ended = run.value;
  if (ended === null) return null;
  return (
    <Press
      kind="primary"
      act={async () => {
        if (may('operator') && !mine.value && holder.value === null) await takeControl(ended.cell);
        go('runs', (await continueRun(ended.run)).run);
      }}
    >
      {words.value.continuing.act}
    </Press>
  );
}

/** An aborted run is cleared where one reads why it was aborted. */
function ClearButton() {
  const shown = run.value;
  if (!shown?.commands.includes('clear') || !may('operator')) return null;
  return (
    <Press
      kind="move"
      act={async () => {
        if (!mine.value) await takeControl(shown.cell);
        await commandRun(shown.run, 'clear');
      }}
    >
      <span aria-hidden="true">✓</span> {words.value.bar.clear}
    </Press>
  );
}

function next(): string {
  const said = words.value.ended;
  if (mayContinue()) {
    const { next, afterClear } = words.value.continuing;
    return run.value?.state === 'Stopped' ? next : afterClear;
  }
  if (run.value?.reason_kind === 'plan-disputed') return said.disputedNext;
  return {
    stopped: said.stoppedNext,
    refused: said.refusedNext,
    cancelled: words.value.refusal.cancelledNext,
    aborted: said.abortedNext,
  }[endOf()];
}

export const ended: Screen = { Page: Ended, Actions, next };
