import '../look/help.css';
import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { language } from '../session/settings';
import { until } from '../ui/connection';
import { notThere } from '../ui/not-there-page';
import { Reading } from '../ui/reading';
import { route, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { helpWords } from './help-words';
import { Markdown, slugOf } from './markdown';

/** The manual's pages, which are the documents of the sources. */
const PAGES = Object.fromEntries(
  Object.entries(import.meta.glob<string>('../../../docs/*.md', { query: '?raw', import: 'default' })).map(
    ([file, load]) => [file.replace(/^.*\/|\.md$/g, ''), load],
  ),
);
const shown = signal<{ page: string; text: string } | null>(null);

function pageHere(): string {
  return route.value[1] ?? 'console';
}

async function load(page: string): Promise<void> {
  const text = await PAGES[page]?.();
  if (text !== undefined && page === pageHere()) shown.value = { page, text };
}

function Manual() {
  const page = pageHere();
  const heading = route.value[2];
  const text = shown.value?.page === page ? shown.value.text : null;
  useEffect(() => until(() => load(page)), [page]);
  useEffect(() => {
    if (text !== null && heading) document.getElementById(slugOf(heading))?.scrollIntoView();
  }, [text, heading]);
  if (text === null) return <Reading />;
  return (
    <article class="page manual" lang="en">
      <nav aria-label={helpWords.value.pages}>
        {Object.keys(PAGES).map((each) => (
          <a key={each} href={to('manual', each)} aria-current={each === page ? 'page' : undefined}>
            {each}
          </a>
        ))}
      </nav>
      {language.value !== 'en' && (
        <p class="hint" lang={language.value}>
          {helpWords.value.inEnglish}
        </p>
      )}
      <Markdown text={text} />
    </article>
  );
}

const manual: Screen = { Page: Manual, next: () => helpWords.value.nextManual };

/** A page of the manual, if there is one of that name. */
export const manualScreen = (): Screen => (pageHere() in PAGES ? manual : notThere);
