import type { JobStatus } from '../api';
import { words } from '../words';
import { Told } from './told';
import { number } from './units';

interface Props {
  title: string;
  job: { state: JobStatus; progress: number; reason: string | null; reason_kind: string | null };
}

/** How far a job is, or why it came to nothing. */
export function JobProgress({ title, job: { state, progress, reason, reason_kind } }: Props) {
  const said = words.value.gap.jobs[state];
  const ended = state === 'failed' || state === 'cancelled';
  return (
    <section class="job-progress">
      <h2>{title}</h2>
      {!ended && <progress max={1} value={progress} aria-label={title} />}
      <p role="status" class={state === 'failed' ? 'flaw hint' : undefined}>
        <b>{said}</b> {state === 'running' && progress > 0 && `${number(100 * progress, 0)} %`}
      </p>
      {reason && <Told kind={reason_kind} english={reason} />}
    </section>
  );
}
