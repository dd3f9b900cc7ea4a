import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';

export interface Option<T extends string> {
  value: T;
  label: ComponentChildren;
  note?: ComponentChildren;
  disabled?: boolean;
}

interface Props<T extends string> {
  legend: string;
  options: Option<T>[];
  chosen: string;
  choose: (value: T) => void;
  /** Side by side, for short labels. */
  inRow?: boolean;
}

/** One of several, all to be seen at once. */
export function Choice<T extends string>({ legend, options, chosen, choose, inRow = false }: Props<T>) {
  const name = useId();
  return (
    <fieldset class="choice">
      <legend>{legend}</legend>
      <div class={inRow ? 'options in-row' : 'options'}>
        {options.map(({ value, label, note, disabled = false }) => (
          <label class="option" key={value}>
            <input
              type="radio"
              name={name}
              checked={value === chosen}
              disabled={disabled}
              onChange={() => choose(value)}
            />
            <span>
              <b>{label}</b>
              {note && <small>{note}</small>}
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
