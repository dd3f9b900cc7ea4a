import type { Zone } from '../api';
import { words } from '../words';
import type { Cell } from './cells';
import { footprint, type Point, type View } from './footprint';
import { centreOf } from './shapes';

const VIEWS: Record<'above' | 'side', View> = { above: [0, 1], side: [0, 2] };
/** What of the cell is to be seen around robot and zones, m. */
const AROUND = 0.4;
const BASE_M = 0.09;

/** A zone that would stand elsewhere, its centre there. */
interface Moving {
  zone: Zone;
  to: [number, number, number];
}

interface Props {
  cell: Cell;
  moving?: Moving | undefined;
}

/** A cell from above and from the side: the robot's base, obstacles, zones where they are, and a zone where it would be. */
export function CellSketch({ cell, moving }: Props) {
  const said = words.value.cells;
  return (
    <figure class="cell-sketch">
      {(['above', 'side'] as const).map((name) => (
        <div key={name}>
          <Drawing cell={cell} moving={moving} view={VIEWS[name]} label={said.views[name]} />
          <small>{said.views[name]}</small>
        </div>
      ))}
      <figcaption>
        <span class="swatch swatch-robot">{said.robotBase}</span>
        <span class="swatch swatch-obstacle">{said.obstacles}</span>
        <span class="swatch swatch-zone">{said.zoneNow}</span>
        {moving && <span class="swatch swatch-new">{said.zoneNew}</span>}
      </figcaption>
    </figure>
  );
}

type DrawingProps = Props & { view: View; label: string };

function Drawing({ cell, moving, view, label }: DrawingProps) {
  const { obstacles = [], zones = [], robot } = cell;
  const seen = (point: [number, number, number]): Point => [point[view[0]], point[view[1]]];
  const base = seen(robot.base?.xyz_m ?? [0, 0, 0]);
  const then = moving && footprint(at(moving.zone, moving.to), view);
  const now = zones.map((zone) => footprint(zone.shape, view));
  const { left, top, size } = square([base, ...now.flat(), ...(then ?? [])]);
  return (
    <svg viewBox={`${left} ${top} ${size} ${size}`} role="img" aria-label={label}>
      {obstacles.map(({ name, shape }) => (
        <polygon key={name} class="obstacle" points={drawn(footprint(shape, view))} />
      ))}
      {now.map((outline, k) => (
        <polygon key={zones[k]?.name} class="zone" points={drawn(outline)} />
      ))}
      {then && <polygon class="zone-new" points={drawn(then)} />}
      <circle class="base" cx={base[0]} cy={-base[1]} r={BASE_M} />
      {moving && <Arrow from={seen(centreOf(moving.zone.shape))} to={seen(moving.to)} head={size / 24} />}
    </svg>
  );
}

/** From where a zone's centre is to where it would be; nothing where it stays in this view. */
function Arrow({ from: [a, b], to: [c, d], head }: { from: Point; to: Point; head: number }) {
  const length = Math.hypot(c - a, d - b);
  if (length < head) return null;
  const [u, v] = [((c - a) / length) * head, ((d - b) / length) * head];
  const tip: Point[] = [
    [c, d],
    [c - u - v / 2, d - v + u / 2],
    [c - u + v / 2, d - v - u / 2],
  ];
  return (
    <>
      <line class="arrow" x1={a} y1={-b} x2={c - u} y2={-(d - v)} />
      <polygon class="arrow" points={drawn(tip)} />
    </>
  );
}

function at({ shape }: Zone, xyz_m: [number, number, number]): Zone['shape'] {
  return { ...shape, pose: { ...shape.pose, xyz_m } };
}

/** As SVG has it, whose y points down. */
function drawn(outline: Point[]): string {
  return outline.map(([u, v]) => `${u.toFixed(4)},${(-v).toFixed(4)}`).join(' ');
}

/** The square around points, with something of what is beside them. */
function square(points: Point[]): { left: number; top: number; size: number } {
  const [us, vs] = [points.map(([u]) => u), points.map(([, v]) => -v)];
  const [left, right, top, bottom] = [Math.min(...us), Math.max(...us), Math.min(...vs), Math.max(...vs)];
  const size = Math.max(right - left, bottom - top) + 2 * AROUND;
  return { left: (left + right - size) / 2, top: (top + bottom - size) / 2, size };
}
