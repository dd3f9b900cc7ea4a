import type { Signal } from '@preact/signals';
import { words } from '../words';

export const CHANNELS = ['fx', 'fy', 'fz', 'tx', 'ty', 'tz'];

/** Some of the six channels of the sensor. */
export function ChannelChoice({ chosen }: { chosen: Signal<readonly string[]> }) {
  const flip = (channel: string) => () => {
    chosen.value = CHANNELS.filter((each) => chosen.value.includes(each) !== (each === channel));
  };
  return (
    <fieldset class="choice">
      <legend>{words.value.gap.channel}</legend>
      <div class="options in-row">
        {CHANNELS.map((channel) => (
          <label class="option" key={channel}>
            <input type="checkbox" checked={chosen.value.includes(channel)} onChange={flip(channel)} />
            <span>
              <b>{channel}</b>
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
