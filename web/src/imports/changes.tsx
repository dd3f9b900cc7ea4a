import { useSignal } from '@preact/signals';
import type { LogChange } from '../api';
import { NumberField } from '../ui/number-field';
import { Press } from '../ui/press';
import { Select } from '../ui/select';
import { typed } from '../ui/units';
import { importWords } from './import-words';
import { answer } from './imports';
import { choiceName } from './question';

/** What was taken wrongly is taken otherwise; the log is read anew. */
export function Changes({ changes, open }: { changes: LogChange[]; open: boolean }) {
  const said = importWords.value;
  return (
    <details class="changes" open={open}>
      <summary>{said.change}</summary>
      <p class="hint">{said.changeHint}</p>
      <div class="change-fields">
        {changes.map((change) =>
          change.choices.length > 0 ? (
            <Select
              key={change.key}
              label={keyName(change.key)}
              options={change.choices.map((value): [string, string] => [
                value,
                choiceName(change.key, value),
              ])}
              chosen={change.value}
              choose={(value) => void answer(change.key, value)}
            />
          ) : (
            <NumberChange key={change.key} change={change} />
          ),
        )}
      </div>
    </details>
  );
}

function NumberChange({ change: { key, value } }: { change: LogChange }) {
  const said = importWords.value;
  const text = useSignal(value);
  const flaw = text.value !== '' && typed(text.value) === null;
  return (
    <div class="row number-change">
      <NumberField
        label={keyName(key)}
        signed
        text={text.value}
        flaw={flaw}
        change={(next) => {
          text.value = next;
        }}
      />
      <Press
        disabled={flaw || text.value === '' || text.value === value}
        act={() => answer(key, String(typed(text.value) ?? value))}
      >
        {said.apply}
      </Press>
    </div>
  );
}

function keyName(key: string): string {
  const [part = '', name = ''] = key.split('.');
  const names: Record<string, string | Record<string, string>> = importWords.value.keys;
  const found = names[name];
  if (typeof found === 'object') return found[part === 'wrench' ? part : 'pose'] ?? key;
  return found ?? key;
}
