import { useSignal } from '@preact/signals';
import type { AccountPublic, Role } from '../api';
import { session } from '../session/session';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { RoleChoice } from './roles';
import { passwordLacking } from './rules';

interface Props {
  account: AccountPublic;
  close: (told?: string) => Promise<void>;
}

/** Other roles or another password for somebody; who forgot theirs gets a new one here. */
export function ChangeAccount({ account, close }: Props) {
  const said = adminWords.value.people;
  const roles = useSignal<Role[]>(account.roles);
  const password = useSignal('');
  const unchanged = sorted(roles.value) === sorted(account.roles) && password.value === '';
  const flaw = password.value === '' ? null : passwordLacking(password.value);
  const lacking = flaw ?? (roles.value.length === 0 ? said.needRole : unchanged ? said.nothing : null);
  const save = async () => {
    const body = { roles: roles.value, ...(password.value === '' ? {} : { password: password.value }) };
    await ask('PATCH /api/accounts/{account}', { path: { account: account.name }, body });
    await close(said.saved(account.name));
  };
  return (
    <div class="stack">
      <div class="halves">
        <RoleChoice
          chosen={roles.value}
          choose={(chosen) => {
            roles.value = chosen;
          }}
        />
        <TextField
          label={said.newPassword}
          hint={password.value === '' ? said.keepPassword : said.passwordRule}
          autocomplete="new-password"
          text={password.value}
          change={(text) => {
            password.value = text;
          }}
        />
      </div>
      <small>{account.name === session.value?.name ? said.signsYouOut : said.signsOut}</small>
      <div class="row">
        <ActWhen lacking={lacking} act={save}>
          {said.save}
        </ActWhen>
        <Press act={() => close()}>{adminWords.value.cancel}</Press>
      </div>
    </div>
  );
}

const sorted = (roles: Role[]) => [...roles].sort().join();
