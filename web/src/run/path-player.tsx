import { Press } from '../ui/press';
import { seconds } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';
import { partMessage } from './part-message';
import { moment_s, partNow, path_s, play, playing } from './path';

/** Plays the planned path: the planned robot goes along it in the picture, the real one stays where it is. */
export function PathPlayer() {
  const said = words.value.view;
  const part = partNow.value;
  const now = part === null ? said.path : `${say(partMessage(part.part))}, ${seconds(moment_s.value ?? 0)}`;
  return (
    <section class="path-player" aria-label={said.path}>
      {playing.value ? (
        <Press
          act={() => {
            playing.value = false;
          }}
        >
          <span aria-hidden="true">❚❚</span> {said.pause}
        </Press>
      ) : (
        <Press act={play}>
          <span aria-hidden="true">▷</span> {said.play}
        </Press>
      )}
      <label>
        <span>
          {now} <small>{said.of(seconds(path_s.value))}</small>
        </span>
        <input
          type="range"
          name="moment"
          min={0}
          max={path_s.value}
          step={0.05}
          value={moment_s.value ?? 0}
          onInput={({ currentTarget }) => {
            playing.value = false;
            moment_s.value = Number(currentTarget.value);
          }}
        />
      </label>
    </section>
  );
}
