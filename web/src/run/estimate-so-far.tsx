import { Measured } from '../ui/measured';
import { words } from '../words';
import { batch } from './live';

const AXES = ['x', 'y', 'z'] as const;

/** Mass and centre of mass as they are known now; their intervals close in. */
export function EstimateSoFar() {
  const said = words.value.running;
  const phi = batch.value?.phi ?? [];
  const std = batch.value?.phi_std ?? [];
  const [mass, sigma] = [phi[0] ?? null, std[0] ?? null];
  if (mass === null) {
    return (
      <section class="tile estimate-so-far">
        <h2>{said.estimate}</h2>
        <p>{said.notYet}</p>
      </section>
    );
  }
  return (
    <section class="tile estimate-so-far">
      <h2>{said.estimate}</h2>
      <dl>
        <dt class="whole">{said.mass}</dt>
        <dd class="whole">
          <Measured quantity="mass" value={mass} std={sigma} reason={said.notYet} />
        </dd>
        <dt class="whole">{said.com}</dt>
        {AXES.map((axis, k) => (
          <Coordinate key={axis} axis={axis} mass={mass} sigma={sigma} moment={phi[k + 1]} std={std[k + 1]} />
        ))}
      </dl>
    </section>
  );
}

interface CoordinateProps {
  axis: string;
  mass: number;
  sigma: number | null;
  /** First moment along the axis, kg m, and its standard uncertainty. */
  moment: number | null | undefined;
  std: number | null | undefined;
}

/** One coordinate of the centre of mass: first moment over mass, their uncertainties taken as independent. */
function Coordinate({ axis, mass, sigma, moment, std }: CoordinateProps) {
  const said = words.value.running;
  const value = moment == null ? null : moment / mass;
  const spread =
    value !== null && std != null && sigma !== null ? Math.hypot(std, value * sigma) / mass : null;
  return (
    <>
      <dt>{axis}</dt>
      <dd>
        <Measured quantity="length" value={value} std={spread} reason={said.notYet} />
      </dd>
    </>
  );
}
