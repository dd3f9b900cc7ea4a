import { words } from '../words';

interface Props {
  /** Of what went wrong, see the catalogue. */
  kind: string | null;
  /** As the service says it. */
  english: string;
}

/** What went wrong, in the chosen language as far as its kind is known there, and exactly. */
export function Told({ kind, english }: Props) {
  const said = words.value.problems[kind ?? ''];
  return (
    <p class="told" lang={said === undefined ? 'en' : undefined}>
      {said ?? english}
      {said !== undefined && said !== english && english && <small lang="en">{english}</small>}
    </p>
  );
}
