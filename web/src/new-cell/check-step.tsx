import { Press } from '../ui/press';
import { made, STEPS, step } from './draft';
import { newCellWords } from './new-cell-words';
import { Findings, stepOfFinding } from './said';

/** All that is wrong or doubtful, each with the way to where it is changed. */
export function CheckStep() {
  const said = newCellWords.value;
  const findings = made.value?.findings ?? [];
  const wrong = findings.filter(({ severity }) => severity === 'wrong').length;
  return (
    <>
      <p role="status">
        {wrong === 0 && `✓ ${said.check.sound} `}
        {said.check.counts(wrong, findings.length - wrong)}
      </p>
      {STEPS.map((each) => {
        const here = findings.filter((finding) => stepOfFinding(finding) === each);
        if (here.length === 0) return null;
        return (
          <section class="stack" key={each}>
            <div class="row">
              <h3>{said.steps[each]}</h3>
              {each !== 'check' && (
                <Press
                  act={() => {
                    step.value = each;
                  }}
                >
                  {said.check.change}
                </Press>
              )}
            </div>
            <Findings findings={here} />
          </section>
        );
      })}
      <p class="hint">{said.check.after}</p>
    </>
  );
}
