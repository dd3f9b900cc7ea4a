import { cell } from '../cells/cells';
import { Measured } from '../ui/measured';
import { spelt } from '../ui/units';
import { words } from '../words';
import { batch } from './live';

/** How near the robot is to whatever stands around it, beside what the guard allows. */
export function NearestNow() {
  const said = words.value.running;
  const nearest = batch.value?.nearest ?? null;
  const limit = cell.value?.limits?.clearance_m ?? null;
  return (
    <section class="tile nearest-now">
      <h2>{said.nearest}</h2>
      {nearest === null ? <p>{said.notYet}</p> : <Measured quantity="length" value={nearest.distance_m} />}
      {nearest && <p>{said.nearestTo(nearest.second)}</p>}
      {limit !== null && <small>{said.limit(spelt('length', limit))}</small>}
    </section>
  );
}
