import type { DiagnosisPublic, Message } from '../api';
import { number, type Scale, type Shown, scaled, scaleOf } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';

/** A fitted parameter in `unit`, with its standard uncertainty. */
export interface Parameter {
  title?: Message | null;
  value: number;
  std: number | null;
  unit: string;
  at_bound?: boolean;
}

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

/** An effect, or two at once, and what a diagnosis says of it. */
export interface Candidate {
  id: string;
  probability: number;
  closure: number;
  /** Whether the twin would take it, and what stands against it where not. */
  addable: boolean;
  whyNot: Message | null;
  interval: readonly [number, number] | null;
  stages: string[];
  /** What to do about each of its effects. */
  advice: Message[];
  /** By the effect that they belong to. */
  parameters: Record<string, Record<string, Parameter>>;
}

const DEGREES = 180 / Math.PI;
const DIGITS = 3;
/** From this probability on an effect is one of those that are open. */
const OPEN = 0.05;

/** Effects and pairs of a diagnosis, the most probable first. */
export function candidatesOf(diagnosis: Diagnosis): Candidate[] {
  const { effects, pairs } = diagnosis;
  const singles = effects.map(({ id, stage, advice, parameters, closure_interval, ...rest }) => ({
    ...rest,
    ...takenBy(rest),
    id,
    stages: [stage],
    advice: [advice],
    interval: closure_interval,
    parameters: { [id]: parameters },
  }));
  const both = pairs.map(({ ids, probability, closure, parameters = {}, advice: beside = {}, ...rest }) => {
    const parts = effects.filter(({ id }) => ids.includes(id));
    const stages = parts.map(({ stage }) => stage);
    const advice = parts.map((each) => beside[each.id] ?? each.advice);
    const said = { id: ids.join('+'), probability, closure, interval: null, stages, advice, parameters };
    return { ...said, ...takenBy(rest) };
  });
  return [...singles, ...both].sort((one, other) => other.probability - one.probability);
}

/** Older diagnoses do not say whether the twin takes what they name: it is not offered. */
function takenBy({ addable = false, why_not = null }: { addable?: boolean; why_not?: Message | null }) {
  return { addable, whyNot: why_not };
}

/** The most probable explanation, and whatever else is probable or cannot be told from it. */
export function openOf(diagnosis: Diagnosis): Candidate[] {
  const all = candidatesOf(diagnosis);
  const best = all[0]?.id ?? '';
  const tied = diagnosis.indistinguishable.filter(({ ids }) => ids.includes(best)).flatMap(({ ids }) => ids);
  return all.filter(({ id, probability }, k) => k === 0 || probability >= OPEN || tied.includes(id));
}

/** Name of an effect, or of several joined by a plus sign, in the chosen language. */
export function effectName(id: string): string {
  const names = words.value.gap.effects;
  return id
    .split('+')
    .map((part) => names[part] ?? part.replaceAll('_', ' '))
    .join(' + ');
}

/** `hold:x+` as people say it. */
export function phaseName(phase: string): string {
  const [kind = '', axis = ''] = phase.split(':');
  return `${words.value.gap.phases[kind] ?? kind} ${axis}`.trim();
}

/** What a parameter is called, in the chosen language. */
export function parameterTitle(name: string, { title }: Parameter): string {
  return title ? say(title) : name.replaceAll('_', ' ');
}

/** The number of a parameter in everyday units. */
export function parameterShown(name: string, { value, std, unit }: Parameter): Shown {
  const scale = everyday(name, value, unit);
  const size = Math.abs(value * scale.factor);
  const places = size === 0 ? 0 : Math.max(0, DIGITS - 1 - Math.floor(Math.log10(size)));
  return scaled({ ...scale, places }, value, std);
}

function everyday(name: string, value: number, unit: string): Omit<Scale, 'places'> {
  switch (unit) {
    case 'rad':
      return { factor: DEGREES, unit: '°' };
    case 's':
      return Math.abs(value) < 1 ? { factor: 1e3, unit: 'ms' } : { factor: 1, unit };
    case 'm':
      return scaleOf('length');
    case 'kg':
      return scaleOf('mass');
    case 'kg m':
      return scaleOf('moment');
    case 'kg m2':
      return scaleOf('inertia');
    case '1':
      return name.endsWith('_share') ? { factor: 100, unit: '%' } : { factor: 1, unit: '' };
    default:
      return { factor: 1, unit: unit.replace('m2', 'm²').replace('s2', 's²') };
  }
}

/** A multiple of the noise, as fine as anybody needs it. */
export function times(value: number): string {
  return number(value, value < 9.95 ? 1 : 0);
}

/** A probability in words. */
export function inWords(probability: number): string {
  const said = words.value.gap;
  if (probability >= 0.95) return said.certain;
  if (probability >= 0.8) return said.veryLikely;
  if (probability >= 0.5) return said.likely;
  if (probability >= 0.2) return said.possible;
  return probability >= 0.05 ? said.unlikely : said.veryUnlikely;
}
