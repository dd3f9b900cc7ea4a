import { useSignal } from '@preact/signals';
import type { KeyIssued, Role } from '../api';
import { ActWhen } from '../ui/act-when';
import { Choice } from '../ui/choice';
import { ask } from '../ui/client';
import { Press } from '../ui/press';
import { Select } from '../ui/select';
import { TextField } from '../ui/text-field';
import { adminWords } from './admin-words';
import { nameFlaw } from './rules';

const MACHINE_ROLES = ['mes', 'viewer', 'engineer'] as const satisfies Role[];
const DAYS = [30, 90, 365];
const FOREVER = 'forever';

interface Props {
  /** Of the keys that there are. */
  names: string[];
  finish: (made: KeyIssued | null) => Promise<void>;
}

/** A machine that is to be let in from now on. */
export function NewKey({ names, finish }: Props) {
  const said = adminWords.value.keys;
  const all = adminWords.value;
  const name = useSignal('');
  const role = useSignal<(typeof MACHINE_ROLES)[number]>('mes');
  const valid = useSignal('365');
  const flaw = nameFlaw(name.value, names, said.taken);
  const lacking = flaw ?? (name.value === '' ? all.people.needName : null);
  const create = async () => {
    const days = valid.value === FOREVER ? {} : { valid_days: Number(valid.value) };
    await finish(await ask('POST /api/keys', { body: { name: name.value, role: role.value, ...days } }));
  };
  return (
    <section class="tile stack">
      <h2>{said.add}</h2>
      <div class="halves">
        <div class="stack">
          <TextField
            label={said.name}
            hint={all.people.nameRule}
            flaw={flaw}
            text={name.value}
            change={(text) => {
              name.value = text;
            }}
          />
          <Select
            label={said.valid}
            options={[
              ...DAYS.map((days): [string, string] => [String(days), said.days(days)]),
              [FOREVER, said.forever],
            ]}
            chosen={valid.value}
            choose={(value) => {
              valid.value = value;
            }}
          />
        </div>
        <Choice
          legend={said.role}
          options={MACHINE_ROLES.map((value) => ({
            value,
            label: all.roleNames[value],
            note: all.roleNotes[value],
          }))}
          chosen={role.value}
          choose={(value) => {
            role.value = value;
          }}
        />
      </div>
      <div class="row">
        <ActWhen lacking={lacking} act={create}>
          {said.create}
        </ActWhen>
        <Press act={() => finish(null)}>{all.cancel}</Press>
      </div>
    </section>
  );
}
