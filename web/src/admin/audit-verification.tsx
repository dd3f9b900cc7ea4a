import { useSignal } from '@preact/signals';
import type { AuditVerified } from '../api';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { TextField } from '../ui/text-field';
import { Told } from '../ui/told';
import { number } from '../ui/units';
import { adminWords } from './admin-words';

const PATIENCE_MS = 120_000;

/** Whether nothing in the log was changed, removed or put in between. */
export function AuditVerification() {
  const said = adminWords.value.audit;
  const expect = useSignal('');
  const verified = useSignal<AuditVerified | null>(null);
  const hash = expect.value.trim().toLowerCase();
  const flaw = hash === '' || /^[0-9a-f]{64}$/.test(hash) ? null : said.badHash;
  const verify = async () => {
    verified.value = null;
    verified.value = await ask('GET /api/audit/verification', {
      query: { expect: hash || null },
      patience_ms: PATIENCE_MS,
    });
  };
  return (
    <details class="verification">
      <summary>{said.verify}</summary>
      <div class="stack">
        <p class="hint">{said.verifyHint}</p>
        <TextField
          label={said.expect}
          hint={said.expectHint}
          flaw={flaw}
          text={expect.value}
          change={(text) => {
            expect.value = text;
          }}
        />
        <ActWhen lacking={flaw} act={verify}>
          {said.act}
        </ActWhen>
        {verified.value && <Outcome verified={verified.value} />}
      </div>
    </details>
  );
}

function Outcome({ verified }: { verified: AuditVerified }) {
  const said = adminWords.value.audit;
  const entries = number(verified.entries, 0);
  if (verified.flaw !== null)
    return (
      <div class="warnings" role="alert">
        <h2>
          <span aria-hidden="true">▲</span> {said.broken}
        </h2>
        <Told message={verified.flaw} />
        <p>{said.brokenAfter(entries)}</p>
      </div>
    );
  return (
    <div role="status">
      <p>✓ {said.unbroken(entries)}</p>
      <p class="hint">{said.keep}</p>
      <div class="secret">
        <code>{verified.hash}</code>
      </div>
    </div>
  );
}
