import type { DiagnosisPublic, Instruction } from '../api';
import { MessageText } from '../ui/message-text';
import { nameOf } from '../ui/names';
import { moment } from '../ui/units';
import { words } from '../words';
import { InstructionMark } from './instruction-mark';

interface Props {
  instruction: Instruction;
  shown: DiagnosisPublic;
}

/** The verdict for whoever stands at the robot: what to do in a sentence, how, and what besides. */
export function Verdict({ instruction, shown }: Props) {
  const said = words.value.gap;
  const { next, further = [] } = instruction;
  return (
    <section class="gap-verdict">
      <h1>
        <InstructionMark instruction={instruction} />
      </h1>
      <p class="sentence">
        <MessageText message={next} />
      </p>
      {further.length > 0 && (
        <>
          <h2>{said.besides}</h2>
          <ul class="further">
            {further.map((each) => (
              <li key={each.code}>
                <MessageText message={each} />
              </li>
            ))}
          </ul>
        </>
      )}
      <p class="hint">{subjectOf(shown)}</p>
    </section>
  );
}

/** What was diagnosed, in which cell, with which tool, when and for whom. */
export function subjectOf({ run, name, cell, tool, requested_by, requested_at }: DiagnosisPublic): string {
  const said = words.value.gap;
  const what = run === null ? (name ?? said.upload) : said.run(run);
  const by = said.by(nameOf(requested_by), moment(requested_at));
  return [what, cell, tool, by].filter(Boolean).join(' · ');
}
