import { Press } from '../ui/press';
import { importWords } from './import-words';
import { armAlone, dropArmAlone, log, putAside, sound, understood, working } from './imports';

/** The log of the arm without the payload, which the next is compared with; or the offer to keep this one as that. */
export function ArmAlone() {
  const said = importWords.value.alone;
  const kept = armAlone.value;
  if (kept)
    return (
      <section class="stack" aria-label={said.title}>
        <h3>{said.title}</h3>
        <ul class="rows sent-files">
          <li>
            <b>{kept.files.map(({ file }) => file).join(', ')}</b>
            <Press disabled={working.value} act={dropArmAlone}>
              {said.drop}
            </Press>
          </li>
        </ul>
        {log.value === null && <p class="hint">{said.other}</p>}
      </section>
    );
  if (!sound.value || understood.value?.joint_torques == null) return null;
  return (
    <section class="stack" aria-label={said.title}>
      <h3>{said.title}</h3>
      <p class="hint">{said.hint}</p>
      <p>
        <Press disabled={working.value} act={putAside}>
          {said.put}
        </Press>
      </p>
    </section>
  );
}
