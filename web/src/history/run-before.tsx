import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { ResultPublic } from '../api';
import { significance } from '../run/parameter-table';
import { attempt } from '../ui/notice';
import { to } from '../ui/route';
import { moment, percent, spelt } from '../ui/units';
import { words } from '../words';
import { type Compared, compare, runBefore } from './comparison';

/** Whether a result differs from the run before it with the same tool. */
export function RunBefore({ answer }: { answer: ResultPublic }) {
  const said = words.value.comparison;
  const found = useSignal<Compared | null>(null);
  useEffect(() => {
    void attempt(async () => {
      const before = await runBefore(answer);
      found.value = before === null ? null : await compare(before, answer.run);
    });
  }, [answer, found]);
  if (found.value === null) return null;
  const { runs, answer: compared } = found.value;
  const { chance, differ, parameters } = compared.comparison;
  const mass = parameters.find((each) => each.name === 'm');
  return (
    <section>
      <h2>{said.earlier}</h2>
      <p>
        <b>{differ ? `≠ ${said.differ}` : `= ${said.agree}`}</b>
      </p>
      <p class="hint">
        {said.first(moment(runs[0].ended_at ?? runs[0].requested_at))}.
        {chance !== null && ` ${said.chance(percent(chance))}.`}
      </p>
      {mass && (
        <p>
          {words.value.result.mass}: {spelt('mass', mass.value, mass.std)},{' '}
          {significance({ ...mass, reference: 0 })}
        </p>
      )}
      <a class="download" href={to('history', runs[0].run, runs[1].run)}>
        {said.whole}
      </a>
    </section>
  );
}
