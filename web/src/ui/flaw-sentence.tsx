import type { Flaw } from '../api';
import { words } from '../words';
import { sayPart, sayValue } from '../words/messages';

/** What cannot be used: where it is, what was found there and what would have been right. */
export function FlawSentence({ where, found, expected, code, parameters = {} }: Flaw) {
  const said = words.value.cells;
  const part = (name: 'found' | 'expected', text: string) => sayPart({ code, parameters, text }, name);
  return (
    <>
      <b>{sayValue(parameters.where ?? where)}</b>: {said.foundWord} {part('found', found)}, {said.expected}{' '}
      {part('expected', expected)}
    </>
  );
}
