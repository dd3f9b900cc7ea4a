import type { DiagnosisPublic } from '../api';
import { runs } from '../run/runs';
import { MessageText } from '../ui/message-text';
import { to } from '../ui/route';
import { StateMark } from '../ui/state-mark';
import { Told } from '../ui/told';
import { clock, number } from '../ui/units';
import { words } from '../words';
import { effectName } from './effect-values';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

interface Props {
  motion: NonNullable<Diagnosis['next_experiment']>;
  /** Whose motion it is. */
  diagnosis: string;
}

/** The motion that tells apart what is open and what it is predicted to do; it can be planned, shown and released like any run. */
export function NextMotion({ motion, diagnosis }: Props) {
  const said = words.value.gap;
  const { stops, splits, sigma_before, sigma_after, seconds, planned, refused } = motion;
  return (
    <section class="next-motion">
      <h2>{said.experiment}</h2>
      <p class="sentence">
        <MessageText message={motion.motion} />
      </p>
      <p>
        {splits.map((ids) => ids.map(effectName).join(' – ')).join('; ')}.{' '}
        {said.predicted(number(sigma_before, 1), number(sigma_after, 1))}{' '}
        {seconds > 0 && said.takes(clock(seconds))}
      </p>
      {stops.length > 0 && planned && <p>{said.isPlanned}</p>}
      {stops.length > 0 && !planned && (
        <>
          <p>{said.notPlanned}</p>
          {refused && <Told message={refused} />}
        </>
      )}
      {stops.length > 0 && planned && <p class="hint">{said.planMotionHint}</p>}
      <Made diagnosis={diagnosis} />
    </section>
  );
}

/** The runs that make this motion, so that nobody queues it twice unawares. */
function Made({ diagnosis }: { diagnosis: string }) {
  const made = runs.value?.filter((run) => run.diagnosis === diagnosis) ?? [];
  return (
    <>
      {made.map(({ run, state }) => (
        <p key={run}>
          <a class="download" href={to('runs', run)}>
            {words.value.gap.run(run)}
          </a>{' '}
          <StateMark state={state} />
        </p>
      ))}
    </>
  );
}
