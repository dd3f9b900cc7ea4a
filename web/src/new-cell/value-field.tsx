import { NumberField } from '../ui/number-field';
import { edit, isUnread, textOf } from './draft';

interface Props {
  /** Of the value, under which it is typed. */
  name: string;
  label: string;
  /** As it was made, SI. */
  value: number | null | undefined;
  /** From SI to what is shown. */
  factor?: number;
  places?: number;
  hidden?: boolean;
}

/** A value of the new cell: as it was made, until somebody types another. */
export function ValueField({ name, label, value, factor = 1, places = 4, hidden = false }: Props) {
  return (
    <NumberField
      label={label}
      hidden={hidden}
      signed
      text={textOf(name, value, factor, places)}
      flaw={isUnread(name)}
      change={(text) => edit(name, text)}
    />
  );
}

interface ThreeProps {
  name: string;
  legend: string;
  values: number[] | undefined;
  factor?: number;
  places?: number;
}

/** Three of them, along x, y, z. */
export function ThreeFields({ name, legend, values, factor = 1, places = 4 }: ThreeProps) {
  return (
    <fieldset>
      <legend>{legend}</legend>
      <div class="three">
        {(['x', 'y', 'z'] as const).map((axis, k) => (
          <ValueField
            key={axis}
            name={`${name}.${axis}`}
            label={axis}
            value={values?.[k]}
            factor={factor}
            places={places}
          />
        ))}
      </div>
    </fieldset>
  );
}
