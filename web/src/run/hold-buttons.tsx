import type { RunPublic } from '../api';
import { may } from '../session/session';
import { Press } from '../ui/press';
import { words } from '../words';
import { control, holder, mine, takeControl } from './control';
import { answering } from './lease';
import { current } from './run';
import { commandRun } from './runs';

/** Holds the run that has the cell, for whoever is in control, and lets it go on: on every page. */
export function HoldButtons() {
  const run = current.value;
  if (run === null || !may('operator')) return null;
  const free = control.value !== null && holder.value === null;
  return (
    <>
      {mine.value && run.commands.includes('hold') && (
        <Press kind="move" act={() => commandRun(run.run, 'hold')}>
          <span aria-hidden="true">❚❚</span> {words.value.bar.hold}
        </Press>
      )}
      {(mine.value || free) && run.commands.includes('resume') && <Resume run={run} />}
    </>
  );
}

/** One deliberate tap; where nobody has control any more it takes control first. */
function Resume({ run }: { run: RunPublic }) {
  const said = words.value.held;
  const restoring = mine.value && !answering.value;
  const what = restoring ? said.restoring : mine.value ? said.goesOn : said.takesControl;
  return (
    <Press kind="start" disabled={restoring} act={() => resume(run)}>
      <b>
        <span aria-hidden="true">▶</span> {words.value.bar.resume}
      </b>
      <small>{what}</small>
    </Press>
  );
}

async function resume({ run, cell }: RunPublic): Promise<void> {
  if (!mine.value) await takeControl(cell);
  await commandRun(run, 'resume');
}
