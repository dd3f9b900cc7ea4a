import type { Flaw } from '../api';
import { words } from '../words';
import { engineSaid } from '../words/engine-words';
import { EngineSentence } from './engine-sentence';

/** What cannot be used: where it is, what was found there and what would have been right. */
export function FlawSentence({ where, found, expected }: Flaw) {
  const said = words.value.cells;
  return (
    <>
      <b>
        <Phrase english={where} />
      </b>
      : {said.foundWord} <Phrase english={found} />
      {expected && (
        <>
          , {said.expected} <Phrase english={expected} />
        </>
      )}
    </>
  );
}

const Phrase = ({ english }: { english: string }) => (
  <EngineSentence said={engineSaid(english)} english={english} />
);
