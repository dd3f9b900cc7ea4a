import { Choice } from '../ui/choice';
import { NothingYet } from '../ui/nothing-yet';
import { words } from '../words';
import { cells } from './cells';

interface Props {
  legend: string;
  chosen: string;
  choose: (name: string) => void;
}

/** One of the cells; one in which nothing can be planned says so, and can be looked at all the same. */
export function CellChoice({ legend, chosen, choose }: Props) {
  if (cells.value?.length === 0) return <NothingYet>{words.value.cells.noCells}</NothingYet>;
  return (
    <Choice
      legend={legend}
      options={(cells.value ?? []).map(({ name, title, flaw }) => ({
        value: name,
        label: name,
        note: flaw === null ? title : <Unusable />,
      }))}
      chosen={chosen}
      choose={choose}
    />
  );
}

const Unusable = () => (
  <>
    <span aria-hidden="true">▲</span> {words.value.cells.unusable}
  </>
);
