import type { DiagnosisPublic } from '../api';
import { kept, oneOf } from '../ui/kept';
import { words } from '../words';
import { Also } from './also';
import { overlay } from './diagnoses';
import { Findings } from './findings';
import { HowFar } from './how-far';
import { OverlayPlots } from './overlay-plots';
import { PayloadChange } from './payload-change';
import { Summary } from './summary';
import { Where } from './where';
import { Which } from './which';

interface Props {
  diagnosis: NonNullable<DiagnosisPublic['result']>;
  /** What a file of a plot is called, without what it shows. */
  file: readonly (string | null)[];
  when: string;
}

/** An engineer who has unfolded it once finds it unfolded the next time on this screen. */
const unfolded = kept('evidence', 'no', oneOf(['no', 'yes'] as const));

/** What the verdict stands on, for an engineer. */
export function Evidence({ diagnosis, file, when }: Props) {
  return (
    <details
      class="evidence"
      open={unfolded.value === 'yes'}
      onToggle={({ currentTarget }) => {
        unfolded.value = currentTarget.open ? 'yes' : 'no';
      }}
    >
      <summary>{words.value.gap.evidence}</summary>
      <Summary diagnosis={diagnosis} />
      <Also also={diagnosis.also ?? []} />
      {diagnosis.where && <Where where={diagnosis.where} />}
      <Which diagnosis={diagnosis} />
      {overlay.value && <OverlayPlots overlay={overlay.value} file={file} when={when} />}
      <HowFar diagnosis={diagnosis} />
      {diagnosis.payload && <PayloadChange payload={diagnosis.payload} />}
      <Findings diagnosis={diagnosis} />
    </details>
  );
}
