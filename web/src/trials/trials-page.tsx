import { nameOf } from '../ui/names';
import { NothingYet } from '../ui/nothing-yet';
import { Press } from '../ui/press';
import { Reserved } from '../ui/reserved';
import { go, route, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { moment } from '../ui/units';
import { words } from '../words';
import { trialScreen } from './trial-page';
import { beginTrials, trialsListed } from './trials';

/** So many are listed. */
const LISTED = 8;
const MANY = 10;

function Trials() {
  const said = words.value.gap;
  const all = (trialsListed.value ?? []).slice(0, LISTED);
  return (
    <div class="page trials">
      <section>
        <h1>{said.trials.title}</h1>
        <p>{said.trials.what}</p>
        <p>
          <Begin count={MANY} kind="plain">
            {said.trials.ten}
          </Begin>
        </p>
      </section>
      <section>
        <h2>{said.trials.all}</h2>
        {trialsListed.value !== null && all.length === 0 && <NothingYet>{said.trials.none}</NothingYet>}
        <ul class="rows">
          {all.map(({ trials, count, state, requested_by, requested_at }) => (
            <li key={trials}>
              <span>
                <b>
                  {said.trials.count(count)} · {said.jobs[state]}
                </b>
                <small>{said.by(nameOf(requested_by), moment(requested_at))}</small>
              </span>
              <a class="download" href={to('trials', trials)}>
                {said.open}
              </a>
            </li>
          ))}
        </ul>
      </section>
    </div>
  );
}

function Begin({ count, kind, children }: { count: number; kind: 'plain' | 'primary'; children: string }) {
  return (
    <Reserved
      kind={kind}
      roles={['engineer']}
      act={async () => go('trials', (await beginTrials(count)).trials)}
    >
      {children}
    </Reserved>
  );
}

function Actions() {
  const said = words.value.gap;
  return (
    <>
      <Begin count={1} kind="primary">
        {said.trials.one}
      </Begin>
      <Press act={() => go('gap')}>{said.back}</Press>
    </>
  );
}

const begin: Screen = { Page: Trials, Actions, next: () => words.value.gap.trials.next };

export function trialsScreen(): Screen {
  return route.value[1] === undefined ? begin : trialScreen;
}
