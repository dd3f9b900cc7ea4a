import type { RunAnswer } from '../api';
import { Reading } from '../parts/reading';
import type { Screen } from '../parts/screen';
import { runInRoute } from '../route';
import { run } from '../stores/run';
import { words } from '../words';
import { ended } from './ended';
import { notThere } from './not-there';
import { planning } from './planning';
import { preview } from './preview';
import { result } from './result';
import { running } from './running';

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
