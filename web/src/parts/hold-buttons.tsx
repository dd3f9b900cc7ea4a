import { mine } from '../stores/control';
import { current } from '../stores/run';
import { commandRun } from '../stores/runs';
import { may } from '../stores/session';
import { words } from '../words';
import { Press } from './press';

/** Holds the run that has the cell, and lets it go on: for whoever is in control, on every page. */
export function HoldButtons() {
  const said = words.value.bar;
  const run = current.value;
  if (run === null || !mine.value || !may('operator')) return null;
  return (
    <>
      {run.commands.includes('hold') && (
        <Press kind="move" act={() => commandRun(run.run, 'hold')}>
          <span aria-hidden="true">❚❚</span> {said.hold}
        </Press>
      )}
      {run.commands.includes('resume') && (
        <Press kind="start" act={() => commandRun(run.run, 'resume')}>
          <b>
            <span aria-hidden="true">▶</span> {said.resume}
          </b>
        </Press>
      )}
    </>
  );
}
