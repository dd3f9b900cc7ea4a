/** Where a zone is taken hold of in a picture, and what becomes of it when it is dragged there. */
import type { Point, ViewName } from './footprint';
import { anglesOf, centred, centreOf, isUpright, type Shape, type Three } from './shapes';

/** By what: its body, its own axes x and y (`1`, `-1` or `0` each), top or bottom, its radius, its turn about the vertical. */
export type Grip =
  | { at: 'body' }
  | { at: 'edge'; x: number; y: number }
  | { at: 'height'; z: number }
  | { at: 'radius' }
  | { at: 'turn' };

export interface Handle {
  grip: Grip;
  /** In the picture, m. */
  place: Point;
}

/** No edge gets shorter by dragging, m. */
const SHORTEST_M = 0.02;
/** A new zone is as high as a tall person, m. */
const HEIGHT_M = 2;
/** How large one is that was tapped and not drawn, m. */
const TAPPED_M = 0.6;
const EDGES = [-1, 0, 1].flatMap((x) => [-1, 0, 1].map((y) => ({ x, y }))).filter(({ x, y }) => x || y);

/**
 * The handles of a zone in one picture; one that leans has none and is only moved.
 *
 * @param away how far outside of the zone's edge a handle is, m: so that small ones can be moved between them.
 */
export function handlesOf(shape: Shape, view: ViewName, away: number): Handle[] {
  if (!isUpright(shape)) return [];
  const [x, y, z] = centreOf(shape);
  if (view === 'side') {
    if (shape.kind === 'sphere') return [{ grip: { at: 'radius' }, place: [x + shape.radius_m + away, z] }];
    const half = heightOf(shape) / 2 + away;
    return [1, -1].map((sign) => ({ grip: { at: 'height', z: sign }, place: [x, z + sign * half] }));
  }
  if (shape.kind !== 'box') return [{ grip: { at: 'radius' }, place: [x + shape.radius_m + away, y] }];
  const [width, depth] = shape.size_m;
  const at = (u: number, v: number): Point => {
    const [a, b] = turned([u, v], anglesOf(shape)[2]);
    return [x + a, y + b];
  };
  return [
    ...EDGES.map(
      (edge): Handle => ({
        grip: { at: 'edge', ...edge },
        place: at(edge.x * (width / 2 + away), edge.y * (depth / 2 + away)),
      }),
    ),
    { grip: { at: 'turn' }, place: at(width / 2 + 3.5 * away, 0) },
  ];
}

/** How finely a drag goes: by centimetres and 5 degrees with a finger, more finely with what points more finely. */
export interface Grid {
  step_m: number;
  turn_rad: number;
}

export const COARSE: Grid = { step_m: 0.01, turn_rad: Math.PI / 36 };
export const FINE: Grid = { step_m: 0.001, turn_rad: Math.PI / 180 };

/** A zone that was dragged by a grip from one point of the picture to another. */
export function dragged(shape: Shape, grip: Grip, view: ViewName, from: Point, to: Point, grid: Grid): Shape {
  const by: Point = [to[0] - from[0], to[1] - from[1]];
  switch (grip.at) {
    case 'body':
      return moved(shape, view === 'above' ? [by[0], by[1], 0] : [by[0], 0, by[1]], grid);
    case 'edge':
      return resized(shape, grip, by, grid);
    case 'height':
      return heightened(shape, grip.z, by[1], grid);
    case 'radius':
      return shape.kind === 'box'
        ? shape
        : { ...shape, radius_m: Math.max(SHORTEST_M / 2, snap(shape.radius_m + by[0], grid.step_m)) };
    case 'turn':
      return turnedTo(shape, from, to, grid);
  }
}

/** Moved in the world; an axis along which it was not moved keeps its number as it is. */
export function moved(shape: Shape, by: Three, { step_m }: Grid): Shape {
  const centre = centreOf(shape).map((value, k) => (by[k] ? snap(value + (by[k] ?? 0), step_m) : value));
  return centred(shape, centre as Three);
}

