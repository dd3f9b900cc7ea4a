import { useSignal } from '@preact/signals';
import type { TwinEffect } from '../api';
import { Press } from '../ui/press';
import { Reserved } from '../ui/reserved';
import { moment, number } from '../ui/units';
import { words } from '../words';
import { EffectParameters } from './effect-parameters';
import { effectName } from './effect-values';
import { removeEffect, twin } from './twin';

/** What has been added to a cell's simulation. */
export function TwinEntries({ cell }: { cell: string }) {
  const said = words.value.gap;
  const effects = twin.value?.effects;
  if (effects === undefined) return null;
  return (
    <section class="twin">
      <h2>
        {said.twin}: {cell}
      </h2>
      <p class="hint">{effects.length === 0 ? said.twinEmpty : said.twinNote}</p>
      <ul>
        {effects.map((entry) => (
          <Entry key={entry.effect} cell={cell} entry={entry} />
        ))}
      </ul>
    </section>
  );
}

function Entry({ cell, entry }: { cell: string; entry: TwinEffect }) {
  const said = words.value.gap;
  const { effect, parameters, gap_before, gap_after, recording, added } = entry;
  return (
    <li>
      <b>{effectName(effect)}</b>
      <p>
        {said.gap}: {number(gap_before, 2)} → {number(gap_after, 2)}
      </p>
      <EffectParameters parameters={parameters} />
      <small>{said.of(recording, moment(added))}</small>
      <Removal cell={cell} effect={effect} />
    </li>
  );
}

/** Two taps: what is gone has to be found anew. */
function Removal({ cell, effect }: { cell: string; effect: string }) {
  const said = words.value.gap;
  const armed = useSignal(false);
  const arm = (to: boolean) => () => {
    armed.value = to;
  };
  if (!armed.value) {
    return (
      <Reserved roles={['engineer']} act={arm(true)}>
        {said.remove}
      </Reserved>
    );
  }
  return (
    <p class="removal">
      {said.removable}{' '}
      <Reserved roles={['engineer']} act={() => removeEffect(cell, effect)}>
        {said.reallyRemove}
      </Reserved>{' '}
      <Press act={arm(false)}>{said.keep}</Press>
    </p>
  );
}
