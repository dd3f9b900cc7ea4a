import { Reserved } from '../ui/reserved';
import { go } from '../ui/route';
import { diagnoseRun } from './diagnoses';

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
