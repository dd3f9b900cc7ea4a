import { useSignal } from '@preact/signals';
import type { AccountPublic } from '../api';
import { session } from '../session/session';
import { AskFirst } from '../ui/ask-first';
import { ask } from '../ui/client';
import { Press } from '../ui/press';
import { moment } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { ChangeAccount } from './change-account';
import { NewAccount } from './new-account';
import { namesOf } from './roles';

/** Everybody who may sign in, as what, and on how many devices they are. */
export function PeopleSection() {
  const said = adminWords.value.people;
  const { answer, again } = useAnswer(() => ask('GET /api/accounts'), 10_000);
  const open = useSignal<string | null>(null);
  const told = useSignal('');
  const all = answer.value ?? [];
  const close = async (what = '') => {
    told.value = what;
    open.value = null;
    await again();
  };
  const show = (name: string) => {
    told.value = '';
    open.value = name;
  };
  return (
    <>
      {told.value && <p role="status">✓ {told.value}</p>}
      {open.value === '' ? (
        <NewAccount names={all.map(({ name }) => name)} close={close} />
      ) : (
        <div class="row">
          <Press act={() => show('')}>{said.add}</Press>
        </div>
      )}
      <ul class="tiles">
        {all.map((each) => (
          <li class="tile" key={each.name}>
            <Summary account={each} />
            {open.value === each.name ? (
              <ChangeAccount account={each} close={close} />
            ) : (
              <Acts account={each} again={again} change={() => show(each.name)} />
            )}
          </li>
        ))}
      </ul>
    </>
  );
}

function Summary({ account }: { account: AccountPublic }) {
  const said = adminWords.value.people;
  const own = account.name === session.value?.name;
  return (
    <div>
      <b>
        <code>{account.name}</code>
      </b>
      {own && <span class="mark">{said.you}</span>}
      {account.disabled && <span class="mark">{said.disabled}</span>}
      <span>{namesOf(account.roles)}</span>
      <small>
        {said.signedIn(account.sessions)}, {said.since(moment(account.created_at))}
      </small>
    </div>
  );
}

interface ActsProps {
  account: AccountPublic;
  again: () => Promise<void>;
  change: () => void;
}

function Acts({ account, again, change }: ActsProps) {
  const said = adminWords.value.people;
  const { name, disabled, sessions } = account;
  const own = name === session.value?.name;
  const patch = async (body: { disabled?: boolean }) => {
    await ask('PATCH /api/accounts/{account}', { path: { account: name }, body });
    await again();
  };
  return (
    <div class="acts">
      <div class="row">
        <Press act={change}>{said.change}</Press>
        {disabled && <Press act={() => patch({ disabled: false })}>{said.enable}</Press>}
        {!disabled && !own && (
          <AskFirst
            label={said.disable}
            question={said.disableAsk(name)}
            yes={said.disableYes}
            act={() => patch({ disabled: true })}
          />
        )}
        {!own && sessions > 0 && (
          <AskFirst
            label={said.signOut}
            question={said.signOutAsk(name)}
            yes={said.signOutYes}
            act={() => patch({})}
          />
        )}
      </div>
      {own && <small>{said.disableSelf}</small>}
    </div>
  );
}
