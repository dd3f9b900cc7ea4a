import { useSignal } from '@preact/signals';
import type { KeyIssued, KeyPublic } from '../api';
import { AskFirst } from '../ui/ask-first';
import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { moment } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { EntryList } from './entry-list';
import { NewKey } from './new-key';
import { ShownOnce } from './shown-once';

/** What machines show instead of a password. */
export function KeySection() {
  const said = adminWords.value.keys;
  const { answer, again } = useAnswer(() => ask('GET /api/keys'), 10_000);
  const adding = useSignal(false);
  const made = useSignal<KeyIssued | null>(null);
  const all = answer.value;
  const finish = async (key: KeyIssued | null) => {
    adding.value = false;
    made.value = key;
    await again();
  };
  return (
    <>
      {made.value && (
        <ShownOnce
          title={said.made(made.value.name)}
          secret={made.value.key}
          how={said.how}
          example={`Authorization: Bearer ${made.value.prefix}…`}
          done={() => {
            made.value = null;
          }}
        />
      )}
      <EntryList
        entries={all}
        none={said.none}
        show={(each) => <Key key={each.name} shown={each} again={again} />}
        add={said.add}
        adding={adding}
        form={<NewKey names={(all ?? []).map(({ name }) => name)} finish={finish} />}
      />
    </>
  );
}

function Key({ shown, again }: { shown: KeyPublic; again: () => Promise<void> }) {
  const said = adminWords.value.keys;
  const revoke = async () => {
    await ask('DELETE /api/keys/{key}', { path: { key: shown.name } });
    await again();
  };
  return (
    <li class="tile">
      <div>
        <b>
          <code>{shown.name}</code>
        </b>
        <span>{adminWords.value.roleNames[shown.role]}</span>
        <small>
          {said.begins} <code>{shown.prefix}</code>
        </small>
        <small>
          {shown.used_at === null ? said.unused : said.used(moment(shown.used_at))}, {lasts(shown)},{' '}
          {said.by(nameOf(shown.created_by), moment(shown.created_at))}
        </small>
      </div>
      <AskFirst label={said.revoke} question={said.revokeAsk(shown.name)} yes={said.revokeYes} act={revoke} />
    </li>
  );
}

function lasts({ expires_at }: KeyPublic): string {
  const said = adminWords.value.keys;
  if (expires_at === null) return said.noEnd;
  return Date.parse(expires_at) <= Date.now()
    ? said.over(moment(expires_at))
    : said.until(moment(expires_at));
}
