import { NumberField } from '../ui/number-field';
import { scaleOf } from '../ui/units';
import { words } from '../words';
import { mass, mass_kg, payload, size, size_m } from './order';

const AXES = ['x', 'y', 'z'] as const;

/** Bounding box and mass of the tool, in the chosen units. */
export function ToolFields() {
  const said = words.value.setup;
  const known = payload.value !== null; // what is typed before would be overwritten by what the tool puts into the fields
  const badBox = known && size_m.value.includes(null);
  const badMass = known && mass_kg.value === null;
  return (
    <section class="tool-fields">
      <fieldset id="field-box" disabled={!known}>
        <legend>
          {said.box}, {scaleOf('length').unit}
        </legend>
        <div class="three">
          {AXES.map((axis, k) => (
            <NumberField
              key={axis}
              label={axis}
              text={size.value[k] ?? ''}
              flaw={known && size_m.value[k] === null}
              change={(text) => {
                size.value = size.value.with(k, text) as [string, string, string];
              }}
            />
          ))}
        </div>
        <p class={badBox ? 'hint flaw' : 'hint'}>{badBox ? words.value.refusal.badBox : said.boxHint}</p>
      </fieldset>
      <fieldset id="field-mass" disabled={!known}>
        <legend>
          {said.mass}, {scaleOf('mass').unit}
        </legend>
        <NumberField
          label={said.mass}
          hidden
          text={mass.value}
          flaw={badMass}
          change={(text) => {
            mass.value = text;
          }}
        />
        <p class={badMass ? 'hint flaw' : 'hint'}>{badMass ? said.badMass : said.massHint}</p>
      </fieldset>
    </section>
  );
}
