import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { attempt } from '../ui/notice';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { ActiveRobots } from './active-robots';
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
  const name = useSignal('');
  const password = useSignal('');
  const first = useRef<HTMLInputElement>(null);
  useEffect(() => first.current?.focus(), []);
  const submitted = (event: Event) => {
    event.preventDefault();
    void attempt(() => signIn(name.value, password.value));
  };
  return (
    <form class="sign-in" onSubmit={submitted}>
      <h1>{said.title}</h1>
      <label class="field">
        <span>{said.name}</span>
        <input
          name="username"
          autocomplete="username"
          autocapitalize="off"
          required
          ref={first}
          onInput={({ currentTarget }) => {
            name.value = currentTarget.value;
          }}
        />
      </label>
      <label class="field">
        <span>{said.password}</span>
        <input
          name="password"
          type="password"
          autocomplete="current-password"
          required
          onInput={({ currentTarget }) => {
            password.value = currentTarget.value;
          }}
        />
      </label>
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
