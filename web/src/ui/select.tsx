interface Props {
  label: string;
  /** Values and what they are called. */
  options: [string, string][];
  chosen: string;
  choose: (value: string) => void;
}

/** One of many, or of a few where there is no room to see them all at once. */
export function Select({ label, options, chosen, choose }: Props) {
  return (
    <label class="field">
      <span>{label}</span>
      <select value={chosen} onChange={({ currentTarget }) => choose(currentTarget.value)}>
        {options.map(([value, text]) => (
          <option key={value} value={value}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}
