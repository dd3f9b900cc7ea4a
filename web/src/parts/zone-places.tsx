import { useSignal } from '@preact/signals';
import type { CellShown, Zone } from '../api';
import { centreOf, placeOf, sizeOf } from '../shapes';
import { nameOf } from '../stores/names';
import { may } from '../stores/session';
import { moveZone } from '../stores/shown-cell';
import { moment, NARROW_SPACE, number, scaleOf, typed } from '../units';
import { words } from '../words';
import { NumberField } from './number-field';
import { Press } from './press';

const AXES = ['x', 'y', 'z'] as const;

/** Where each protected zone is now, since when and by whom; who may, says where it is instead. */
export function ZonePlaces({ shown }: { shown: CellShown }) {
  const said = words.value.cells;
  const zones = shown.cell.zones ?? [];
  return (
    <section class="zone-places">
      <h2>{said.zones}</h2>
      {zones.length === 0 && <p>{said.none}</p>}
      {zones.map((zone) => (
        <section class="tile" key={zone.name}>
          <h3>{zone.name}</h3>
          <p>
            {sizeOf(zone.shape)}, {said.centre(placeOf(zone.shape))}
          </p>
          <p class="hint">{sinceWhen(zone, shown)}</p>
          {may('engineer', 'operator') && <Mover zone={zone} />}
        </section>
      ))}
    </section>
  );
}

function sinceWhen({ name }: Zone, { moved }: CellShown): string {
  const said = words.value.cells;
  const place = moved.find((each) => each.zone === name);
  return place === undefined ? said.asFile : said.movedBy(nameOf(place.moved_by), moment(place.measured_at));
}

/** Three fields for the centre of a zone; they follow the zone until somebody types. */
function Mover({ zone }: { zone: Zone }) {
  const said = words.value.cells;
  const texts = useSignal<(string | null)[]>([null, null, null]);
  const { factor, unit, places } = scaleOf('length');
  const there = centreOf(zone.shape).map((value) =>
    number(factor * value, places).replaceAll(NARROW_SPACE, ''),
  );
  const written = AXES.map((_, k) => texts.value[k] ?? there[k] ?? '');
  const [x = null, y = null, z = null] = written.map((text) => typed(text));
  const move = async (xyz: [number, number, number]) => {
    await moveZone(zone.name, xyz.map((value) => value / factor) as [number, number, number]);
    texts.value = [null, null, null];
  };
  return (
    <fieldset>
      <legend>
        {said.moveTo(zone.name)}, {unit}
      </legend>
      <div class="three">
        {AXES.map((axis, k) => (
          <NumberField
            key={axis}
            label={axis}
            signed
            text={written[k] ?? ''}
            flaw={typed(written[k] ?? '') === null}
            change={(text) => {
              texts.value = texts.value.with(k, text);
            }}
          />
        ))}
      </div>
      <p class="hint">{said.moveHint}</p>
      <Press
        disabled={x === null || y === null || z === null || texts.value.every((text) => text === null)}
        act={() => (x === null || y === null || z === null ? undefined : move([x, y, z]))}
      >
        {said.move}
      </Press>
    </fieldset>
  );
}
