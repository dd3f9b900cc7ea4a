interface Props {
  label: string;
  hidden?: boolean;
  /** Whether it may be below zero: not every tablet has a minus on its keyboard of numbers. */
  signed?: boolean;
  text: string;
  flaw: boolean;
  change: (text: string) => void;
}

/** A field for a number, with the keyboard for it. */
export function NumberField({ label, hidden = false, signed = false, text, flaw, change }: Props) {
  return (
    <label class="field">
      <span class={hidden ? 'out-of-sight' : ''}>{label}</span>
      <input
        inputMode={signed ? 'text' : 'decimal'}
        value={text}
        aria-invalid={flaw}
        onInput={({ currentTarget }) => change(currentTarget.value)}
      />
    </label>
  );
}
