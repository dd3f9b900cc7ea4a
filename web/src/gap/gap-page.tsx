import type { DiagnosisPublic } from '../api';
import { chosenCell } from '../cells/cells';
import { isOver, runs } from '../run/runs';
import { NothingYet } from '../ui/nothing-yet';
import { route, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { moment } from '../ui/units';
import { words } from '../words';
import { DiagnoseRun } from './diagnose-run';
import { diagnoses } from './diagnoses';
import { diagnosisScreen } from './diagnosis-page';
import { effectName } from './effect-values';
import { InstructionMark } from './instruction-mark';
import { RecordingUpload } from './recording-upload';
import { TwinEntries } from './twin-entries';
import { subjectOf } from './verdict';

/** So many runs are listed. */
const LISTED = 6;

function Gap() {
  const said = words.value.gap;
  return (
    <div class="page gap">
      <h1>{said.title}</h1>
      <div>
        <Runs />
        <section>
          <h2>{said.ofLog}</h2>
          <p class="hint">{said.ofLogHint}</p>
          <p>
            <a class="download" href={to('import')}>
              {said.importLog}
            </a>
          </p>
        </section>
        <RecordingUpload />
      </div>
      <div>
        <Diagnoses />
        <TwinEntries cell={chosenCell.value} />
        <section>
          <h2>{said.blindTrials}</h2>
          <p class="hint">{said.blindHint}</p>
          <p>
            <a class="download" href={to('trials')}>
              {said.blindTrials}
            </a>
          </p>
        </section>
      </div>
    </div>
  );
}

/** The runs that moved and are over; each has a recording. */
function Runs() {
  const said = words.value.gap;
  const recorded = (runs.value ?? []).filter((run) => run.released && isOver(run)).slice(0, LISTED);
  return (
    <section>
      <h2>{said.ofRun}</h2>
      {recorded.length === 0 && (
        <NothingYet href={to()} act={words.value.setup.begin}>
          {said.noRuns}
        </NothingYet>
      )}
      <ul class="rows">
        {recorded.map(({ run, payload, requested_at, state }) => (
          <li key={run} id={run}>
            <span>
              <b>{moment(requested_at)}</b>
              <small>
                {payload} · {words.value.states[state]}
              </small>
            </span>
            <DiagnoseRun run={run} label={said.diagnose} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Diagnoses() {
  const said = words.value.gap;
  const all = diagnoses.value ?? [];
  return (
    <section>
      <h2>{said.done}</h2>
      {diagnoses.value !== null && all.length === 0 && <NothingYet>{said.none}</NothingYet>}
      <ul class="rows">
        {all.map((each) => {
          const { diagnosis, state, instruction } = each;
          return (
            <li key={diagnosis}>
              <span>
                <b>{instruction ? <InstructionMark instruction={instruction} /> : said.jobs[state]}</b>
                {names(each) && each.named && <p>{effectName(each.named)}</p>}
                <small>{subjectOf(each)}</small>
              </span>
              <a class="download" href={to('gap', diagnosis)}>
                {said.open}
              </a>
            </li>
          );
        })}
      </ul>
      {all.length > 1 && (
        <p>
          <a class="download" href={to('timeline')}>
            {words.value.history.effects}
          </a>
        </p>
      )}
    </section>
  );
}

/** Whether its verdict names a cause, or several that are open. */
function names({ verdict }: DiagnosisPublic): boolean {
  return verdict === 'explained' || verdict === 'ambiguous';
}

const begin: Screen = { Page: Gap, next: () => words.value.gap.next };

export function gapScreen(): Screen {
  return route.value[1] === undefined ? begin : diagnosisScreen;
}
