import type { OwnSession } from '../api';
import { AskFirst } from '../ui/ask-first';
import { ask } from '../ui/client';
import { moment } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { deviceOf } from './device';

/** The devices that one is signed in on, each to be signed out from here. */
export function OwnSessions() {
  const said = adminWords.value.account;
  const { answer, again } = useAnswer(() => ask('GET /api/sessions'), 10_000);
  const all = answer.value ?? [];
  const endOthers = async () => {
    await ask('DELETE /api/sessions');
    await again();
  };
  return (
    <section class="own-sessions">
      <h2>{said.devices}</h2>
      <ul class="tiles">
        {all.map((each) => (
          <Device key={each.id} device={each} again={again} />
        ))}
      </ul>
      {all.length === 1 && <p class="hint">{said.onlyHere}</p>}
      {all.length > 2 && (
        <AskFirst
          label={said.endOthers}
          question={said.endOthersAsk}
          yes={said.endOthersYes}
          act={endOthers}
        />
      )}
    </section>
  );
}

function Device({ device, again }: { device: OwnSession; again: () => Promise<void> }) {
  const said = adminWords.value.account;
  const name = deviceOf(device.browser);
  const end = async () => {
    await ask('DELETE /api/sessions/{session}', { path: { session: device.id } });
    await again();
  };
  return (
    <li class="tile">
      <div>
        <b>{name}</b>
        {device.current && <span class="mark">{said.here}</span>}
        <small>
          {said.from(device.address)}, {said.since(moment(device.created_at))},{' '}
          {said.used(moment(device.used_at))}
        </small>
      </div>
      {!device.current && (
        <AskFirst label={said.end} question={said.endAsk(name)} yes={said.endYes} act={end} />
      )}
    </li>
  );
}
