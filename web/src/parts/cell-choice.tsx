import type { Flaw } from '../api';
import { cells } from '../stores/cells';
import { words } from '../words';
import { Choice } from './choice';
import { FlawSentence } from './flaw-sentence';

interface Props {
  legend: string;
  chosen: string;
  choose: (name: string) => void;
}

/** One of the cells; one in which nothing can be planned says why, and can be looked at all the same. */
export function CellChoice({ legend, chosen, choose }: Props) {
  return (
    <Choice
      legend={legend}
      options={(cells.value ?? []).map(({ name, title, flaws: [flaw] }) => ({
        value: name,
        label: name,
        note: flaw ? <Unusable flaw={flaw} /> : title,
      }))}
      chosen={chosen}
      choose={choose}
    />
  );
}

function Unusable({ flaw }: { flaw: Flaw }) {
  return (
    <>
      <span aria-hidden="true">▲</span> {words.value.setup.unusable}: <FlawSentence {...flaw} />
    </>
  );
}
