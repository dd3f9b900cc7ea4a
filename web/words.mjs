/**
 * The console's reading of the catalogue of messages, outside a browser.
 *
 * `node words.mjs check`: every language has every message with the same parts, and the sources name no other codes.
 * `node words.mjs say`: reads {questions: [{language, message, part?}], more} and writes what the console says; `more` are messages beside
 * those of the catalogue.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { text } from 'node:stream/consumers';
import { fileURLToPath } from 'node:url';
import { FluentResource } from '@fluent/bundle';
import { build } from 'vite';

const ROOT = fileURLToPath(new URL('.', import.meta.url));
const LANGUAGES = ['en', 'de'];
/** Files of messages that come with the pages that say them: `src/words/later-messages.ts`. */
const LATER = ['drafts', 'library', 'newcell'];
/** Where the sources name a code: compared with one, or given to a message. */
const NAMED = /(?<!typeof [\w.]*)\bcode\s*(?:===|!==|:)\s*'([a-z][a-z0-9-]*)'/g;

/** A module of the console, built as for a browser. */
async function readModule(file) {
  const { output } = await build({
    root: ROOT,
    configFile: false,
    logLevel: 'silent',
    ssr: { noExternal: true },
    build: { ssr: `src/words/${file}`, write: false },
  });
  return import(`data:text/javascript;base64,${Buffer.from(output[0].code).toString('base64')}`);
}

function readLater(language) {
  const read = (name) => readFileSync(join(ROOT, '..', 'core', 'words', language, `${name}.ftl`), 'utf8');
  return Object.fromEntries(LATER.map((name) => [name, read(name)]));
}

/** What there is to say: each code, and each part of one. */
function partsOf(catalogue) {
  return [...catalogue._messages].flatMap(([code, { value, attributes }]) => [
    code,
    ...(value === null ? [] : [`${code} as a whole`]),
    ...Object.keys(attributes).map((part) => `${code}.${part}`),
  ]);
}

function codesOfSources() {
  const files = readdirSync(join(ROOT, 'src'), { recursive: true }).filter((file) => /\.tsx?$/.test(file));
  return files.flatMap((file) =>
    [...readFileSync(join(ROOT, 'src', file), 'utf8').matchAll(NAMED)].map(([, code]) => ({ file, code })),
  );
}

/** What is wrong, a line each. */
function flawsOf(catalogues) {
  const said = catalogues.map((catalogue) => new Set(partsOf(catalogue)));
  const all = new Set(said.flatMap((each) => [...each]));
  const lacking = LANGUAGES.flatMap((language, k) =>
    [...all].filter((part) => !said[k].has(part)).map((part) => `core/words/${language} lacks ${part}`),
  );
  const unknown = codesOfSources().filter(({ code }) => !all.has(code));
  return [
    ...lacking,
    ...unknown.map(({ file, code }) => `src/${file} names ${code}, which core/words lacks`),
  ];
}

const { readCatalogue, formatMessage, formatPart } = await readModule('catalogue.ts');
const vocabularies = await Promise.all(LANGUAGES.map((language) => readModule(`all-${language}.ts`)));
const catalogues = LANGUAGES.map((language, k) =>
  readCatalogue(language, { ...vocabularies[k].messages, ...readLater(language) }),
);
if (process.argv[2] === 'say') {
  const { questions, more } = JSON.parse(await text(process.stdin));
  for (const catalogue of catalogues) catalogue.addResource(new FluentResource(more));
  const said = questions.map(({ language, message, part }) => {
    const catalogue = catalogues[LANGUAGES.indexOf(language)];
    return part ? formatPart(message, part, catalogue) : formatMessage(message, catalogue);
  });
  process.stdout.write(JSON.stringify(said));
} else {
  const flaws = flawsOf(catalogues);
  process.stderr.write(flaws.map((flaw) => `${flaw}\n`).join(''));
  process.exitCode = flaws.length === 0 ? 0 : 1;
}
