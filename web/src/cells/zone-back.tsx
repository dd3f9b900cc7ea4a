import type { Pose, Zone, ZonePlace } from '../api';
import { Press } from '../ui/press';
import { words } from '../words';
import { spotOf } from './shapes';
import { putZoneBack } from './shown-cell';

interface Props {
  zone: Zone;
  place: ZonePlace;
}

/** Buttons that put a zone back: to where it was before, and to where the cell's file has it. */
export function ZoneBack({ zone, place }: Props) {
  const said = words.value.cells;
  const { previous, in_file } = place;
  const now = zone.shape.pose;
  return (
    <div class="zone-back">
      {!alike(previous, now) && (
        <Press act={() => putZoneBack(place, 'before')}>
          <span>
            <span aria-hidden="true">↶</span> {said.undo(zone.name)}
            <small>{spotOf(previous.xyz_m ?? [0, 0, 0])}</small>
          </span>
        </Press>
      )}
      {!alike(in_file, now) && !alike(in_file, previous) && (
        <Press act={() => putZoneBack(place, 'file')}>
          <span>
            {said.asInFile(zone.name)}
            <small>{spotOf(in_file.xyz_m ?? [0, 0, 0])}</small>
          </span>
        </Press>
      )}
    </div>
  );
}

function alike(one: Pose | undefined, other: Pose | undefined): boolean {
  const numbers = (pose: Pose | undefined) => [
    ...(pose?.xyz_m ?? [0, 0, 0]),
    ...(pose?.rpy_rad ?? [0, 0, 0]),
  ];
  const others = numbers(other);
  return numbers(one).every((value, k) => value === others[k]);
}
