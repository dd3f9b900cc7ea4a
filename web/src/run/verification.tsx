import type { VerificationPart } from '../api';
import { Facts } from '../ui/facts';
import { number } from '../ui/units';
import { words } from '../words';

/** How well each turning is predicted by a fit to everything else; near 1 is as well as noise and uncertainty allow. */
export function Verification({ parts }: { parts: VerificationPart[] }) {
  const said = words.value.result;
  if (parts.length === 0) return null;
  return (
    <section>
      <h2>{said.unseen}</h2>
      <Facts
        facts={parts.map(({ phase, ratio }) => ({
          name: words.value.running.turning(phase.split(':')[1] ?? phase),
          value: said.ofExpected(number(ratio, 2)),
        }))}
      />
      <p class="hint">{said.unseenHint}</p>
    </section>
  );
}
