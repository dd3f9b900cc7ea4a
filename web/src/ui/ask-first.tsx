import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { words } from '../words';
import { Press } from './press';

interface Props {
  label: string;
  /** What happens, as a question. */
  question: string;
  yes: string;
  act: () => Promise<void>;
}

/** A button for what cannot be taken back: it says what happens, and does it at the second tap. */
export function AskFirst({ label, question, yes, act }: Props) {
  const asking = useSignal(false);
  const asked = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (asking.value) asked.current?.focus();
  }, [asking.value]);
  const shut = () => {
    asking.value = false;
  };
  if (!asking.value)
    return (
      <Press
        act={() => {
          asking.value = true;
        }}
      >
        {label}
      </Press>
    );
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for values
    <div class="ask-first" role="group" aria-label={question} tabIndex={-1} ref={asked}>
      <p>{question}</p>
      <div class="row">
        <Press
          act={async () => {
            await act();
            shut();
          }}
        >
          {yes}
        </Press>
        <Press act={shut}>{words.value.cancel}</Press>
      </div>
    </div>
  );
}
