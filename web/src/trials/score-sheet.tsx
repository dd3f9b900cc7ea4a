import { useEffect, useState } from 'preact/hooks';
import type { Message, OpenedTrial } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';

interface Props {
  /** Of the trials, for the file's name. */
  name: string;
  trials: OpenedTrial[];
  /** Markdown. */
  sheet: string;
}

/** How many trials were judged how, and the score sheet to keep. */
export function ScoreSheet({ name, trials, sheet }: Props) {
  const said = words.value.gap.trials;
  const [address, keep] = useState('');
  useEffect(() => {
    const made = URL.createObjectURL(new Blob([sheet], { type: 'text/markdown' }));
    keep(made);
    return () => URL.revokeObjectURL(made);
  }, [sheet]);
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
        <a class="download" href={address} download={`trials-${name}.md`}>
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
