import { go } from '../route';
import { diagnoseRun } from '../stores/diagnoses';
import { Reserved } from './reserved';

interface Props {
  run: string;
  label: string;
  kind?: 'plain' | 'primary';
}

/** Begins a diagnosis of a run and goes to it. */
export function DiagnoseRun({ run, label, kind = 'plain' }: Props) {
  return (
    <Reserved
      kind={kind}
      roles={['engineer', 'operator']}
      act={async () => go('gap', (await diagnoseRun(run)).diagnosis)}
    >
      {label}
    </Reserved>
  );
}