function resized(shape: Shape, grip: { x: number; y: number }, by: Point, { step_m }: Grid): Shape {
  if (shape.kind !== 'box') return shape;
  const yaw = anglesOf(shape)[2];
  const own = turned(by, -yaw);
  const size: Three = [...shape.size_m];
  const shift: Point = [0, 0];
  for (const [k, sign] of [grip.x, grip.y].entries()) {
    const before = size[k] ?? 0;
    if (sign === 0) continue;
    size[k] = Math.max(SHORTEST_M, snap(before + sign * (own[k] ?? 0), step_m));
    shift[k] = (sign * ((size[k] ?? 0) - before)) / 2;
  }
  const [dx, dy] = turned(shift, yaw);
  const [x, y, z] = centreOf(shape);
  return centred({ ...shape, size_m: size }, [tidy(x + dx), tidy(y + dy), z]);
}

/** Its top (1) or its bottom (-1) somewhere else; the other end stays. */
function heightened(shape: Shape, sign: number, by: number, { step_m }: Grid): Shape {
  if (shape.kind === 'sphere') return shape;
  const before = shape.kind === 'box' ? shape.size_m[2] : shape.length_m;
  const after = Math.max(SHORTEST_M, snap(before + sign * by, step_m));
  const [x, y, z] = centreOf(shape);
  const grown: Shape =
    shape.kind === 'box'
      ? { ...shape, size_m: [shape.size_m[0], shape.size_m[1], after] }
      : { ...shape, length_m: after };
  return centred(grown, [x, y, tidy(z + (sign * (after - before)) / 2)]);
}

function turnedTo(shape: Shape, from: Point, to: Point, { turn_rad }: Grid): Shape {
  const [x, y] = centreOf(shape);
  const angle = ([u, v]: Point) => Math.atan2(v - y, u - x);
  const [roll, pitch, yaw] = anglesOf(shape);
  const steps = Math.round((yaw + angle(to) - angle(from)) / turn_rad);
  return { ...shape, pose: { ...shape.pose, rpy_rad: [roll, pitch, inOneTurn(steps * turn_rad)] } };
}

/** A new zone that was drawn from one point to another as seen from above: it stands on the floor. */
export function drawn(kind: Shape['kind'], from: Point, to: Point, floor_m: number, { step_m }: Grid): Shape {
  const [a, b] = [from, to].map(([u, v]): Point => [snap(u, step_m), snap(v, step_m)]) as [Point, Point];
  const [width, depth] = [0, 1].map((k) => Math.max(SHORTEST_M, tidy(Math.abs((b[k] ?? 0) - (a[k] ?? 0)))));
  if (kind === 'box') {
    const middle: Three = [tidy((a[0] + b[0]) / 2), tidy((a[1] + b[1]) / 2), tidy(floor_m + HEIGHT_M / 2)];
    return centred({ kind, size_m: [width ?? 0, depth ?? 0, HEIGHT_M], pose: {} }, middle);
  }
  const radius_m = Math.max(SHORTEST_M / 2, snap(Math.hypot(b[0] - a[0], b[1] - a[1]), step_m));
  if (kind === 'sphere') return centred({ kind, radius_m, pose: {} }, [a[0], a[1], tidy(floor_m + radius_m)]);
  return centred({ kind, radius_m, length_m: HEIGHT_M, pose: {} }, [
    a[0],
    a[1],
    tidy(floor_m + HEIGHT_M / 2),
  ]);
}

/** One of the usual size around a point, where nobody drew how large it is. */
export function tapped(kind: Shape['kind'], [u, v]: Point, floor_m: number, grid: Grid): Shape {
  const half = TAPPED_M / 2;
  return kind === 'box'
    ? drawn(kind, [u - half, v - half], [u + half, v + half], floor_m, grid)
    : drawn(kind, [u, v], [u + half, v], floor_m, grid);
}

/** How high it is as it stands, m. */
function heightOf(shape: Shape): number {
  if (shape.kind === 'box') return shape.size_m[2];
  if (shape.kind === 'sphere') return 2 * shape.radius_m;
  return shape.kind === 'capsule' ? shape.length_m + 2 * shape.radius_m : shape.length_m;
}

/** The same angle between half a turn back and half a turn on, rad. */
export function inOneTurn(angle: number): number {
  return tidy(Math.atan2(Math.sin(angle), Math.cos(angle)));
}

function turned([a, b]: Point, angle: number): Point {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * a - s * b, s * a + c * b];
}

const snap = (value: number, step: number) => tidy(Math.round(value / step) * step);

/** Without what binary fractions leave behind the sixth decimal. */
const tidy = (value: number) => Math.round(value * 1e6) / 1e6 + 0;
