import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { attempt } from '../ui/notice';
import { go, route } from '../ui/route';
import { words } from '../words';
import { EntryField } from './entry-field';
import { signInFirst } from './signing-in';

const SHORTEST = 12;

/** What the address gives that the service printed at its first start, `#/first/NAME/PASSWORD`; null elsewhere. */
export function firstAccount(): { name: string; password: string } | null {
  const [page, name, password] = route.value;
  return page === 'first' && name && password ? { name, password } : null;
}

/** Asks whoever comes by that address for a password of their own, and signs them in with it. */
export function FirstSignIn({ name, password }: { name: string; password: string }) {
  const said = words.value.signIn;
  const chosen = useSignal('');
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.focus(), []);
  const sent = useSignal(false);
  const submitted = (event: Event) => {
    event.preventDefault();
    sent.value = true;
    if (chosen.value.length < SHORTEST) field.current?.focus();
    else
      void attempt(async () => {
        await signInFirst(name, password, chosen.value);
        go();
      });
  };
  return (
    <form class="sign-in" noValidate onSubmit={submitted}>
      <h1>{said.welcome}</h1>
      <input type="hidden" name="username" autocomplete="username" value={name} />
      <EntryField
        label={said.choose(name)}
        name="new-password"
        autocomplete="new-password"
        flaw={sent.value && chosen.value.length < SHORTEST ? said.tooShort(SHORTEST) : null}
        field={field}
        change={(text) => {
          chosen.value = text;
        }}
      />
      <p class="hint">{said.chooseWhat}</p>
      <button type="submit" class="press press-primary">
        {said.chooseAct}
      </button>
    </form>
  );
}
