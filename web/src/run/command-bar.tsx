import { AlarmBand } from '../alarms/alarm-band';
import { session } from '../session/session';
import { lost } from '../ui/connection';
import { NoticeList } from '../ui/notice-list';
import { Press } from '../ui/press';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { AskForControl, ControlRequest } from './control-request';
import { HoldButtons } from './hold-buttons';
import { stopRobot } from './now';
import { current } from './run';
import { isOver } from './runs';

/** How to stop and to hold, what comes next, and what can be done: at the lower edge of every page. */
export function CommandBar({ screen }: { screen: Screen }) {
  const said = words.value.bar;
  const run = current.value;
  const signedIn = Boolean(session.value);
  const stoppable = run !== null && !isOver(run) && run.commands.includes('stop') && signedIn;
  return (
    <footer class="command-bar">
      <div class="told-above">
        <NoticeList />
        {signedIn && <AlarmBand />}
        {signedIn && !lost.value && <ControlRequest />}
      </div>
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
        {signedIn && !lost.value && <AskForControl />}
        {screen.Actions && <screen.Actions />}
      </div>
    </footer>
  );
}
