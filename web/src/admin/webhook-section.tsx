import { useSignal } from '@preact/signals';
import type { WebhookPublic } from '../api';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { EntryList } from './entry-list';
import { ShownOnce } from './shown-once';
import { WebhookTile } from './webhook-tile';

const SIGNED = 'Heft-Signature: sha256=HMAC(secret, Heft-Timestamp + "." + body)';
const LONGEST = 500;

/** Who is told when a run has ended. */
export function WebhookSection() {
  const said = adminWords.value.webhooks;
  const { answer, again } = useAnswer(() => ask('GET /api/webhooks'), 10_000);
  const adding = useSignal(false);
  const made = useSignal<WebhookPublic | null>(null);
  const all = answer.value;
  const finish = async (webhook: WebhookPublic | null) => {
    adding.value = false;
    made.value = webhook;
    await again();
  };
  return (
    <>
      {made.value?.secret && (
        <ShownOnce
          title={said.made}
          secret={made.value.secret}
          how={said.how}
          example={SIGNED}
          done={() => {
            made.value = null;
          }}
        />
      )}
      <EntryList
        entries={all}
        none={said.none}
        show={(each) => <WebhookTile key={each.id} webhook={each} again={again} />}
        add={said.add}
        adding={adding}
        form={<NewWebhook finish={finish} />}
      />
    </>
  );
}

function NewWebhook({ finish }: { finish: (made: WebhookPublic | null) => Promise<void> }) {
  const said = adminWords.value.webhooks;
  const url = useSignal('');
  const flaw = isAddress(url.value) ? null : said.badUrl;
  const create = async () => finish(await ask('POST /api/webhooks', { body: { url: url.value.trim() } }));
  return (
    <section class="tile stack">
      <h2>{said.add}</h2>
      <TextField
        label={said.url}
        kind="url"
        hint={said.urlRule}
        flaw={url.value.length > 'https://'.length ? flaw : null}
        text={url.value}
        change={(text) => {
          url.value = text;
        }}
      />
      <div class="row">
        <ActWhen lacking={flaw} act={create}>
          {said.create}
        </ActWhen>
        <Press act={() => finish(null)}>{adminWords.value.cancel}</Press>
      </div>
    </section>
  );
}

function isAddress(text: string): boolean {
  return (
    /^https?:\/\/[^\s/]+/.test(text.trim()) && URL.canParse(text.trim()) && text.trim().length <= LONGEST
  );
}
