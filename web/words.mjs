/**
 * The console's reading of the words in every language, outside a browser. The languages are those that have files.
 *
 * `node words.mjs check`: every language has every text of the console and every message with the same parts, and the sources name no
 * other codes.
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
const OWN = join(ROOT, 'src', 'words');
const MESSAGES = join(ROOT, '..', 'core', 'words');
/** Where the sources name a code: compared with one, or given to a message. */
const NAMED = /(?<!typeof [\w.]*)\bcode\s*(?:===|!==|:)\s*'([a-z][a-z0-9-]*)'/g;

const ENGLISH = 'en';
/** Every language of which there is any file: one that is only begun is not passed over. */
const LANGUAGES = [...new Set([ENGLISH, ...languagesOfConsole(), ...languagesOfMessages()])];

function languagesOfConsole() {
  return readdirSync(OWN).flatMap((file) => /^(\w+)-all\.ts$/.exec(file)?.[1] ?? []);
}

function languagesOfMessages() {
  return readdirSync(MESSAGES, { withFileTypes: true })
    .filter(
      (each) =>
        each.isDirectory() && readdirSync(join(MESSAGES, each.name)).some((file) => file.endsWith('.ftl')),
    )
    .map((each) => each.name);
}

/** The console's own files of a language, named as those of every other: `-all.ts` is `en-all.ts` in English. */
function filesOf(language) {
  return readdirSync(OWN)
    .filter((file) => file === `${language}.ts` || (file.startsWith(`${language}-`) && file.endsWith('.ts')))
    .map((file) => file.slice(language.length));
}

/** Modules of the console, built as for a browser, each as a namespace under its name. */
async function readModules(files) {
  const imports = files.map((file, k) => `export * as m${k} from '${join(OWN, file)}';`).join('\n');
  const { output } = await build({
    root: ROOT,
    configFile: false,
    logLevel: 'silent',
    ssr: { noExternal: true },
    plugins: [
      {
        name: 'several',
        resolveId: (id) => (id.endsWith('several-modules') ? 'several-modules' : null),
        load: (id) => (id === 'several-modules' ? imports : null),
      },
    ],
    build: { ssr: 'several-modules', write: false },
  });
  const built = await import(`data:text/javascript;base64,${Buffer.from(output[0].code).toString('base64')}`);
  return Object.fromEntries(files.map((file, k) => [file, built[`m${k}`]]));
}

/** Where there are texts in what a module exports: `admin.people.add`. */
function pathsOf(value) {
  if (typeof value !== 'object' || value === null) return [''];
  return Object.entries(value).flatMap(([key, each]) =>
    pathsOf(each).map((path) => (path ? `${key}.${path}` : key)),
  );
}

/** What a language's own files lack that the English ones have. A module may call what it exports after its language: `de.nav.work`. */
async function lackingTexts(language) {
  const [english, theirs] = [filesOf(ENGLISH), filesOf(language)];
  const missing = english.filter((file) => !theirs.includes(file));
  const both = english.filter((file) => theirs.includes(file) && !/^-(all|later)\.ts$/.test(file));
  const [ours, found] = await Promise.all(
    [ENGLISH, language].map((each) => readModules(both.map((file) => `${each}${file}`))),
  );
  const textsOf = (each, file, modules) =>
    pathsOf(modules[`${each}${file}`]).map((path) =>
      path.replace(new RegExp(`^(?:${each}|${ENGLISH})(?=[A-Z.]|$)`), '*'),
    );
  return [
    ...missing.map((file) => `web/src/words lacks ${language}${file}`),
    ...both.flatMap((file) => {
      const said = new Set(textsOf(language, file, found));
      const lacks = textsOf(ENGLISH, file, ours).filter((path) => !said.has(path));
      return lacks.map((path) => `web/src/words/${language}${file} lacks ${path}`);
    }),
  ];
}

/** What there is to say in a language: each code, and each part of one. */
function partsOf(language) {
  const folder = join(MESSAGES, language);
  const files = readdirSync(folder).filter((file) => file.endsWith('.ftl'));
  const { body } = new FluentResource(
    files.map((file) => readFileSync(join(folder, file), 'utf8')).join('\n'),
  );
  return body.flatMap(({ id, value, attributes }) => [
    id,
    ...(value === null ? [] : [`${id} as a whole`]),
    ...Object.keys(attributes).map((part) => `${id}.${part}`),
  ]);
}

function codesOfSources() {
  const files = readdirSync(join(ROOT, 'src'), { recursive: true }).filter((file) => /\.tsx?$/.test(file));
  return files.flatMap((file) =>
    [...readFileSync(join(ROOT, 'src', file), 'utf8').matchAll(NAMED)].map(([, code]) => ({ file, code })),
  );
}

/** What is wrong, a line each. */
async function findFlaws() {
  const worded = languagesOfMessages();
  const said = new Map(worded.map((language) => [language, new Set(partsOf(language))]));
  const all = new Set([...said.values()].flatMap((each) => [...each]));
  const others = LANGUAGES.filter((language) => language !== ENGLISH);
  return [
    ...LANGUAGES.filter((language) => !worded.includes(language)).map(
      (language) => `core/words lacks ${language}`,
    ),
    ...worded.flatMap((language) =>
      [...all]
        .filter((part) => !said.get(language).has(part))
        .map((part) => `core/words/${language} lacks ${part}`),
    ),
    ...(await Promise.all(others.map(lackingTexts))).flat(),
    ...codesOfSources()
      .filter(({ code }) => !all.has(code))
      .map(({ file, code }) => `src/${file} names ${code}, which core/words lacks`),
  ];
}

async function answerQuestions() {
  const { questions, more } = JSON.parse(await text(process.stdin));
  const files = LANGUAGES.flatMap((language) => [`${language}-all.ts`, `${language}-later.ts`]);
  const modules = await readModules(['catalogue.ts', ...files]);
  const { readCatalogue, formatMessage, formatPart } = modules['catalogue.ts'];
  const catalogues = new Map(
    LANGUAGES.map((language) => {
      const messages = {
        ...modules[`${language}-all.ts`].messages,
        ...modules[`${language}-later.ts`].messages,
      };
      return [language, readCatalogue(language, messages)];
    }),
  );
  for (const catalogue of catalogues.values()) catalogue.addResource(new FluentResource(more));
  return questions.map(({ language, message, part }) => {
    const catalogue = catalogues.get(language);
    return part ? formatPart(message, part, catalogue) : formatMessage(message, catalogue);
  });
}

if (process.argv[2] === 'say') {
  process.stdout.write(JSON.stringify(await answerQuestions()));
} else {
  const flaws = await findFlaws();
  process.stderr.write(flaws.map((flaw) => `${flaw}\n`).join(''));
  process.exitCode = flaws.length === 0 ? 0 : 1;
}
