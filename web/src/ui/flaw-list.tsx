import type { ComponentChildren } from 'preact';
import type { Flaw } from '../api';
import { FlawSentence } from './flaw-sentence';

interface Props {
  title: string;
  flaws: Flaw[];
  /** What to do about it. */
  children?: ComponentChildren;
}

/** All that is wrong with something, under a heading that says with what. */
export function FlawList({ title, flaws, children }: Props) {
  return (
    <div class="warnings" role="alert">
      <h2>
        <span aria-hidden="true">▲</span> {title}
      </h2>
      {children}
      <ul>
        {flaws.map((flaw) => (
          <li key={flaw.where + flaw.found}>
            <FlawSentence {...flaw} />
          </li>
        ))}
      </ul>
    </div>
  );
}
