import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { attempt } from '../ui/notice';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { ActiveRobots } from './active-robots';
import { EntryField } from './entry-field';
import { FirstSignIn, firstAccount } from './first-sign-in';
import { signIn } from './signing-in';

function Entrance() {
  const first = firstAccount();
  return (
    <div class="page entrance">
      <ActiveRobots />
      {first === null ? <SignIn /> : <FirstSignIn {...first} />}
    </div>
  );
}

function SignIn() {
  const said = words.value.signIn;
  const [name, password] = [useSignal(''), useSignal('')];
  const first = useRef<HTMLInputElement>(null);
  const second = useRef<HTMLInputElement>(null);
  const sent = useSignal(false);
  useEffect(() => first.current?.focus(), []);
  const submitted = (event: Event) => {
    event.preventDefault();
    sent.value = true;
    const empty = name.value.trim() === '' ? first : password.value === '' ? second : null;
    if (empty) empty.current?.focus();
    else void attempt(() => signIn(name.value, password.value));
  };
  return (
    <form class="sign-in" noValidate onSubmit={submitted}>
      <h1>{said.title}</h1>
      <EntryField
        label={said.name}
        name="username"
        autocomplete="username"
        flaw={sent.value && name.value.trim() === '' ? said.lackName : null}
        field={first}
        change={(text) => {
          name.value = text;
        }}
      />
      <EntryField
        label={said.password}
        name="password"
        autocomplete="current-password"
        flaw={sent.value && password.value === '' ? said.lackPassword : null}
        field={second}
        change={(text) => {
          password.value = text;
        }}
      />
      <button type="submit" class="press press-primary">
        {said.act}
      </button>
      <p class="hint">{said.first}</p>
    </form>
  );
}

export const signingIn: Screen = {
  Page: Entrance,
  next: () => (firstAccount() === null ? words.value.signIn.next : words.value.signIn.chooseNext),
};
