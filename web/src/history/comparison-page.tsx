import { effect, signal } from '@preact/signals';
import { session } from '../session/session';
import { sought } from '../ui/absent';
import { until } from '../ui/connection';
import { told } from '../ui/notice';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { go, route, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { moment, percent } from '../ui/units';
import { words } from '../words';
import { type Compared, compare } from './comparison';
import { comparedOffsets, comparedPayload, mostClearly } from './comparison-rows';
import { ComparisonTable } from './comparison-table';

/** The two runs that the address names; null until they are known. */
const shown = signal<Compared | null>(null);

effect(() => {
  const [page, one, other] = route.value;
  shown.value = null;
  if (!session.value || page !== 'history' || one === undefined || other === undefined) return undefined;
  return until(async () => {
    const found = await sought(compare(one, other)).catch(told);
    if (route.value[1] === one && route.value[2] === other) shown.value = found;
  });
});

function Comparison() {
  const said = words.value.comparison;
  const found = shown.value;
  if (found === null) return <Reading />;
  const { chance, differ } = found.answer.comparison;
  const when = found.runs.map((run) => moment(run.ended_at ?? run.requested_at));
  return (
    <div class="page comparison">
      <h1>{said.title}</h1>
      <section class="verdict">
        <p class="verdict-words">{differ ? `≠ ${said.differ}` : `= ${said.agree}`}</p>
        <p>{chance === null ? said.nothingInCommon : said.chance(percent(chance))}</p>
        {differ && <p>{mostClearly(found)}</p>}
        {found.answer.frame === 'flange' && <p>{said.flange}</p>}
        <p class="hint">
          {words.value.interval}, {words.value.result.frame}
        </p>
        <p class="downloads">
          {found.runs.map(({ run }, k) => (
            <a class="download" key={run} href={to('runs', run)}>
              {'AB'[k]}: {said.first(when[k] ?? '')}
            </a>
          ))}
          <a class="download" href={to('series', ...found.runs.map(({ run }) => run))}>
            {said.asSeries}
          </a>
        </p>
      </section>
      <ComparisonTable title={said.payload} rows={comparedPayload(found)} when={when} />
      <ComparisonTable title={said.offsets} rows={comparedOffsets(found)} when={when} />
    </div>
  );
}

function Actions() {
  return (
    <Press kind="primary" act={() => go('history')}>
      {words.value.comparison.back}
    </Press>
  );
}

export const comparison: Screen = { Page: Comparison, Actions, next: () => words.value.comparison.next };
