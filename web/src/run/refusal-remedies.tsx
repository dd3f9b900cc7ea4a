import type { RunPublic } from '../api';
import { Press } from '../ui/press';
import { go } from '../ui/route';
import { words } from '../words';
import { takeOrder } from './order';
import { type Remedy, remediesFor } from './refusal';
import { goToField } from './setup-page';

/** Buttons that lead to what can be changed, with what the run was asked for in the fields. */
export function RefusalRemedies({ run }: { run: RunPublic }) {
  const said = words.value.refusal;
  const remedies = remediesFor(run);
  if (remedies.length === 0) return null;
  return (
    <section class="remedies">
      <h2>{said.change}</h2>
      <div>
        {remedies.map((remedy) => (
          <Press key={remedy} act={() => lead(remedy, run)}>
            {said.fields[remedy]}
          </Press>
        ))}
      </div>
    </section>
  );
}

function lead(remedy: Remedy, { cell, order }: RunPublic): void {
  if (remedy === 'home' || remedy === 'zone') {
    go('cells', cell);
    return;
  }
  takeOrder(order);
  goToField(remedy);
}
