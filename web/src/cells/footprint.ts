import type { Pose } from '../api';
import type { StandingShape, Three } from './shapes';

export type Point = [number, number];
/** Two axes of the world frame: seen from above, seen from the side. */
export type View = readonly [0, 1] | readonly [0, 2];
export type ViewName = 'above' | 'side';

export const VIEWS: Record<ViewName, View> = { above: [0, 1], side: [0, 2] };

const ROUND = 32;

/** Half of the edge of the square that says where a mesh is, m: what it looks like is seen in three dimensions. */
const MARK_M = 0.03;

/** The outline of a shape as somebody sees it who looks along the third axis: its corners one after the other, m, world frame. */
export function footprint(shape: StandingShape, [u, v]: View): Point[] {
  const seen = (point: Three): Point => {
    const there = placed(point, shape.pose);
    return [there[u], there[v]];
  };
  if (shape.kind === 'box' || shape.kind === 'mesh') {
    const [x, y, z] =
      shape.kind === 'mesh' ? [MARK_M, MARK_M, MARK_M] : (shape.size_m.map((length) => length / 2) as Three);
    const signs = [-1, 1];
    return hull(signs.flatMap((a) => signs.flatMap((b) => signs.map((c) => seen([a * x, b * y, c * z])))));
  }
  if (shape.kind === 'cylinder') {
    const ring = circle([0, 0], shape.radius_m);
    return hull(
      [-shape.length_m / 2, shape.length_m / 2].flatMap((z) => ring.map(([x, y]) => seen([x, y, z]))),
    );
  }
  const half = shape.kind === 'capsule' ? shape.length_m / 2 : 0;
  return hull([-half, half].flatMap((z) => circle(seen([0, 0, z]), shape.radius_m)));
}

function circle([u, v]: Point, radius: number): Point[] {
  return Array.from({ length: ROUND }, (_, k) => {
    const angle = (2 * Math.PI * k) / ROUND;
    return [u + radius * Math.cos(angle), v + radius * Math.sin(angle)];
  });
}

/** A point of a pose's own frame in the frame that the pose refers to: yaw after pitch after roll. */
export function placed([x, y, z]: Three, pose: Pose | undefined): Three {
  const [roll = 0, pitch = 0, yaw = 0] = pose?.rpy_rad ?? [];
  const [y1, z1] = turned([y, z], roll);
  const [z2, x2] = turned([z1, x], pitch);
  const [x3, y3] = turned([x2, y1], yaw);
  const [tx = 0, ty = 0, tz = 0] = pose?.xyz_m ?? [];
  return [tx + x3, ty + y3, tz + z2];
}

function turned([a, b]: Point, angle: number): Point {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * a - s * b, s * a + c * b];
}

/** The smallest convex outline around points, counter-clockwise (Andrew's monotone chain). */
export function hull(points: Point[]): Point[] {
  const sorted = [...points].sort(([a, b], [c, d]) => a - c || b - d);
  const half = (from: Point[]) => {
    const chain: Point[] = [];
    for (const point of from) {
      while (chain.length > 1 && !isLeft(chain.at(-2), chain.at(-1), point)) chain.pop();
      chain.push(point);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

function isLeft([a, b]: Point = [0, 0], [c, d]: Point = [0, 0], [e, f]: Point): boolean {
  return (c - a) * (f - b) - (d - b) * (e - a) > 0;
}

/** A square of a picture, as SVG has it, whose y points down, m. */
export interface Square {
  left: number;
  top: number;
  size: number;
}

/** The square around points, with so much beside them, m. */
export function square(points: Point[], around: number): Square {
  const [us, vs] = [points.map(([u]) => u), points.map(([, v]) => -v)];
  const [left, right, top, bottom] = [Math.min(...us), Math.max(...us), Math.min(...vs), Math.max(...vs)];
  const size = Math.max(right - left, bottom - top) + 2 * around;
  return { left: (left + right - size) / 2, top: (top + bottom - size) / 2, size };
}

/** An outline as SVG has it. */
export function pointsOf(outline: Point[]): string {
  return outline.map(([u, v]) => `${u.toFixed(4)},${(-v).toFixed(4)}`).join(' ');
}
