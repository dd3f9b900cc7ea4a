import type { TargetPart } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';

/** How far the result meets the target that was asked for, and what the run left out; nothing where there was none. */
export function TargetMet({ target }: { target: TargetPart | null | undefined }) {
  if (target == null) return null;
  return (
    <div>
      <p class={target.standing === 'reached' ? 'good-enough' : 'good-enough not-good-enough'}>
        <span aria-hidden="true">{target.standing === 'reached' ? '✓' : '▲'}</span>{' '}
        <MessageText message={target.message} />
      </p>
      <details>
        <summary>{words.value.result.target}</summary>
        <ul>
          {target.quantities.map(({ quantity, message }) => (
            <li key={quantity}>
              <MessageText message={message} />
            </li>
          ))}
        </ul>
      </details>
    </div>
  );
}
