import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { words } from '../words';

interface Props {
  /** What was planted, as text. */
  sealed: string;
  /** Its SHA-256 as it was shown before the trial, hexadecimal. */
  seal: string;
}

/** Whether what was planted is what was sealed, worked out in this browser. */
export function SealCheck({ sealed, seal }: Props) {
  const said = words.value.gap.trials;
  const holds = useSignal<boolean | null>(null);
  useEffect(() => {
    holds.value = null;
    // only where the address is trustworthy (TLS, or this very machine) does a browser compute hashes
    if (window.isSecureContext) {
      void sha256Of(sealed).then((found) => {
        holds.value = found === seal;
      });
    }
  }, [sealed, seal, holds]);
  return (
    <>
      {holds.value === null && <p class="hint">{said.unchecked}</p>}
      {holds.value === true && <p>✓ {said.checked}</p>}
      {holds.value === false && <p class="hint flaw">▲ {said.broken}</p>}
      <details class="others">
        <summary>{said.text}</summary>
        <pre>
          <code>{sealed}</code>
        </pre>
      </details>
    </>
  );
}

async function sha256Of(text: string): Promise<string> {
  const digest = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text));
  return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}
