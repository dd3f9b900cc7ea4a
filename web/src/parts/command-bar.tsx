import { lost } from '../stores/connection';
import { notice } from '../stores/notice';
import { stopRobot } from '../stores/now';
import { current } from '../stores/run';
import { isOver } from '../stores/runs';
import { session } from '../stores/session';
import { words } from '../words';
import { HoldButtons } from './hold-buttons';
import { Press } from './press';
import type { Screen } from './screen';
import { Told } from './told';

/** How to stop and to hold, what comes next, and what can be done: at the lower edge of every page. */
export function CommandBar({ screen }: { screen: Screen }) {
  const said = words.value.bar;
  const run = current.value;
  const stoppable = run !== null && !isOver(run) && run.commands.includes('stop') && Boolean(session.value);
  return (
    <footer class="command-bar">
      {notice.value && (
        <div class="notice" role="alert">
          <span aria-hidden="true">▲</span>
          <Told {...notice.value} />
          <Press
            act={() => {
              notice.value = null;
            }}
          >
            {words.value.close}
          </Press>
        </div>
      )}
      {stoppable && !lost.value && (
        <Press kind="stop" act={() => stopRobot(run.cell)}>
          <span aria-hidden="true">■</span> {said.stop}
        </Press>
      )}
      <p class="next">
        <small>{said.next}</small>
        {screen.next()}
      </p>
      <div class="actions">
        {!lost.value && <HoldButtons />}
        {screen.Actions && <screen.Actions />}
      </div>
    </footer>
  );
}
