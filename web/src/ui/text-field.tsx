import { useId } from 'preact/hooks';

interface Props {
  label: string;
  text: string;
  change: (text: string) => void;
  /** What may be entered. */
  hint?: string;
  /** What is wrong with it as it stands. */
  flaw?: string | null;
  kind?: 'text' | 'password' | 'url' | 'date' | 'search';
  autocomplete?: string;
}

/** A field for a text; what is wrong with it stands below it, in words. */
export function TextField({
  label,
  text,
  change,
  hint = '',
  flaw = null,
  kind = 'text',
  autocomplete = 'off',
}: Props) {
  const below = useId();
  return (
    <div>
      <label class="field">
        <span>{label}</span>
        <input
          type={kind as 'text'}
          value={text}
          autocomplete={autocomplete}
          autocapitalize="off"
          spellcheck={false}
          aria-invalid={flaw !== null}
          aria-describedby={hint || flaw ? below : undefined}
          onInput={({ currentTarget }) => change(currentTarget.value)}
        />
      </label>
      {(hint || flaw) && (
        <p id={below} class={flaw === null ? 'hint' : 'hint flaw'}>
          {flaw ?? hint}
        </p>
      )}
    </div>
  );
}
