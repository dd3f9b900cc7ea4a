import { ask } from '../ui/client';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';

/** What is searched for; empty texts leave it open. Days are those of this device, both included. */
export interface Filter {
  who: string;
  action: string;
  mentions: string;
  from: string;
  to: string;
}

export const EMPTY: Filter = { who: '', action: '', mentions: '', from: '', to: '' };

export const isEmpty = (filter: Filter) => Object.values(filter).every((text) => text === '');

/** As the service is asked. */
export function queryOf({ who, action, mentions, from, to }: Filter) {
  return {
    who: who || null,
    action: action || null,
    mentions: mentions.trim() || null,
    since: dayAt(from, 0),
    until: dayAt(to, 1),
  };
}

/** The beginning of a day, or of the one so many days later; null where none is chosen. */
function dayAt(day: string, later: number): string | null {
  if (day === '') return null;
  const at = new Date(`${day}T00:00:00`);
  at.setDate(at.getDate() + later);
  return at.toISOString();
}

interface Props {
  filter: Filter;
  choose: (filter: Filter) => void;
}

/** Who, what and when, from what the log has. */
export function AuditFilter({ filter, choose }: Props) {
  const said = adminWords.value.audit;
  const { answer } = useAnswer(() => ask('GET /api/audit/names'));
  const { who = [], actions = [] } = answer.value ?? {};
  const change = (name: keyof Filter) => (text: string) => choose({ ...filter, [name]: text });
  return (
    <div class="audit-filter">
      <label class="field">
        <span>{said.who}</span>
        <select value={filter.who} onChange={({ currentTarget }) => change('who')(currentTarget.value)}>
          <option value="">{said.anyone}</option>
          {who.map((each) => (
            <option key={each} value={each} lang="en">
              {nameOf(each)}
            </option>
          ))}
        </select>
      </label>
      <label class="field">
        <span>{said.action}</span>
        <select value={filter.action} onChange={({ currentTarget }) => change('action')(currentTarget.value)}>
          <option value="">{said.anything}</option>
          {nounsOf(actions).map((noun) => (
            <Actions key={noun} noun={noun} actions={actions} />
          ))}
        </select>
      </label>
      <TextField
        label={said.mentions}
        hint={said.mentionsHint}
        kind="search"
        text={filter.mentions}
        change={change('mentions')}
      />
      <TextField label={said.from} kind="date" text={filter.from} change={change('from')} />
      <TextField label={said.to} kind="date" text={filter.to} change={change('to')} />
      <div class="row">
        <Press act={() => choose(EMPTY)} disabled={isEmpty(filter)}>
          {said.clear}
        </Press>
        {isEmpty(filter) && <span class="hint">{said.noFilter}</span>}
      </div>
    </div>
  );
}

const nounsOf = (actions: string[]) => [...new Set(actions.map((each) => each.split('.')[0] ?? each))];

/** What was done with one noun: all of it, or one by one. */
function Actions({ noun, actions }: { noun: string; actions: string[] }) {
  const said = adminWords.value.audit;
  const name = said.nouns[noun] ?? noun;
  return (
    <optgroup label={name}>
      <option value={noun}>{said.all(name)}</option>
      {actions
        .filter((each) => each.startsWith(`${noun}.`))
        .map((each) => (
          <option key={each} value={each} lang="en">
            {each}
          </option>
        ))}
    </optgroup>
  );
}
