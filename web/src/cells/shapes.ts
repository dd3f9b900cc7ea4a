import type { Obstacle } from '../api';
import { number, scaleOf, spelt } from '../ui/units';

type Shape = Obstacle['shape'];

/** How large a shape is: edges of a box, diameter of a ball, diameter and length of a capsule or a cylinder. */
export function sizeOf(shape: Shape): string {
  if (shape.kind === 'box') return lengths(shape.size_m);
  const across = `⌀ ${spelt('length', 2 * shape.radius_m)}`;
  return shape.kind === 'sphere' ? across : `${across} × ${spelt('length', shape.length_m)}`;
}

/** Where its centre is, world frame. */
export function centreOf(shape: Shape): [number, number, number] {
  return shape.pose?.xyz_m ?? [0, 0, 0];
}

export function placeOf(shape: Shape): string {
  return spotOf(centreOf(shape));
}

/** A point in the world frame. */
export function spotOf(xyz_m: [number, number, number]): string {
  const { factor, unit, places } = scaleOf('length');
  return `${xyz_m.map((value) => number(factor * value, places)).join(' | ')} ${unit}`;
}

function lengths(size_m: number[]): string {
  const { factor, unit, places } = scaleOf('length');
  return `${size_m.map((value) => number(factor * value, places)).join(' × ')} ${unit}`;
}
