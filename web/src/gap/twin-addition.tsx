import { JobProgress } from '../ui/job-progress';
import { isUnderWay } from '../ui/jobs';
import { Reserved } from '../ui/reserved';
import { words } from '../words';
import { effectName } from './effect-values';
import { addition, cancelAddition } from './twin';

/** How far the addition that was asked for here is, and what became of it. */
export function TwinAddition({ diagnosis }: { diagnosis: string }) {
  const said = words.value.gap;
  const asked = addition.value;
  if (asked === null || asked.diagnosis !== diagnosis) return null;
  const effect = effectName(asked.effect);
  if (asked.state === 'done') return <p role="status">✓ {said.added(effect)}</p>;
  if (!isUnderWay(asked)) return <JobProgress title={said.notAdded(effect)} job={asked} />;
  return (
    <>
      <JobProgress title={said.adding(effect)} job={asked} />
      <Reserved roles={['engineer']} act={() => cancelAddition(asked)}>
        {said.cancel}
      </Reserved>
    </>
  );
}
