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
        {targets.value.map(({ target, title, says, refused, lost }) => (
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
                {lost.length > 0 && ` · ${said.lost}: ${lost.map((each) => each.name).join(', ')}`}
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
