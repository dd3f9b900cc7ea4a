import type { Instruction } from '../api';
import { MessageText } from '../ui/message-text';

type Level = Instruction['level'];

/** A check, a warning, another turn, a question; drawn, because not every tablet has the letters. */
const DRAWN: Record<Level, string> = {
  nothing: 'M4 17l8 8l16-18',
  act: 'M16 4l13 24h-26zM16 13v7M16 24v1',
  measure: 'M26 10a12 12 0 1 0 2 9M27 3v8h-8',
  ask: 'M10 12a6 6 0 1 1 9 5c-2 1-3 2-3 5M16 27v1',
};

/** What the person at the robot has to do, with its sign; yellow where something is wrong. */
export function InstructionMark({ instruction: { level, sentence } }: { instruction: Instruction }) {
  return (
    <span class={`instruction ${isAbnormal(level) ? 'abnormal' : ''}`} data-level={level}>
      <svg viewBox="0 0 32 32" aria-hidden="true">
        <path d={DRAWN[level]} />
      </svg>
      <MessageText message={sentence} />
    </span>
  );
}

function isAbnormal(level: Level): boolean {
  return level === 'act' || level === 'ask';
}
