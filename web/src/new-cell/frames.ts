import type { DraftCellUpdate, RobotOutline } from '../api';
import { scaleOf, typed } from '../ui/units';

/** Where the arm begins and ends, as it is chosen. */
export interface Frames {
  name: string;
  title: string;
  base: string;
  /** A link of the description is the sensor's frame, or it is mounted on one. */
  kind: 'link' | 'mount';
  sensor: string;
  /** Of the sensor frame in the flange, in the chosen units, and in degrees. */
  offset: [string, string, string];
  turn: [string, string, string];
  behind: 'tool' | 'robot' | null;
}

const DEGREES = 180 / Math.PI;
export const NAME = /^[A-Za-z0-9_-]{1,64}$/;

/** What is proposed for a robot. */
export function armOf(outline: RobotOutline): Frames {
  const plain = outline.robot.replace(/[^A-Za-z0-9_-]+/g, '_').slice(0, 64);
  return {
    name: plain.toLowerCase(),
    title: outline.robot || plain,
    base: outline.base_frame,
    kind: 'link',
    sensor: outline.sensor_frame,
    offset: ['0', '0', '0'],
    turn: ['0', '0', '0'],
    behind: null,
  };
}

/** Links above a link, the nearest first. */
export function linksAbove({ links }: RobotOutline, name: string): string[] {
  const above: string[] = [];
  let parent = links.find((link) => link.name === name)?.parent ?? null;
  while (parent !== null) {
    above.push(parent);
    const next = parent;
    parent = links.find((link) => link.name === next)?.parent ?? null;
  }
  return above;
}

/** Links with a mass or a shape that hang behind the sensor's frame. */
export function linksBehind(outline: RobotOutline, { kind, sensor }: Frames): string[] {
  if (kind === 'mount') return [];
  return outline.links
    .filter(({ name, is_body }) => is_body && linksAbove(outline, name).includes(sensor))
    .map(({ name }) => name);
}

/** What keeps the frames from being used. */
export function lackOfFrames(frames: Frames, outline: RobotOutline): 'name' | 'offset' | 'behind' | null {
  if (!NAME.test(frames.name)) return 'name';
  if ([...frames.offset, ...frames.turn].some((text) => typed(text) === null)) return 'offset';
  return linksBehind(outline, frames).length > 0 && frames.behind === null ? 'behind' : null;
}

/** As the service takes them. */
export function framesFit(frames: Frames, outline: RobotOutline | null): DraftCellUpdate {
  const { name, base: base_frame, kind, sensor, offset, turn } = frames;
  const three = (texts: string[], factor: number) =>
    texts.map((text) => (typed(text) ?? 0) / factor) as [number, number, number];
  const behind = outline && linksBehind(outline, frames).length > 0 ? frames.behind : null;
  if (kind === 'link') return { name, base_frame, sensor_frame: sensor, behind };
  const mount_pose = { xyz_m: three(offset, scaleOf('length').factor), rpy_rad: three(turn, DEGREES) };
  return { name, base_frame, mount: sensor, mount_pose };
}
