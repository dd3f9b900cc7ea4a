import { computed, signal } from '@preact/signals';
import { messageFiles } from '.';
import { formatMessage, formatPart, formatValue, type Message, readCatalogue } from './catalogue';

/** Messages that come with the pages that say them, by language. */
const later = signal<Record<string, Record<string, string>>>({});

/** Adds files of messages to those of a language. */
export function addMessages(language: string, files: Record<string, string>): void {
  later.value = { ...later.value, [language]: { ...later.value[language], ...files } };
}

const catalogue = computed(() => {
  const { language, messages, transform } = messageFiles.value;
  return readCatalogue(language, { ...messages, ...later.value[language] }, transform);
});

/** A message of the engine or the service, in the chosen language. */
export const say = (message: Message): string => formatMessage(message, catalogue.value);

/** What was found, or what was expected in its place, of a message that says what is wrong with something. */
export const sayPart = (message: Message, part: 'found' | 'expected'): string =>
  formatPart(message, part, catalogue.value);

/** What a message names: a value, or a message itself. */
export const sayValue = (value: unknown): string => formatValue(value, catalogue.value);

/** Whether it is said in English in every language: words from outside, and messages that this console does not know. */
export const isEnglish = ({ code }: Message): boolean => code === 'text' || !catalogue.value.hasMessage(code);

/** Words from outside as a message. */
export const quote = (text: string): Message => ({ code: 'text', parameters: { text } });
