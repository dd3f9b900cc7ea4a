import type { Zone, ZonePlace } from '../api';
import { Press } from '../ui/press';
import { words } from '../words';
import { alike, placeOf, type StandingShape, sizeOf } from './shapes';
import { putZoneBack } from './shown-cell';

interface Props {
  zone: Zone;
  place: ZonePlace;
}

/** Buttons that put a zone back: to how it was before, and to how the cell's file has it. */
export function ZoneBack({ zone, place }: Props) {
  const said = words.value.cells;
  const { previous, in_file } = place;
  const now = zone.shape;
  return (
    <div class="zone-back">
      {previous && !alike(previous, now) && (
        <Press act={() => putZoneBack(place, 'before')}>
          <span>
            <span aria-hidden="true">↶</span> {said.undo(zone.name)}
            <small>{whatDiffers(previous, now)}</small>
          </span>
        </Press>
      )}
      {in_file && !alike(in_file, now) && !(previous && alike(in_file, previous)) && (
        <Press act={() => putZoneBack(place, 'file')}>
          <span>
            {said.asInFile(zone.name)}
            <small>{whatDiffers(in_file, now)}</small>
          </span>
        </Press>
      )}
    </div>
  );
}

/** Where it would be, and how large where that changes too. */
function whatDiffers(then: StandingShape, now: StandingShape): string {
  const sizes = sizeOf(then);
  return sizes === sizeOf(now) ? placeOf(then) : `${sizes}, ${placeOf(then)}`;
}
