import { useEffect, useState } from 'preact/hooks';
import type { OpenedTrial } from '../api';
import { EngineSentence } from '../ui/engine-sentence';
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
          <li key={mark}>
            <b>{count}</b> <EngineSentence said={said.marks[mark]} english={mark} />
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
function counted(trials: OpenedTrial[]): [string, number][] {
  const marks = trials.map(({ mark }) => mark);
  const counts = [...new Set(marks)].map((mark): [string, number] => [
    mark,
    marks.filter((each) => each === mark).length,
  ]);
  return counts.sort(([, one], [, other]) => other - one);
}
