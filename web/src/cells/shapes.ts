import type { Obstacle, Zone } from '../api';
import { number, scaleOf, spelt } from '../ui/units';

export type Shape = Zone['shape'];
/** Of what stands in a cell: also a mesh, of which the page knows the file alone. */
export type StandingShape = Obstacle['shape'];
export type ShapeKind = Shape['kind'];
export type Three = [number, number, number];

/** How large a shape is: edges of a box, diameter of a ball, diameter and length of a capsule or a cylinder; of a mesh its file. */
export function sizeOf(shape: StandingShape): string {
  if (shape.kind === 'mesh') return shape.file;
  if (shape.kind === 'box') return lengths(shape.size_m);
  const across = `⌀ ${spelt('length', 2 * shape.radius_m)}`;
  return shape.kind === 'sphere' ? across : `${across} × ${spelt('length', shape.length_m)}`;
}

/** Where its centre is, world frame. */
export function centreOf(shape: Shape): Three {
  return shape.pose?.xyz_m ?? [0, 0, 0];
}

/** Roll, pitch and yaw, rad. */
export function anglesOf(shape: Shape): Three {
  return shape.pose?.rpy_rad ?? [0, 0, 0];
}

/** Whether its own z axis is that of the world: turned about the vertical at most. */
export function isUpright(shape: Shape): boolean {
  const [roll, pitch] = anglesOf(shape);
  return roll === 0 && pitch === 0;
}

export function placeOf(shape: Shape): string {
  return spotOf(centreOf(shape));
}

/** A point in the world frame. */
export function spotOf(xyz_m: Three): string {
  const { factor, unit, places } = scaleOf('length');
  return `${xyz_m.map((value) => number(factor * value, places)).join(' | ')} ${unit}`;
}

/** The same shape with its centre there. */
export function centred(shape: Shape, xyz_m: Three): Shape {
  return { ...shape, pose: { ...shape.pose, xyz_m } };
}

/** Whether two shapes are the same in size and place. */
export function alike(one: Shape, other: Shape): boolean {
  return JSON.stringify(plain(one)) === JSON.stringify(plain(other));
}

/** Whether they differ in their place alone. */
export function onlyMoved(one: Shape, other: Shape): boolean {
  return alike({ ...one, pose: other.pose ?? {} }, other);
}

function plain(shape: Shape): unknown[] {
  const { xyz_m = [0, 0, 0], rpy_rad = [0, 0, 0] } = shape.pose ?? {};
  const size =
    shape.kind === 'box' ? shape.size_m : [shape.radius_m, 'length_m' in shape ? shape.length_m : 0];
  return [shape.kind, ...size, ...xyz_m, ...rpy_rad];
}

function lengths(size_m: number[]): string {
  const { factor, unit, places } = scaleOf('length');
  return `${size_m.map((value) => number(factor * value, places)).join(' × ')} ${unit}`;
}
