import { words } from '../words';
import { helpOpen } from './help';

/** The way to what this screen is for, on every page. */
export function HelpButton() {
  return (
    <button
      type="button"
      class="help-button"
      aria-label={words.value.help.open}
      aria-expanded={helpOpen.value}
      onClick={() => {
        helpOpen.value = !helpOpen.value;
      }}
    >
      <b aria-hidden="true">?</b>
    </button>
  );
}
