import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { Press } from '../ui/press';
import { adminWords } from './admin-words';

interface Props {
  title: string;
  secret: string;
  /** How it is used. */
  how: string;
  example: string;
  done: () => void;
}

/** What is shown once and never again. A page that did not come over HTTPS may not write to the clipboard: there it is copied by hand. */
export function ShownOnce({ title, secret, how, example, done }: Props) {
  const said = adminWords.value;
  const copied = useSignal(false);
  const shown = useRef<HTMLElement>(null);
  useEffect(() => shown.current?.scrollIntoView({ block: 'nearest' }), []);
  const copy = async () => {
    await navigator.clipboard.writeText(secret);
    copied.value = true;
  };
  return (
    <section class="tile shown-once" ref={shown}>
      <h2>{title}</h2>
      <div class="secret">
        <code>{secret}</code>
      </div>
      <p role="status">{copied.value ? said.copied : said.shownOnce}</p>
      <p class="hint">
        {how} <code>{example}</code>
      </p>
      <div class="row">
        {window.isSecureContext ? (
          <Press act={copy}>{said.copy}</Press>
        ) : (
          <span class="hint">{said.copyByHand}</span>
        )}
        <Press act={done}>{said.done}</Press>
      </div>
    </section>
  );
}
