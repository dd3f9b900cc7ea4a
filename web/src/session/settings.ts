import { computed, effect, signal } from '@preact/signals';
import { kept, oneOf } from '../ui/kept';
import { LANGUAGES, preferred } from '../words/languages';

export const UNITS = ['si', 'mm_g'] as const;
export const THEMES = ['system', 'light', 'dark'] as const;

export type Units = (typeof UNITS)[number];

export const language = kept('language', preferred, oneOf(LANGUAGES));
export const units = kept('units', 'si', oneOf(UNITS));
export const theme = kept('theme', 'system', oneOf(THEMES));

effect(() => {
  document.documentElement.lang = language.value;
});
effect(() => {
  document.documentElement.dataset.theme = theme.value;
});

const darkDevice = matchMedia('(prefers-color-scheme: dark)');
const deviceIsDark = signal(darkDevice.matches);
darkDevice.addEventListener('change', ({ matches }) => {
  deviceIsDark.value = matches;
});
/** Whether screens are dark now. */
export const dark = computed(() => (theme.value === 'system' ? deviceIsDark.value : theme.value === 'dark'));
