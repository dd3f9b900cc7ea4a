import type { RunAnswer } from '../api';
import { notThere } from '../ui/not-there-page';
import { Reading } from '../ui/reading';
import { runInRoute } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { ended } from './ended-page';
import { planning } from './planning-page';
import { preview } from './preview-page';
import { result } from './result-page';
import { run } from './run';
import { running } from './running-page';

const reading: Screen = { Page: Reading, next: () => words.value.planning.next };

const BY_STATE: Record<RunAnswer['state'], Screen> = {
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
  return run.value === null ? reading : BY_STATE[run.value.state];
}
