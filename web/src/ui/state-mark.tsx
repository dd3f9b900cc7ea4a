import type { RunPublic } from '../api';
import { words } from '../words';

type State = RunPublic['state'];
type Shape = 'circle' | 'play' | 'pause' | 'octagon' | 'square' | 'check' | 'cross' | 'clock';
type Tone = 'normal' | 'abnormal' | 'aborted';

const SHAPES: Record<State, Shape> = {
  Resetting: 'clock',
  Idle: 'circle',
  Starting: 'play',
  Execute: 'play',
  Completing: 'clock',
  Complete: 'check',
  Holding: 'pause',
  Held: 'pause',
  Unholding: 'play',
  Suspending: 'octagon',
  Suspended: 'octagon',
  Unsuspending: 'play',
  Stopping: 'square',
  Stopped: 'square',
  Aborting: 'cross',
  Aborted: 'cross',
  Clearing: 'clock',
};

const DRAWN: Record<Shape, string> = {
  circle: 'M16 4a12 12 0 1 0 0 24a12 12 0 1 0 0-24',
  play: 'M8 4l20 12l-20 12z',
  pause: 'M7 5h6v22h-6zM19 5h6v22h-6z',
  octagon: 'M11 4h10l7 7v10l-7 7h-10l-7-7v-10z',
  square: 'M5 5h22v22h-22z',
  check: 'M4 17l8 8l16-18',
  cross: 'M16 2l14 14l-14 14l-14-14zM11 11l10 10M21 11l-10 10',
  clock: 'M16 4a12 12 0 1 0 0 24a12 12 0 1 0 0-24M16 9v8l6 3',
};
const FILLED = new Set<Shape>(['play', 'pause', 'square', 'octagon']);

/** Yellow is for what is abnormal, red for what was aborted; everything else has no colour. */
export function toneOf(state: State): Tone {
  if (state === 'Aborting' || state === 'Aborted') return 'aborted';
  return state === 'Suspending' || state === 'Suspended' ? 'abnormal' : 'normal';
}

/** A state by shape, word and, where it is abnormal, colour. */
export function StateMark({ state }: { state: State }) {
  const shape = SHAPES[state];
  return (
    <span class={`state state-${toneOf(state)}`} data-state={state}>
      <svg viewBox="0 0 32 32" aria-hidden="true" class={FILLED.has(shape) ? 'filled' : 'outlined'}>
        <path d={DRAWN[shape]} />
      </svg>
      <span>{words.value.states[state]}</span>
    </span>
  );
}
