import { adminWords } from './admin-words';

/** Names that browsers and systems give themselves, the more particular first: Edge calls itself Chrome as well, and Android Linux. */
const BROWSERS: [RegExp, string][] = [
  [/Edg/, 'Edge'],
  [/OPR\//, 'Opera'],
  [/SamsungBrowser/, 'Samsung Internet'],
  [/Firefox|FxiOS/, 'Firefox'],
  [/Chrome|CriOS/, 'Chrome'],
  [/Safari/, 'Safari'],
];
const SYSTEMS: [RegExp, string][] = [
  [/iPad/, 'iPad'],
  [/iPhone/, 'iPhone'],
  [/Android/, 'Android'],
  [/Windows/, 'Windows'],
  [/Mac OS/, 'macOS'],
  [/CrOS/, 'ChromeOS'],
  [/Linux/, 'Linux'],
];

/** What a browser that names itself so is to people: "Chrome on Android". */
export function deviceOf(browser: string | null): string {
  const said = adminWords.value.account;
  const [name, system] = [BROWSERS, SYSTEMS].map(
    (known) => known.find(([mark]) => mark.test(browser ?? ''))?.[1],
  );
  return name && system ? said.deviceOn(name, system) : (name ?? system ?? said.unknownDevice);
}
