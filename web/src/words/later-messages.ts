import { effect } from '@preact/signals';
import { language } from '../session/settings';
import { isLonger } from '.';
import { addMessages } from './messages';

/** Messages that few pages say, by file; `all-en.ts` and `all-de.ts` leave them out. */
const FILES = import.meta.glob<string>('../../../core/words/*/{drafts,library,newcell}.ftl', {
  query: '?raw',
  import: 'default',
});

/** Loads files of messages with the page that says them, in whatever language is chosen. */
export function loadMessages(...names: ('drafts' | 'library' | 'newcell')[]): void {
  effect(() => {
    const spoken = isLonger ? 'en' : language.value;
    for (const name of names) {
      const file = FILES[`../../../core/words/${spoken}/${name}.ftl`];
      void file?.().then((words) => addMessages(spoken, { [name]: words }));
    }
  });
}
