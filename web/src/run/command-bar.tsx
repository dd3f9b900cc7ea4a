import { session } from '../session/session';
import { lost } from '../ui/connection';
import { messageOf, notice } from '../ui/notice';
import { Press } from '../ui/press';
import type { Screen } from '../ui/screen';
import { Told } from '../ui/told';
import { words } from '../words';
import { HoldButtons } from './hold-buttons';
import { stopRobot } from './now';
import { current } from './run';
import { isOver } from './runs';

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
          <Told message={messageOf(notice.value)} />
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
