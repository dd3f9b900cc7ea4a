import type { CellPublic } from '../api';
import { may } from '../session/session';
import { nameOf } from '../ui/names';
import { moment } from '../ui/units';
import { words } from '../words';
import { placeOf, sizeOf } from './shapes';
import { ZoneBack } from './zone-back';
import { ZoneMover } from './zone-mover';

/** Where each protected zone is now, since when and by whom; who may, says where it is instead, or puts it back. */
export function ZonePlaces({ shown }: { shown: CellPublic }) {
  const said = words.value.cells;
  const { cell, moved, in_the_way } = shown;
  const zones = cell?.zones ?? [];
  return (
    <section class="zone-places">
      <h2>{said.zones}</h2>
      {zones.length === 0 && <p>{said.none}</p>}
      {zones.map((zone) => {
        const place = moved.find((each) => each.zone === zone.name);
        return (
          <section class="tile" key={zone.name}>
            <h3>{zone.name}</h3>
            <p>
              {sizeOf(zone.shape)}, {said.centre(placeOf(zone.shape))}
            </p>
            <p class="hint">
              {place ? said.movedBy(nameOf(place.moved_by), moment(place.received_at)) : said.asFile}
            </p>
            {may('engineer', 'operator') && (
              <>
                {place && !in_the_way.includes(zone.name) && <ZoneBack zone={zone} place={place} />}
                {cell && <ZoneMover cell={cell} zone={zone} />}
              </>
            )}
          </section>
        );
      })}
    </section>
  );
}
