/**
 * The words of every message of the engine and the service: the same files of `core/words` that Python reads, said by the same rules
 * (`core/words/catalogue.py`). A test holds both together.
 */
import { FluentBundle, FluentNumber, FluentResource, type FluentValue } from '@fluent/bundle';
import { nameOf } from '../ui/names';
import type { Language } from './languages';

/** A code of the catalogue and what its words name: numbers in SI, names, lists, other messages. */
export interface Message {
  code: string;
  parameters?: Record<string, unknown>;
  /** It in English, for those who have no catalogue. */
  text?: string;
}

/** The words of a language, ready to be filled in. */
export type Catalogue = FluentBundle;

const FLAW = 'flaw';
/** So many decimals tell whether a number lies exactly between two others. */
const ALL_DECIMALS = 100;
/** From here on JavaScript itself prints an exponent. */
const LARGEST_FIXED = 1e21;
/** %g of C and Python leaves the exponent out from here on. */
const SMALLEST_EXPONENT = -4;

/**
 * All messages of a language.
 *
 * @param files what they are read from, by whatever name.
 * @param transform changes the words themselves, and nothing that they name.
 */
export function readCatalogue(
  language: Language,
  files: Record<string, string>,
  transform: (words: string) => string = (words) => words,
): Catalogue {
  const functions = Object.fromEntries(
    Object.entries(NUMBERS).map(([name, print]) => [name, fluentFunction(print, language)]),
  );
  const catalogue = new FluentBundle(language, {
    useIsolating: false,
    functions: { ...functions, PERSON: ([who]: FluentValue[]) => nameOf(String(who?.valueOf() ?? '')) },
    transform,
  });
  for (const words of Object.values(files)) catalogue.addResource(new FluentResource(words));
  return catalogue;
}

/**
 * A message's words. One without words of its own, only `found` and `expected`, is a flaw and says where it is.
 *
 * One that the catalogue does not have is said as it came: in English, or as its code.
 */
export function formatMessage(message: Message, catalogue: Catalogue): string {
  const entry = catalogue.getMessage(message.code);
  if (entry === undefined) return message.text ?? spellOut(message);
  const named = nameAll(message, catalogue);
  if (entry.value !== null) return fill(entry.value, named, catalogue);
  const flaw = catalogue.getMessage(FLAW)?.value ?? '';
  const [found, expected] = ['found', 'expected'].map((part) =>
    fill(entry.attributes[part] ?? '', named, catalogue),
  );
  return fill(flaw, { where: named.where ?? '', found: found ?? '', expected: expected ?? '' }, catalogue);
}

/** The words of one part of a message; all of them where it has no such part. */
export function formatPart(message: Message, part: string, catalogue: Catalogue): string {
  const pattern = catalogue.getMessage(message.code)?.attributes[part];
  if (pattern === undefined) return formatMessage(message, catalogue);
  return fill(pattern, nameAll(message, catalogue), catalogue);
}

/** A value that a message names, in words: another message, several of them, or a value as it is. */
export function formatValue(value: unknown, catalogue: Catalogue): string {
  return String(nameOne(value, catalogue).valueOf());
}

type Pattern = Parameters<FluentBundle['formatPattern']>[0];
type Named = Record<string, FluentNumber | string>;

/** What cannot be filled in is left as a name in braces: a message that is not whole must not hide what happened. */
function fill(pattern: Pattern, named: Named, catalogue: Catalogue): string {
  return catalogue.formatPattern(pattern, named, []);
}

function nameAll({ parameters = {} }: Message, catalogue: Catalogue): Named {
  return Object.fromEntries(
    Object.entries(parameters).map(([name, value]) => [name, nameOne(value, catalogue)]),
  );
}

function nameOne(value: unknown, catalogue: Catalogue): FluentNumber | string {
  if (typeof value === 'number' && Number.isFinite(value))
    return new FluentNumber(value, { useGrouping: false });
  if (Array.isArray(value)) return value.map((each) => formatValue(each, catalogue)).join(', ');
  if (isMessage(value)) return formatMessage(value, catalogue);
  if (typeof value === 'number') return String(value).replace('NaN', 'nan').replace('Infinity', 'inf');
  return String(value);
}

export function isMessage(value: unknown): value is Message {
  return typeof value === 'object' && value !== null && 'code' in value && typeof value.code === 'string';
}

function spellOut({ code, parameters = {} }: Message): string {
  return Object.keys(parameters).length === 0 ? code : `${code} ${JSON.stringify(parameters)}`;
}

type Print = (value: number, digits?: number) => string;

/** What numbers look like, as in core/words/catalogue.py. */
const NUMBERS: Record<string, Print> = {
  FIXED: (value, digits = 2) => printFixed(value, digits),
  SIGNIFICANT: (value, digits = 3) => printSignificant(value, digits),
  MILLI: (value, digits = 0) => printFixed(1e3 * value, digits),
  DEGREES: (value, digits = 1) => printFixed((180 / Math.PI) * value, digits),
  PERCENT: (value, digits = 0) => printFixed(100 * value, digits),
};

/** What is no number, such as `inf`, is said as it is. */
function fluentFunction(print: Print, language: Language) {
  const mark = decimalMark(language);
  return ([given]: FluentValue[], { digits }: Record<string, FluentValue>): string => {
    const plain = given instanceof FluentNumber || typeof given === 'string' ? given.valueOf() : Number.NaN;
    const value = plain === '' ? Number.NaN : Number(plain);
    if (!Number.isFinite(value)) return String(given);
    const shown = digits instanceof FluentNumber ? print(value, digits.value) : print(value);
    return shown.replace('.', mark);
  };
}

function decimalMark(language: Language): string {
  const parts = new Intl.NumberFormat(language).formatToParts(0.5);
  return parts.find(({ type }) => type === 'decimal')?.value ?? '.';
}

function printFixed(value: number, digits: number): string {
  if (Math.abs(value) >= LARGEST_FIXED) return `${BigInt(value)}.${'0'.repeat(digits)}`.replace(/\.$/, '');
  const shown = roundToEven(value.toFixed(digits), value.toFixed(ALL_DECIMALS), digits);
  return /^-[0.]+$/.test(shown) ? shown.slice(1) : shown;
}

function printSignificant(value: number, digits: number): string {
  const decimals = digits - 1;
  const [, exact = '', power] = /^(.+)e(.+)$/.exec(value.toExponential(ALL_DECIMALS)) ?? [];
  const [, rounded = '', exponent = power] = /^(.+)e(.+)$/.exec(value.toExponential(decimals)) ?? [];
  const e = Number(exponent);
  if (e >= SMALLEST_EXPONENT && e < digits)
    return withoutEndingZeros(
      roundToEven(value.toFixed(decimals - e), value.toFixed(ALL_DECIMALS), decimals - e),
    );
  return `${withoutEndingZeros(roundToEven(rounded, exact, decimals))}e${e}`;
}

/** What lies exactly between two goes to the even one, as in Python; JavaScript takes the larger. */
function roundToEven(rounded: string, exact: string, decimals: number): string {
  const end = exact.indexOf('.') + 1 + decimals;
  const cut = exact.slice(0, decimals === 0 ? end - 1 : end);
  return /^50*$/.test(exact.slice(end)) && /[02468]$/.test(cut) ? cut : rounded;
}

const withoutEndingZeros = (shown: string) => (shown.includes('.') ? shown.replace(/\.?0+$/, '') : shown);
