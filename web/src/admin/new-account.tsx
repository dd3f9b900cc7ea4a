import { useSignal } from '@preact/signals';
import type { Role } from '../api';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { RoleChoice } from './roles';
import { nameFlaw, passwordLacking } from './rules';

interface Props {
  /** Of the accounts that there are. */
  names: string[];
  close: (told?: string) => Promise<void>;
}

/** Somebody who is to sign in from now on. */
export function NewAccount({ names, close }: Props) {
  const said = adminWords.value.people;
  const name = useSignal('');
  const password = useSignal('');
  const roles = useSignal<Role[]>(['operator']);
  const flaw = nameFlaw(name.value, names, said.taken);
  const lacking =
    flaw ??
    (name.value === ''
      ? said.needName
      : (passwordLacking(password.value) ?? (roles.value.length === 0 ? said.needRole : null)));
  const create = async () => {
    await ask('POST /api/accounts', {
      body: { name: name.value, password: password.value, roles: roles.value },
    });
    await close(said.created(name.value));
  };
  return (
    <section class="tile stack">
      <h2>{said.add}</h2>
      <div class="halves">
        <div class="stack">
          <TextField
            label={said.name}
            hint={said.nameRule}
            flaw={flaw}
            text={name.value}
            change={(text) => {
              name.value = text;
            }}
          />
          <TextField
            label={said.password}
            hint={said.passwordRule}
            autocomplete="new-password"
            text={password.value}
            change={(text) => {
              password.value = text;
            }}
          />
        </div>
        <RoleChoice
          chosen={roles.value}
          choose={(chosen) => {
            roles.value = chosen;
          }}
        />
      </div>
      <div class="row">
        <ActWhen lacking={lacking} act={create}>
          {said.create}
        </ActWhen>
        <Press act={() => close()}>{adminWords.value.cancel}</Press>
      </div>
    </section>
  );
}
