import { useEffect, useState } from 'preact/hooks';
import type { Message, OpenedTrial } from '../api';
import { MessageText } from '../ui/message-text';
import { attempt } from '../ui/notice';
import { words } from '../words';
import type { Language } from '../words/languages';
import { readSheet } from './trials';

interface Props {
  /** Of the trials. */
  id: string;
  trials: OpenedTrial[];
  language: Language;
}

/** How many trials were judged how, and the score sheet to keep. */
export function ScoreSheet({ id, trials, language }: Props) {
  const said = words.value.gap.trials;
  const [address, keep] = useState('');
  useEffect(() => {
    let made = '';
    void attempt(async () => {
      made = URL.createObjectURL(new Blob([await readSheet(id, language)], { type: 'text/markdown' }));
      keep(made);
    });
    return () => URL.revokeObjectURL(made);
  }, [id, language]);
  return (
    <section class="score-sheet">
      <h2>{said.score(trials.length)}</h2>
      <ul class="plain">
        {counted(trials).map(([mark, count]) => (
          <li key={mark.text}>
            <b>{count}</b> <MessageText message={mark} />
          </li>
        ))}
      </ul>
      <p class="downloads">
        <a class="download" href={address} download={`trials-${id}.md`}>
          {said.sheet}
        </a>
      </p>
    </section>
  );
}

/** Marks with how often they were given, the most frequent first. */
function counted(trials: OpenedTrial[]): [Message, number][] {
  const marks = new Map(trials.map(({ mark }) => [mark.text, mark]));
  const counts = [...marks.values()].map((mark): [Message, number] => [
    mark,
    trials.filter((each) => each.mark.text === mark.text).length,
  ]);
  return counts.sort(([, one], [, other]) => other - one);
}
