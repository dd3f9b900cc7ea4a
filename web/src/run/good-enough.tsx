import type { RequirementPart } from '../api';
import { MessageText } from '../ui/message-text';
import { words } from '../words';

/** Whether the result is good enough for its cell, with its sign, and what stands behind that; nothing in results of earlier versions. */
export function GoodEnough({ requirement }: { requirement: RequirementPart | null | undefined }) {
  if (requirement == null) return null;
  const { adequacy, message, details } = requirement;
  return (
    <div>
      <p class={adequacy?.good_enough === false ? 'good-enough not-good-enough' : 'good-enough'}>
        <span aria-hidden="true">{sign(adequacy)}</span> <MessageText message={message} />
      </p>
      {details.length > 0 && (
        <details>
          <summary>{words.value.result.goodEnough}</summary>
          <ul>
            {details.map((each) => (
              <li key={each.text}>
                <MessageText message={each} />
              </li>
            ))}
          </ul>
        </details>
      )}
    </div>
  );
}

function sign(adequacy: RequirementPart['adequacy']): string {
  if (adequacy === null) return '?';
  return adequacy.good_enough ? '✓' : '▲';
}
