import { cells } from '../stores/cells';
import { words } from '../words';
import { Choice } from './choice';

interface Props {
  legend: string;
  chosen: string;
  choose: (name: string) => void;
}

/** One of the cells; one that cannot be used says why. */
export function CellChoice({ legend, chosen, choose }: Props) {
  return (
    <Choice
      legend={legend}
      options={(cells.value ?? []).map(({ name, title, flaw }) => ({
        value: name,
        label: name,
        note: flaw === null ? title : `${words.value.setup.unusable}: ${flaw}`,
        disabled: flaw !== null,
      }))}
      chosen={chosen}
      choose={choose}
    />
  );
}
