import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { ExportPublic } from '../api';
import { addressOf, ask } from '../ui/client';
import { MessageText } from '../ui/message-text';
import { attempt } from '../ui/notice';
import { Told } from '../ui/told';
import { words } from '../words';

/** The result as controllers and simulators take it, each with what it cannot hold. */
export function Exports({ run }: { run: string }) {
  const said = words.value.result;
  const targets = useSignal<ExportPublic[]>([]);
  useEffect(() => {
    void attempt(async () => {
      targets.value = (await ask('GET /api/runs/{run}/exports', { path: { run } })).targets;
    });
  }, [run, targets]);
  return (
    <details class="exports">
      <summary>{said.exports}</summary>
      <ul>
        {targets.value.map(({ target, title, says, refused, lost, holds_uncertainty }) => (
          <li key={target}>
            {refused === null ? (
              <a
                class="download"
                href={addressOf('/api/runs/{run}/exports/{target}', { run, target })}
                download
              >
                {title}
              </a>
            ) : (
              <b>{title}</b>
            )}
            {refused === null ? (
              <p>
                <MessageText message={says} />
                {lacks(lost, holds_uncertainty)}
              </p>
            ) : (
              <Told message={refused} />
            )}
          </li>
        ))}
      </ul>
    </details>
  );
}

/** What the file cannot say: numbers, and how exactly they are known. */
function lacks(lost: ExportPublic['lost'], holdsUncertainty: boolean): string {
  const said = words.value.result;
  const names = [...lost.map((each) => each.name), ...(holdsUncertainty ? [] : [said.budget])];
  return names.length === 0 ? '' : ` · ${said.lost}: ${names.join(', ')}`;
}
