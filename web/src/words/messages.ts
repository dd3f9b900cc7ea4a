import { computed, signal } from '@preact/signals';
import { messageFiles } from '.';
import { formatMessage, formatPart, formatValue, isMessage, type Message, readCatalogue } from './catalogue';
import { byLanguage, type Language } from './languages';

type Files = Record<string, string>;

const LATER = byLanguage(import.meta.glob<Files>('./*-later.ts', { import: 'messages' }));
/** Of diagnoses and trials, once one of them was to be said. */
const later = signal<{ language: Language; files: Files } | null>(null);
/** Of which language they are on their way. */
let fetching: Language | null = null;

const catalogue = computed(() => {
  const { language, messages, transform } = messageFiles.value;
  const more = later.value?.language === language ? later.value.files : {};
  return readCatalogue(language, { ...messages, ...more }, transform);
});

/** Fetches the messages of diagnoses and trials in the chosen language. */
export async function fetchLaterMessages(): Promise<void> {
  const { language } = messageFiles.peek();
  if (later.peek()?.language === language || fetching === language) return;
  fetching = language;
  try {
    const files = await LATER[language]?.();
    if (files) later.value = { language, files };
  } finally {
    fetching = null;
  }
}

/** The catalogue, with what a message needs on its way; until that is here it is said as it came. */
function catalogueFor(value: unknown) {
  if (codesOf(value).some((code) => !catalogue.value.hasMessage(code)))
    void fetchLaterMessages().catch(() => undefined); // it is said in English, and asked for again with the next one
  return catalogue.value;
}

function codesOf(value: unknown): string[] {
  if (Array.isArray(value)) return value.flatMap(codesOf);
  return isMessage(value) ? [value.code, ...Object.values(value.parameters ?? {}).flatMap(codesOf)] : [];
}

/** A message of the engine or the service, in the chosen language. */
export const say = (message: Message): string => formatMessage(message, catalogueFor(message));

/** What was found, or what was expected in its place, of a message that says what is wrong with something. */
export const sayPart = (message: Message, part: 'found' | 'expected'): string =>
  formatPart(message, part, catalogueFor(message));

/** What a message names: a value, or a message itself. */
export const sayValue = (value: unknown): string => formatValue(value, catalogueFor(value));

/** Whether it is said in English in every language: words from outside, and messages that this console does not know. */
export const isEnglish = ({ code }: Message): boolean => code === 'text' || !catalogue.value.hasMessage(code);

/** Words from outside as a message. */
export const quote = (text: string): Message => ({ code: 'text', parameters: { text } });
