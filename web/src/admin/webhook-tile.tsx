import { useSignal } from '@preact/signals';
import type { DeliveryPublic, WebhookPublic } from '../api';
import { AskFirst } from '../ui/ask-first';
import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import { Told } from '../ui/told';
import { moment } from '../ui/units';
import { say } from '../words/messages';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';

interface Props {
  webhook: WebhookPublic;
  again: () => Promise<void>;
}

/** One webhook: tried, its deliveries looked at, removed. */
export function WebhookTile({ webhook, again }: Props) {
  const said = adminWords.value.webhooks;
  const open = useSignal(false);
  const tried = useSignal<DeliveryPublic | 'sending' | null>(null);
  const path = { webhook: webhook.id };
  const test = async () => {
    tried.value = 'sending';
    tried.value = await ask('POST /api/webhooks/{webhook}/test', { path }).catch((error) => {
      tried.value = null;
      throw error;
    });
  };
  const remove = async () => {
    await ask('DELETE /api/webhooks/{webhook}', { path });
    await again();
  };
  return (
    <li class="tile">
      <div>
        <b>
          <code>{webhook.url}</code>
        </b>
        <small>{said.by(nameOf(webhook.made_by), moment(webhook.made_at))}</small>
      </div>
      <div class="acts">
        <div class="row">
          <Press act={test}>{said.test}</Press>
          <button
            type="button"
            class="press press-plain"
            aria-expanded={open.value}
            onClick={() => {
              open.value = !open.value;
            }}
          >
            <span aria-hidden="true">{open.value ? '▾' : '▸'}</span> {said.deliveries}
          </button>
          <AskFirst
            label={said.remove}
            question={said.removeAsk(webhook.url)}
            yes={said.removeYes}
            act={remove}
          />
        </div>
        {tried.value && <Tried outcome={tried.value} />}
      </div>
      {open.value && (
        <Deliveries key={tried.value === 'sending' ? '' : tried.value?.id} webhook={webhook.id} />
      )}
    </li>
  );
}

function Tried({ outcome }: { outcome: DeliveryPublic | 'sending' }) {
  const said = adminWords.value.webhooks;
  if (outcome === 'sending') return <p role="status">{said.testing}</p>;
  if (outcome.last_error === null) return <p role="status">✓ {said.arrived}</p>;
  return (
    <p class="abnormal" role="alert">
      <span aria-hidden="true">▲</span> {said.failed(say(outcome.last_error))}
    </p>
  );
}

function Deliveries({ webhook }: { webhook: string }) {
  const said = adminWords.value.webhooks;
  const { answer } = useAnswer(
    () => ask('GET /api/webhooks/{webhook}/deliveries', { path: { webhook } }),
    3000,
  );
  const all = answer.value;
  if (all?.length === 0) return <p class="hint">{said.noDeliveries}</p>;
  return (
    <ul class="deliveries">
      {(all ?? []).map((each) => (
        <li key={each.id}>
          <span>{moment(each.made_at)}</span>
          {each.run === null ? <span>{said.ofTest}</span> : <a href={to('runs', each.run)}>{said.ofRun}</a>}
          <span>
            {each.delivered_at === null ? '▲' : '✓'} {stateOf(each)}
            {each.attempts > 1 && `, ${said.attempts(each.attempts)}`}
          </span>
          {each.last_error && <Told message={each.last_error} />}
        </li>
      ))}
    </ul>
  );
}

function stateOf({ run, attempts, delivered_at, due_at }: DeliveryPublic): string {
  const said = adminWords.value.webhooks;
  if (delivered_at !== null) return said.delivered(moment(delivered_at));
  if (due_at !== null) return attempts === 0 ? said.sending : said.waits(moment(due_at));
  if (run === null) return attempts === 0 ? said.sending : said.notRepeated;
  return said.givenUp;
}
