import type { PhaseStarted } from '../api';
import { MessageText } from '../ui/message-text';
import { clock } from '../ui/units';
import { words } from '../words';
import { HeldNotice } from './held-notice';
import { batch } from './live';
import { newest, run } from './run';

/** What the robot does, how far it has come, how long it still takes. */
export function RunProgress() {
  const said = words.value.running;
  const phase = newest('phase_started');
  const reached = newest('target_reached');
  const progress = batch.value?.progress ?? run.value?.progress ?? 0;
  const left_s = batch.value?.eta_s ?? run.value?.eta_s ?? null;
  return (
    <section class="run-progress">
      <div class="phase">
        <h1>{phase === null ? said.begins : inWords(phase)}</h1>
        {phase && <span>{said.step(phase.step, phase.steps)}</span>}
        {left_s !== null && (
          <b>
            {clock(left_s)} {said.left}
          </b>
        )}
      </div>
      <progress max={1} value={progress} aria-label={words.value.states.Execute} />
      {reached && (
        <p class="hint">
          <MessageText message={reached.message} />
        </p>
      )}
      <HeldNotice />
    </section>
  );
}

/** `transfer` toward x+, `hold:x+`, `rotate:x`: as a person says it. */
function inWords({ phase, toward }: PhaseStarted): string {
  const said = words.value.running;
  const [kind, where = ''] = phase.split(':');
  if (kind === 'rotate') return said.turning(where);
  if (kind === 'hold') return said.standing(where);
  return toward === 'home' ? said.movingHome : said.moving(toward);
}
