import type { Signal } from '@preact/signals';
import { Choice } from '../ui/choice';
import { words } from '../words';

export const CHANNELS = ['fx', 'fy', 'fz', 'tx', 'ty', 'tz'];

/** One of the six channels of the sensor. */
export function ChannelChoice({ chosen }: { chosen: Signal<string> }) {
  return (
    <Choice
      legend={words.value.gap.channel}
      inRow
      options={CHANNELS.map((value) => ({ value, label: value }))}
      chosen={chosen.value}
      choose={(value) => {
        chosen.value = value;
      }}
    />
  );
}
