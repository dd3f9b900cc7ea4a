import type { RunPublic } from '../api';
import { notThere } from '../ui/not-there-page';
import { Reading } from '../ui/reading';
import { runInRoute } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { ended } from './ended-page';
import { PathPlayer } from './path-player';
import { plan } from './plan';
import { planning } from './planning-page';
import { preview } from './preview-page';
import { result } from './result-page';
import { run } from './run';
import { running } from './running-page';
import { Viewer } from './viewer';

const reading: Screen = { Page: Reading, next: () => words.value.planning.next };

/** Those whose picture of the cell stays the same, camera and all, while the run goes from one to the next; by what their parts are laid out. */
const WITH_PICTURE = new Map([
  [planning, 'planning'],
  [preview, 'preview'],
  [running, 'running'],
  [ended, 'ended'],
]);

const BY_STATE: Record<RunPublic['state'], Screen> = {
  Resetting: planning,
  Idle: preview,
  Starting: running,
  Execute: running,
  Holding: running,
  Held: running,
  Unholding: running,
  Suspending: running,
  Suspended: running,
  Unsuspending: running,
  Completing: running,
  Stopping: running,
  Aborting: running,
  Complete: result,
  Stopped: ended,
  Aborted: ended,
  Clearing: ended,
};

/** What a run shows depends on what it is at. */
export function runScreen(): Screen {
  if (runInRoute.value === null) return notThere;
  if (run.value === null) return reading;
  const shown = BY_STATE[run.value.state];
  return WITH_PICTURE.has(shown) ? { ...shown, Page: WithPicture } : shown;
}

function WithPicture() {
  if (run.value === null) return null;
  const shown = BY_STATE[run.value.state];
  return (
    <div class={`page with-picture ${WITH_PICTURE.get(shown)}`}>
      <Viewer key="picture" cell={run.value.cell}>
        {shown === preview && plan.value && <PathPlayer />}
      </Viewer>
      <shown.Page />
    </div>
  );
}
