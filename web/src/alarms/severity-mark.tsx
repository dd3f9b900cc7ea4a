import type { Severity } from '../api';
import { words } from '../words';

const SIGNS: Record<Severity, string> = { high: '▲▲', medium: '▲', low: '△' };

/** How soon a person is needed: a sign, a word and, where it is not only low, colour. */
export function SeverityMark({ severity }: { severity: Severity }) {
  return (
    <span class={`severity severity-${severity}`}>
      <span aria-hidden="true">{SIGNS[severity]}</span> {words.value.alarms.severities[severity]}
    </span>
  );
}
