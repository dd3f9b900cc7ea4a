import type { JobStatus } from '../api';
import { words } from '../words';
import type { Message } from '../words/catalogue';
import { Told } from './told';
import { number } from './units';

interface Props {
  title: string;
  job: { state: JobStatus; progress: number; reason: Message | null };
}

/** How far a job is, or why it came to nothing. */
export function JobProgress({ title, job: { state, progress, reason } }: Props) {
  const said = words.value.gap.jobs[state];
  const ended = state === 'failed' || state === 'cancelled';
  return (
    <section class="job-progress">
      <h2>{title}</h2>
      {!ended && <progress max={1} value={progress} aria-label={title} />}
      <p role="status" class={state === 'failed' ? 'flaw hint' : undefined}>
        <b>{said}</b> {state === 'running' && progress > 0 && `${number(100 * progress, 0)} %`}
      </p>
      {reason && <Told message={reason} />}
    </section>
  );
}
