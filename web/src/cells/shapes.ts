import type { Obstacle } from '../api';
import { number, scaleOf, spelt } from '../ui/units';

/** Of what stands in a cell: also a mesh, of which the page knows the file alone. */
export type StandingShape = Obstacle['shape'];
/** What can be drawn. */
export type Shape = Exclude<StandingShape, { kind: 'mesh' }>;
export type ShapeKind = Shape['kind'];
export type Three = [number, number, number];

/** Whether somebody can have drawn it: a finger draws no mesh. */
export function isDrawable(shape: StandingShape): shape is Shape {
  return shape.kind !== 'mesh';
}

/** How large a shape is: edges of a box, diameter of a ball, diameter and length of a capsule or a cylinder; of a mesh its file. */
export function sizeOf(shape: StandingShape): string {
  if (shape.kind === 'mesh') return shape.file;
  if (shape.kind === 'box') return lengths(shape.size_m);
  const across = `⌀ ${spelt('length', 2 * shape.radius_m)}`;
  return shape.kind === 'sphere' ? across : `${across} × ${spelt('length', shape.length_m)}`;
}

/** Where its centre is, world frame. */
export function centreOf(shape: StandingShape): Three {
  return shape.pose?.xyz_m ?? [0, 0, 0];
}

/** Roll, pitch and yaw, rad. */
export function anglesOf(shape: StandingShape): Three {
  return shape.pose?.rpy_rad ?? [0, 0, 0];
}

/** Whether its own z axis is that of the world: turned about the vertical at most. */
export function isUpright(shape: Shape): boolean {
  const [roll, pitch] = anglesOf(shape);
  return roll === 0 && pitch === 0;
}

export function placeOf(shape: StandingShape): string {
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
export function alike(one: StandingShape, other: StandingShape): boolean {
  return JSON.stringify(plain(one)) === JSON.stringify(plain(other));
}

/** Whether they differ in their place alone. */
export function onlyMoved(one: StandingShape, other: StandingShape): boolean {
  return alike({ ...one, pose: other.pose ?? {} }, other);
}

function plain(shape: StandingShape): unknown[] {
  const { xyz_m = [0, 0, 0], rpy_rad = [0, 0, 0] } = shape.pose ?? {};
  return [shape.kind, ...extent(shape), ...xyz_m, ...rpy_rad];
}

function extent(shape: StandingShape): unknown[] {
  if (shape.kind === 'mesh') return [shape.file, ...(shape.scale ?? [1, 1, 1])];
  if (shape.kind === 'box') return shape.size_m;
  return [shape.radius_m, 'length_m' in shape ? shape.length_m : 0];
}

function lengths(size_m: number[]): string {
  const { factor, unit, places } = scaleOf('length');
  return `${size_m.map((value) => number(factor * value, places)).join(' × ')} ${unit}`;
}
