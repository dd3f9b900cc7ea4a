import { mine, takeControl } from '../stores/control';
import { current } from '../stores/run';
import { commandRun } from '../stores/runs';
import { may } from '../stores/session';
import { words } from '../words';
import { Press } from './press';

/** What may be asked of the run now, beside stopping it. */
export function CommandButtons() {
  const said = words.value.bar;
  const run = current.value;
  if (run === null || !may('operator')) return null;
  const offered = (command: string) => run.commands.includes(command);
  return (
    <>
      {offered('clear') && (
        <Press
          kind="move"
          act={async () => {
            if (!mine.value) await takeControl(run.cell);
            await commandRun(run.run, 'clear');
          }}
        >
          <span aria-hidden="true">✓</span> {said.clear}
        </Press>
      )}
      {offered('hold') && mine.value && (
        <Press kind="move" act={() => commandRun(run.run, 'hold')}>
          <span aria-hidden="true">❚❚</span> {said.hold}
        </Press>
      )}
      {offered('resume') && mine.value && (
        <Press kind="start" act={() => commandRun(run.run, 'resume')}>
          <b>
            <span aria-hidden="true">▶</span> {said.resume}
          </b>
        </Press>
      )}
    </>
  );
}
