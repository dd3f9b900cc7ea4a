import { computed, effect, signal } from '@preact/signals';
import { language } from '../session/settings';
import type { Words } from './en';
import { type Language, VOCABULARIES } from './languages';
import { lengthen, longer } from './longer';

/** All that is said in one language, but for what comes with a page. */
export interface Vocabulary {
  own: Words;
  /** Files of messages, see `./catalogue`. */
  messages: Record<string, string>;
}

const RETRY_MS = 1000;

/** `?words=longer` in the address shows how the console looks in a language with longer words than English. */
export const isLonger = new URLSearchParams(location.search).get('words') === 'longer';

const loaded = signal<(Vocabulary & { language: Language }) | null>(null);

async function load(wanted: Language): Promise<void> {
  try {
    const found = await VOCABULARIES[wanted]?.();
    if (found && wanted === wantedLanguage()) loaded.value = { ...found, language: wanted };
  } catch {
    setTimeout(() => wanted === wantedLanguage() && void load(wanted), RETRY_MS);
  }
}

function wantedLanguage(): Language {
  return isLonger ? 'en' : language.value;
}

effect(() => void load(wantedLanguage()));

/** Settled as soon as there are words to show; nothing that shows words is to be loaded before. */
export const wordsLoaded = new Promise<void>((settle) => {
  effect(() => {
    if (loaded.value !== null) settle();
  });
});

const vocabulary = computed(() => {
  if (loaded.value === null) throw new Error('words are asked for before any are loaded');
  return loaded.value;
});

/** Every text of the console in the chosen language. */
export const words = computed<Words>(() => (isLonger ? longer(vocabulary.value.own) : vocabulary.value.own));

/** The files of messages in the same language, and how their words are to be changed. */
export const messageFiles = computed(() => ({
  ...vocabulary.value,
  transform: isLonger ? lengthen : (text: string) => text,
}));
