import { secondsUntil } from '../ui/connection';
import { clock } from '../ui/units';
import { words } from '../words';
import { latenessSaid } from './lateness';
import { run } from './run';

/** Why a robot on hold stands, where something was late, and for how long it still waits. */
export function HeldNotice() {
  const said = words.value.held;
  const shown = run.value;
  if (shown === null || (shown.state !== 'Held' && shown.state !== 'Holding')) return null;
  const late = latenessSaid(shown);
  if (late === null && shown.ends_at === null) return null;
  return (
    <div class="abnormal held-notice" role="status">
      <span aria-hidden="true">▲</span>
      <p>
        {late && <b>{late}</b>} {shown.ends_at !== null && said.waits(clock(secondsUntil(shown.ends_at)))}
      </p>
    </div>
  );
}
