import { to } from '../ui/route';
import { words } from '../words';
import { run } from './run';

/** Where a run comes from that makes the motion that a diagnosis proposes. */
export function ProposedBy() {
  const said = words.value.gap;
  const diagnosis = run.value?.diagnosis ?? null;
  if (diagnosis === null) return null;
  return (
    <p class="proposed-by">
      {said.isProposed}{' '}
      <a class="download" href={to('gap', diagnosis)}>
        {said.itsDiagnosis}
      </a>
    </p>
  );
}
