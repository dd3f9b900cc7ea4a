import { words } from '../words';
import type { Cell } from './cells';
import { footprint, type Point, pointsOf, square, VIEWS, type ViewName } from './footprint';

/** What of the cell is to be seen around robot and zones, m. */
const AROUND_M = 0.4;
const BASE_M = 0.09;

/** A cell from above and from the side: the robot's base, obstacles, zones where they are. */
export function CellSketch({ cell }: { cell: Cell }) {
  const said = words.value.cells;
  return (
    <figure class="cell-sketch">
      {(Object.keys(VIEWS) as ViewName[]).map((view) => (
        <div key={view}>
          <Drawing cell={cell} view={view} />
          <small>{said.views[view]}</small>
        </div>
      ))}
      <Legend />
    </figure>
  );
}

/** What is what in a picture of a cell. */
export function Legend({ changing = false }: { changing?: boolean }) {
  const said = words.value.cells;
  return (
    <figcaption>
      <span class="swatch swatch-robot">{said.robotBase}</span>
      <span class="swatch swatch-obstacle">{said.obstacles}</span>
      <span class="swatch swatch-zone">{said.zoneNow}</span>
      {changing && <span class="swatch swatch-new">{said.zoneNew}</span>}
    </figcaption>
  );
}

function Drawing({ cell, view }: { cell: Cell; view: ViewName }) {
  const { obstacles = [], zones = [], robot } = cell;
  const [a, b] = VIEWS[view];
  const stands = robot.base?.xyz_m ?? [0, 0, 0];
  const base: Point = [stands[a], stands[b]];
  const outlines = zones.map((zone) => footprint(zone.shape, VIEWS[view]));
  const { left, top, size } = square([base, ...outlines.flat()], AROUND_M);
  return (
    <svg viewBox={`${left} ${top} ${size} ${size}`} role="img" aria-label={words.value.cells.views[view]}>
      {obstacles.map(({ name, shape }) => (
        <polygon key={name} class="obstacle" points={pointsOf(footprint(shape, VIEWS[view]))} />
      ))}
      {outlines.map((outline, k) => (
        <polygon key={zones[k]?.name} class="zone" points={pointsOf(outline)} />
      ))}
      <circle class="base" cx={base[0]} cy={-base[1]} r={BASE_M} />
    </svg>
  );
}
