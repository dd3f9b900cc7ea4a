import { useSignal, useSignalEffect } from '@preact/signals';
import type { AuditEntryPublic } from '../api';
import { ask } from '../ui/client';
import { every } from '../ui/connection';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { moment } from '../ui/units';
import { adminWords } from './admin-words';
import { AuditFilter, EMPTY, type Filter, queryOf } from './audit-filter';
import { AuditVerification } from './audit-verification';

const PAGE = 50;
const ASK_MS = 5000;

/** What was done, by whom: searched, and verified. */
export function AuditSection() {
  const said = adminWords.value.audit;
  const filter = useSignal<Filter>(EMPTY);
  const length = useSignal(PAGE);
  const found = useSignal<AuditEntryPublic[] | null>(null);
  useSignalEffect(() => {
    const [asked, limit] = [filter.value, length.value];
    return every(ASK_MS, async () => {
      const entries = await ask('GET /api/audit', { query: { ...queryOf(asked), limit } });
      if (asked === filter.value && limit === length.value) found.value = entries;
    });
  });
  const choose = (chosen: Filter) => {
    filter.value = chosen;
    length.value = PAGE;
  };
  const entries = found.value;
  return (
    <>
      <AuditFilter filter={filter.value} choose={choose} />
      <AuditVerification />
      {entries?.length === 0 && <p>{said.none}</p>}
      {entries !== null && entries.length > 0 && <Entries entries={entries} />}
      {entries?.length === length.value && length.value < 1000 && (
        <div class="row">
          <Press
            act={() => {
              length.value = Math.min(1000, 2 * length.value);
            }}
          >
            {said.earlier}
          </Press>
        </div>
      )}
    </>
  );
}

function Entries({ entries }: { entries: AuditEntryPublic[] }) {
  const said = adminWords.value.audit;
  return (
    <table class="audit-entries">
      <thead>
        <tr>
          <th scope="col">{said.entry}</th>
          <th scope="col">{said.time}</th>
          <th scope="col">{said.who}</th>
          <th scope="col">{said.action}</th>
          <th scope="col">{said.detail}</th>
        </tr>
      </thead>
      <tbody>
        {entries.map((each) => (
          <tr key={each.number}>
            <td>{each.number}</td>
            <td>{moment(each.at)}</td>
            <td>
              <code>{nameOf(each.who)}</code>
            </td>
            <td>
              <code>{each.action}</code>
            </td>
            <td>
              <Details of={each.detail} />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Details({ of }: { of: Record<string, unknown> }) {
  return (
    <ul class="details">
      {Object.entries(of).map(([name, value]) => (
        <li key={name}>
          <code>
            {name}: {String(value)}
          </code>
        </li>
      ))}
    </ul>
  );
}
