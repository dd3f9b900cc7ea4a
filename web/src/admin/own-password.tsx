import { useSignal } from '@preact/signals';
import { session } from '../session/session';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { SHORTEST_PASSWORD } from './rules';

/** A new password in place of one's own. */
export function OwnPassword() {
  const said = adminWords.value.account;
  const present = useSignal('');
  const chosen = useSignal('');
  const shown = useSignal(false);
  const changed = useSignal(false);
  const kind = shown.value ? 'text' : 'password';
  const missing = SHORTEST_PASSWORD - chosen.value.length;
  const lacking =
    present.value === ''
      ? said.needPresent
      : missing > 0
        ? said.tooShort(missing)
        : chosen.value === present.value
          ? said.same
          : null;
  const change = async () => {
    changed.value = false;
    await ask('PUT /api/session/password', {
      body: { password: present.value, new_password: chosen.value },
    });
    present.value = '';
    chosen.value = '';
    changed.value = true;
  };
  return (
    <section>
      <h2>{said.password}</h2>
      <form class="stack" onSubmit={(event) => event.preventDefault()}>
        <input type="text" hidden autocomplete="username" value={session.value?.name ?? ''} readOnly />
        <TextField
          label={said.present}
          kind={kind}
          autocomplete="current-password"
          text={present.value}
          change={(text) => {
            present.value = text;
          }}
        />
        <TextField
          label={said.chosen}
          kind={kind}
          autocomplete="new-password"
          hint={said.rule}
          text={chosen.value}
          change={(text) => {
            chosen.value = text;
          }}
        />
        <label class="option">
          <input
            type="checkbox"
            checked={shown.value}
            onChange={() => {
              shown.value = !shown.value;
            }}
          />
          <span>{said.show}</span>
        </label>
        <ActWhen lacking={lacking} act={change}>
          {said.change}
        </ActWhen>
        {changed.value && <p role="status">✓ {said.changed}</p>}
      </form>
    </section>
  );
}
