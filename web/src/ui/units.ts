import { language, type Units, units } from '../session/settings';

/** Half the width of a 95 % interval, in standard uncertainties. */
export const INTERVAL = 1.96;
export const NARROW_SPACE = '\u202f';
const MINUS = '\u2212';

export type Quantity = 'mass' | 'length' | 'moment' | 'inertia' | 'speed' | 'force' | 'torque' | 'time';

export interface Scale {
  /** From SI to the unit. */
  factor: number;
  unit: string;
  /** Decimals where no uncertainty says how many there are. */
  places: number;
}

const FORCE: Scale = { factor: 1, unit: 'N', places: 1 };
const TIME: Scale = { factor: 1, unit: 's', places: 0 };

const SCALES: Record<Units, Record<Quantity, Scale>> = {
  si: {
    mass: { factor: 1, unit: 'kg', places: 3 },
    length: { factor: 1, unit: 'm', places: 3 },
    moment: { factor: 1, unit: 'kg m', places: 4 },
    inertia: { factor: 1, unit: 'kg m²', places: 5 },
    speed: { factor: 1, unit: 'm/s', places: 2 },
    torque: { factor: 1, unit: 'N m', places: 2 },
    force: FORCE,
    time: TIME,
  },
  mm_g: {
    mass: { factor: 1e3, unit: 'g', places: 0 },
    length: { factor: 1e3, unit: 'mm', places: 0 },
    moment: { factor: 1e6, unit: 'g mm', places: 0 },
    inertia: { factor: 1e9, unit: 'g mm²', places: -3 },
    speed: { factor: 1e3, unit: 'mm/s', places: 0 },
    torque: { factor: 1e3, unit: 'N mm', places: 0 },
    force: FORCE,
    time: TIME,
  },
};

/** A number for people, with its unit: the half-width of its 95 % interval, where its uncertainty is known. */
export interface Shown {
  value: string;
  half: string | null;
  unit: string;
}

export function scaleOf(quantity: Quantity): Scale {
  return SCALES[units.value][quantity];
}

/** An SI value with its standard uncertainty: the uncertainty to two digits, the value as far as that reaches. */
export function shown(quantity: Quantity, value: number, std: number | null = null): Shown {
  return scaled(scaleOf(quantity), value, std);
}

/** The same on any scale. */
export function scaled({ factor, unit, places }: Scale, value: number, std: number | null): Shown {
  if (std === null || std <= 0) return { value: number(factor * value, places), half: null, unit };
  const half = INTERVAL * factor * std;
  const digits = 1 - Math.floor(Math.log10(half));
  return { value: number(factor * value, digits), half: number(half, digits), unit };
}

/** The same in one piece. */
export function spelt(quantity: Quantity, value: number, std: number | null = null): string {
  return inOnePiece(shown(quantity, value, std));
}

export function inOnePiece({ value, half, unit }: Shown): string {
  return (half === null ? `${value} ${unit}` : `${value} ± ${half} ${unit}`).trim();
}

/** A number in the chosen language; `places` below zero rounds to tens, hundreds. */
export function number(value: number, places: number): string {
  const decimals = Math.max(0, places);
  const coarse = 10 ** Math.max(0, -places);
  const format = new Intl.NumberFormat(language.value, {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
    signDisplay: 'negative',
  });
  const parts = format.formatToParts(coarse > 1 ? Math.round(value / coarse) * coarse : value);
  return parts.map(({ type, value: text }) => SPELT[type] ?? text).join('');
}

const SPELT: Partial<Record<Intl.NumberFormatPartTypes, string>> = { group: NARROW_SPACE, minusSign: MINUS };

/** A share of 1 in per cent, without false certainty. */
export function percent(share: number): string {
  if (share > 0 && share < 0.001) return `< ${number(0.1, 1)} %`;
  if (share < 1 && share > 0.999) return `> ${number(99.9, 1)} %`;
  return `${number(100 * share, share >= 0.1 ? 0 : 1)} %`;
}

/** A time span as a clock shows it: 1:05. */
export function clock(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}

/** As Intl has the chosen language: days before months and hours up to 24 in English too. */
export const dateLocale = () => (language.value === 'en' ? 'en-GB' : language.value);

/** A moment, as the service writes it, in the chosen language and the tablet's time zone. */
export function moment(iso: string): string {
  return new Intl.DateTimeFormat(dateLocale(), { dateStyle: 'medium', timeStyle: 'medium' }).format(
    new Date(iso),
  );
}

/** The time of day, by the tablet's clock and zone. */
export function timeOfDay(at_ms: number): string {
  return new Intl.DateTimeFormat(dateLocale(), { timeStyle: 'medium' }).format(at_ms);
}

/** A short time, as exactly as people can use it. */
export function seconds(time_s: number): string {
  const places = time_s < 1 ? 2 : time_s < 10 ? 1 : 0;
  return `${number(time_s, places)} s`;
}

/** What a person typed as a number, with a decimal comma or point; null where it is none, or could be read in two ways. */
export function typed(text: string): number | null {
  const plain = text.trim().replace(',', '.').replace(MINUS, '-');
  return /^-?(\d+(\.\d*)?|\.\d+)$/.test(plain) ? Number(plain) : null;
}
