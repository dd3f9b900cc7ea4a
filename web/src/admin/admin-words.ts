import type { admin } from '../words/en-admin';
import { pageWords } from '../words/page-words';

export type AdminWords = typeof admin;

/** The texts of administration in the chosen language; they are loaded with its pages, which most people never open. */
export const adminWords = pageWords(
  import.meta.glob<AdminWords>('../words/*-admin.ts', { eager: true, import: 'admin' }),
);
