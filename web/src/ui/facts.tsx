import type { ComponentChildren } from 'preact';

export interface Fact {
  name: ComponentChildren;
  value: ComponentChildren;
  note?: ComponentChildren;
}

/** Names and values; large enough to be read at arm's length. */
export function Facts({ facts }: { facts: Fact[] }) {
  return (
    <dl class="facts">
      {facts.map(({ name, value, note }, k) => (
        <div key={k}>
          <dt>{name}</dt>
          <dd>{value}</dd>
          {note && <dd class="note">{note}</dd>}
        </div>
      ))}
    </dl>
  );
}
