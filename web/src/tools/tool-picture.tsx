import '../look/tool-picture.css';
import type { Box } from '../api';
import { hull, type Point, placed } from '../cells/footprint';
import type { Three } from '../cells/shapes';
import { sizeOf } from '../cells/shapes';
import { number, scaleOf } from '../ui/units';

const FLANGE_M = 0.04;
const FLANGE_HEIGHT_M = 0.02;
const AXIS_M = 0.06;
const ROUND = 32;
/** Room around what is drawn, of its width. */
const MARGIN = 0.12;
/** Lengths that a scale is marked with, mm. */
const MARKS_MM = [5, 10, 20, 50, 100, 200, 500, 1000, 2000];

/** From above and in front, the sensor's z axis pointing down; m become mm. */
function seen([x, y, z]: Three): Point {
  return [1000 * (x - y) * Math.cos(Math.PI / 6), 1000 * ((x + y) * Math.sin(Math.PI / 6) + z)];
}

/** The six faces of a box as corners, each with whether it looks at whoever looks. */
function facesOf({ size_m, pose }: Box): { corners: Point[]; faces: boolean }[] {
  const [a, b, c] = size_m.map((length) => length / 2) as Three;
  const half: Three = [a, b, c];
  const origin = placed([0, 0, 0], pose);
  return [0, 1, 2].flatMap((axis) =>
    [-1, 1].map((sign) => {
      const [u, v] = [0, 1, 2].filter((each) => each !== axis) as [number, number];
      const corner = (s: number, t: number) => {
        const point: Three = [0, 0, 0];
        point[axis] = sign * half[axis as 0];
        point[u] = s * half[u as 0];
        point[v] = t * half[v as 0];
        return point;
      };
      const normal: Three = [0, 0, 0];
      normal[axis] = sign;
      const [nx, ny, nz] = placed(normal, pose).map((value, k) => value - (origin[k] ?? 0)) as Three;
      const ring = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
      return { corners: ring.map((point) => seen(placed(point, pose))), faces: nx + ny - nz > 1e-9 };
    }),
  );
}

interface Props {
  box: Box;
  /** Centre of mass, m, sensor frame; absent where it is not known. */
  com_m?: (number | null)[] | null | undefined;
  /** What is bolted between sensor and tool, sensor frame. */
  bolted?: Box[];
  /** Beside the tool's name, without scale and names of axes. */
  small?: boolean;
}

/** A tool's box to scale, as it hangs on the sensor: the flange, the axes of the sensor frame, the centre of mass, a scale. */
export function ToolPicture({ box, com_m, bolted = [], small = false }: Props) {
  const flange = hull([...ring(-FLANGE_HEIGHT_M), ...ring(0)]);
  const known = com_m?.every((value) => value !== null) ? seen(com_m as Three) : null;
  const shapes = [box, ...bolted].flatMap((each) => facesOf(each).flatMap(({ corners }) => corners));
  const axes = [seen([AXIS_M, 0, 0]), seen([0, AXIS_M, 0]), seen([0, 0, AXIS_M])];
  const frame = frameOf([...flange, ...shapes, ...axes]);
  const dot = frame.size / 60;
  return (
    <svg
      class="tool-picture"
      viewBox={`${frame.left} ${frame.top} ${frame.size} ${frame.size}`}
      role="img"
      aria-label={sizeOf(box)}
      aria-hidden={small}
    >
      {bolted.map((each, k) => (
        <Cuboid key={k} box={each} kind="bolted" />
      ))}
      <Cuboid box={box} kind="carried" />
      <polygon class="flange" points={drawn(flange)} />
      <polygon class="flange" points={drawn(ring(-FLANGE_HEIGHT_M))} />
      {!small && axes.map((end, k) => <Axis key={k} end={end} name={'xyz'[k] ?? ''} size={frame.size} />)}
      {known && (
        <g class="com">
          <circle cx={known[0]} cy={known[1]} r={2 * dot} />
          <circle class="com-dot" cx={known[0]} cy={known[1]} r={dot} />
        </g>
      )}
      {!small && <Scale frame={frame} />}
    </svg>
  );
}

function Cuboid({ box, kind }: { box: Box; kind: 'carried' | 'bolted' }) {
  const all = facesOf(box);
  return (
    <g class={kind}>
      {all
        .filter(({ faces }) => !faces)
        .map(({ corners }, k) => (
          <polygon class="hidden-face" key={k} points={drawn(corners)} />
        ))}
      {all
        .filter(({ faces }) => faces)
        .map(({ corners }, k) => (
          <polygon class="face" key={k} points={drawn(corners)} />
        ))}
    </g>
  );
}

function Axis({ end: [u, v], name, size }: { end: Point; name: string; size: number }) {
  const far = 1.22;
  return (
    <g class={`axis axis-${name}`}>
      <line x1={0} y1={0} x2={u} y2={v} />
      <text x={far * u} y={far * v + size / 60} font-size={size / 18} text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

/** A length that can be read off, about a third of the width. */
function Scale({ frame: { left, top, size } }: { frame: Frame }) {
  const mark = MARKS_MM.findLast((length) => length <= size / 3) ?? size / 3;
  const { factor, unit } = scaleOf('length');
  const [x, y] = [left + size * 0.04, top + size * 0.96];
  const tick = size / 60;
  const length = (mark / 1000) * factor;
  return (
    <g class="scale">
      <path d={`M${x} ${y - tick}v${tick}h${mark}v${-tick}`} />
      <text x={x + mark + size / 40} y={y} font-size={size / 18}>
        {`${number(length, placesOf(length))} ${unit}`}
      </text>
    </g>
  );
}

/** Decimals of a length that is 1, 2 or 5 times a power of ten. */
const placesOf = (length: number) => Math.max(0, -Math.floor(Math.log10(length) + 1e-9));

const ring = (z: number): Point[] =>
  Array.from({ length: ROUND }, (_, k) => {
    const angle = (2 * Math.PI * k) / ROUND;
    return seen([FLANGE_M * Math.cos(angle), FLANGE_M * Math.sin(angle), z]);
  });

interface Frame {
  left: number;
  top: number;
  size: number;
}

/** The square around points, with room for the scale below. */
function frameOf(points: Point[]): Frame {
  const [us, vs] = [points.map(([u]) => u), points.map(([, v]) => v)];
  const [left, right, top, bottom] = [Math.min(...us), Math.max(...us), Math.min(...vs), Math.max(...vs)];
  const size = Math.max(right - left, bottom - top) * (1 + 2 * MARGIN);
  return { left: (left + right - size) / 2, top: (top + bottom - size) / 2, size };
}

function drawn(outline: Point[]): string {
  return outline.map(([u, v]) => `${u.toFixed(1)},${v.toFixed(1)}`).join(' ');
}
