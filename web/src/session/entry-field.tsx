import type { Ref } from 'preact';
import { useId } from 'preact/hooks';

interface Props {
  label: string;
  /** As the browser's own memory of names and passwords knows it. */
  name: 'username' | 'password' | 'new-password';
  autocomplete: 'username' | 'current-password' | 'new-password';
  /** What is missing; null while nothing is. */
  flaw: string | null;
  field: Ref<HTMLInputElement>;
  change: (text: string) => void;
}

/** A field of those who sign in; what it lacks stands below it, in the page's own words. */
export function EntryField({ label, name, autocomplete, flaw, field, change }: Props) {
  const below = useId();
  return (
    <div>
      <label class="field">
        <span>{label}</span>
        <input
          name={name}
          type={(name === 'username' ? 'text' : 'password') as 'text'}
          autocomplete={autocomplete}
          autocapitalize="off"
          ref={field}
          aria-invalid={flaw !== null}
          aria-describedby={flaw === null ? undefined : below}
          onInput={({ currentTarget }) => change(currentTarget.value)}
        />
      </label>
      {flaw !== null && (
        <p id={below} class="hint flaw" role="alert">
          {flaw}
        </p>
      )}
    </div>
  );
}
