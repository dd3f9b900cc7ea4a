import { NumberField } from '../ui/number-field';
import { scaleOf } from '../ui/units';
import { words } from '../words';
import { mass, mass_kg, size, size_m } from './order';

const AXES = ['x', 'y', 'z'] as const;

/** Bounding box and mass of the tool, in the chosen units. */
export function ToolFields() {
  const said = words.value.setup;
  return (
    <section class="tool-fields">
      <fieldset>
        <legend>
          {said.box}, {scaleOf('length').unit}
        </legend>
        <div class="three">
          {AXES.map((axis, k) => (
            <NumberField
              key={axis}
              label={axis}
              text={size.value[k] ?? ''}
              flaw={size_m.value[k] === null}
              change={(text) => {
                size.value = size.value.with(k, text) as [string, string, string];
              }}
            />
          ))}
        </div>
        <p class="hint">{said.boxHint}</p>
      </fieldset>
      <fieldset>
        <legend>
          {said.mass}, {scaleOf('mass').unit}
        </legend>
        <NumberField
          label={said.mass}
          hidden
          text={mass.value}
          flaw={mass_kg.value === null}
          change={(text) => {
            mass.value = text;
          }}
        />
        <p class={mass_kg.value === null ? 'hint flaw' : 'hint'}>
          {mass_kg.value === null ? said.badMass : said.massHint}
        </p>
      </fieldset>
    </section>
  );
}
