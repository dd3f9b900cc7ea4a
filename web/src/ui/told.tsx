import type { Flaw } from '../api';
import { words } from '../words';
import { engineSaid } from '../words/engine-words';
import { EngineSentence } from './engine-sentence';
import { FlawSentence } from './flaw-sentence';

interface Props {
  /** Of what went wrong, see the catalogue. */
  kind: string | null;
  /** As the service says it. */
  english: string;
  /** A sentence with its figures, where one is known that says more than its kind. */
  said?: string | null;
  /** What cannot be used, where it is about that. */
  flaws?: Flaw[] | undefined;
}

/** What went wrong, in the chosen language as far as its kind is known there, and exactly. */
export function Told({ kind, english, said: figures = null, flaws: [first] = [] }: Props) {
  const said = figures ?? words.value.problems[kind ?? ''];
  if (said === undefined)
    return (
      <p class="told" lang="en">
        {english}
      </p>
    );
  return (
    <p class="told">
      {said}
      {first ? (
        <small>
          <FlawSentence {...first} />
        </small>
      ) : (
        english &&
        english !== said && (
          <small>
            <EngineSentence said={engineSaid(english)} english={english} />
          </small>
        )
      )}
    </p>
  );
}
