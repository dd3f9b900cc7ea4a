import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { attempt } from './notice';

interface Props {
  act: () => Promise<void> | void;
  /** `start`, `stop` and `move` are larger: they move the robot or stop it. */
  kind?: 'plain' | 'primary' | 'start' | 'stop' | 'move';
  disabled?: boolean;
  children: ComponentChildren;
}

/** A button that does one thing at a time, and says in words when it could not be done. */
export function Press({ act, kind = 'plain', disabled = false, children }: Props) {
  const busy = useSignal(false);
  const pressed = async () => {
    if (busy.value) return;
    busy.value = true;
    await attempt(async () => act());
    busy.value = false;
  };
  return (
    <button
      type="button"
      class={`press press-${kind}`}
      disabled={disabled}
      aria-busy={busy.value}
      onClick={pressed}
    >
      {children}
    </button>
  );
}
