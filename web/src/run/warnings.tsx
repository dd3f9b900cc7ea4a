import type { Message } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';

/** What has to be known before the numbers are used; nothing where nothing has. */
export function Warnings({ all }: { all: Message[] }) {
  if (all.length === 0) return null;
  return (
    <section class="warnings">
      <h2>
        <span aria-hidden="true">▲</span> {words.value.result.warnings}
      </h2>
      <ul>
        {all.map((each) => (
          <li key={each.text}>
            <MessageText message={each} />
          </li>
        ))}
      </ul>
    </section>
  );
}
