import type { Box, PayloadPublic, Pose } from '../api';
import { NARROW_SPACE, number, type Quantity, scaleOf, typed } from '../ui/units';

export type Three = [string, string, string];

/** A tool as it stands in the form, in the chosen units; the rotation in degrees. */
export interface ToolDraft {
  title: string;
  /** null while it follows the title. */
  name: string | null;
  size: Three;
  centre: Three;
  turn: Three;
  least: string;
  most: string;
  note: string;
}

/** What a form begins with. */
export interface ToolBeginning {
  cell: string;
  title?: string;
  box?: Box | undefined;
  mass_kg?: number | null;
  /** A result that is saved: whether all ten parameters are determined. */
  run?: { id: string; whole: boolean };
}

/** Room for what a tool may weigh more or less than it was typed: a proposal, to be corrected. */
const AROUND = 0.1;
const DEGREES = 180 / Math.PI;
const LONGEST_NAME = 64;
const NAME = /^[A-Za-z0-9_-]{1,64}$/;

const NOUGHT: [number, number, number] = [0, 0, 0];

function written(value: number, quantity: Quantity): string {
  const { factor, places } = scaleOf(quantity);
  return number(factor * value, places).replaceAll(NARROW_SPACE, '');
}

function threeWritten(values: number[], quantity: Quantity): Three {
  return values.map((value) => written(value, quantity)) as Three;
}

function turnWritten(pose: Pose | undefined): Three {
  const angles = pose?.rpy_rad ?? NOUGHT;
  return angles.map((angle) => number(DEGREES * angle, 1).replace(/[.,]0$/, '')) as Three;
}

export function beginDraft({ title = '', box, mass_kg = null }: Omit<ToolBeginning, 'cell'>): ToolDraft {
  return {
    title,
    name: null,
    size: box ? threeWritten(box.size_m, 'length') : ['', '', ''],
    centre: threeWritten(box?.pose?.xyz_m ?? NOUGHT, 'length'),
    turn: turnWritten(box?.pose),
    least: mass_kg === null ? '' : written((1 - AROUND) * mass_kg, 'mass'),
    most: mass_kg === null ? '' : written((1 + AROUND) * mass_kg, 'mass'),
    note: '',
  };
}

/** A saved tool in the form. */
export function draftOf(tool: PayloadPublic): ToolDraft {
  const { title, name, box, mass_least_kg: least, mass_most_kg: most, note } = tool;
  return {
    ...beginDraft({ title, box }),
    name,
    least: least == null ? '' : written(least, 'mass'),
    most: most == null ? '' : written(most, 'mass'),
    note: note ?? '',
  };
}

/** What orders call it: the title in plain letters, until somebody types another name. */
export function nameOfDraft({ name, title }: ToolDraft): string {
  if (name !== null) return name;
  const plain = title
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .replaceAll('ß', 'ss')
    .replace(/[^A-Za-z0-9_-]+/g, '_');
  return plain
    .replace(/^_+|_+$/g, '')
    .toLowerCase()
    .slice(0, LONGEST_NAME);
}

export const isName = (text: string): boolean => NAME.test(text);

/** The box, sensor frame; null while a field cannot be read. */
export function boxOfDraft({ size, centre, turn }: ToolDraft): Box | null {
  const { factor } = scaleOf('length');
  const lengths = size.map((text) => read(text, factor));
  const place = centre.map((text) => read(text, factor));
  const angles = turn.map((text) => read(text, DEGREES));
  if ([...lengths, ...place, ...angles].includes(null) || lengths.some((length) => (length ?? 0) <= 0))
    return null;
  return {
    kind: 'box',
    size_m: lengths as [number, number, number],
    pose: { xyz_m: place as [number, number, number], rpy_rad: angles as [number, number, number] },
  };
}

/** From where to where it should weigh, kg, null where nothing is said; null altogether while that cannot be read. */
export function rangeOfDraft({ least, most }: ToolDraft): [number | null, number | null] | null {
  const range = [least, most].map((text) => (text.trim() === '' ? null : read(text, scaleOf('mass').factor)));
  const [from = null, to = null] = range;
  const unread = (text: string, value: number | null) => text.trim() !== '' && (value === null || value <= 0);
  if (unread(least, from) || unread(most, to) || (from !== null && to !== null && from > to)) return null;
  return [from, to];
}

function read(text: string, factor: number): number | null {
  const found = typed(text);
  return found === null ? null : found / factor;
}
