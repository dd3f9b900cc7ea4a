import { useEffect, useState } from 'preact/hooks';
import { words } from '../words';

/** The score sheet of trials, to read and to keep. */
export function ScoreSheet({ trials, sheet }: { trials: string; sheet: string }) {
  const said = words.value.gap.trials;
  const [address, keep] = useState('');
  useEffect(() => {
    const made = URL.createObjectURL(new Blob([sheet], { type: 'text/markdown' }));
    keep(made);
    return () => URL.revokeObjectURL(made);
  }, [sheet]);
  return (
    <section class="score-sheet">
      <p class="downloads">
        <a class="download" href={address} download={`trials-${trials}.md`}>
          {said.sheet}
        </a>
      </p>
      <details class="others">
        <summary>{said.sheet}</summary>
        <pre lang="en">{sheet}</pre>
      </details>
    </section>
  );
}
