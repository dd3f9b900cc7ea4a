import type { Screen } from '../ui/screen';
import { words } from '../words';
import { EstimateSoFar } from './estimate-so-far';
import { NearestNow } from './nearest-now';
import { newest, run } from './run';
import { RunProgress } from './run-progress';
import { MassPlot, WrenchPlot } from './wrench-plots';

function Running() {
  return (
    <>
      <RunProgress />
      <div class="plots">
        <WrenchPlot part="force" />
        <WrenchPlot part="torque" />
      </div>
      <div class="figures">
        <NearestNow />
        <EstimateSoFar />
        <MassPlot />
      </div>
    </>
  );
}

function next(): string {
  const said = words.value.running;
  switch (run.value?.state) {
    case 'Held':
    case 'Holding':
      return words.value.held.next;
    case 'Suspending':
    case 'Suspended':
      return blocked() ?? said.suspendedNext;
    case 'Completing':
      return said.estimatingNext;
    case 'Stopping':
    case 'Aborting':
      return said.endingNext;
    default:
      return said.next;
  }
}

/** What the robot waits for, where the service knows it. */
function blocked(): string | null {
  const waits = newest('waiting_for_zone');
  return waits?.in_the_way
    ? `${words.value.running.waitsFor(waits.in_the_way)} ${words.value.running.suspendedNext}`
    : null;
}

export const running: Screen = { Page: Running, next };
