import { useSignal } from '@preact/signals';
import type { DraftPair } from '../api';
import { MessageText } from '../ui/message-text';
import { Press } from '../ui/press';
import { Select } from '../ui/select';
import { frames, leftOut, made, outline, remake, working } from './draft';
import { linksBehind } from './frames';
import { newCellWords } from './new-cell-words';

type Pair = [string, string];

const isSame = ([first, second]: Pair, pair: Pair) => pair.includes(first) && pair.includes(second);
const pairOf = ({ first, second }: DraftPair): Pair => [first, second];

/** Pairs that are left out now: as somebody has chosen, else as they were proposed. */
const chosen = (): Pair[] =>
  leftOut.value ?? (made.value?.pairs ?? []).filter(({ is_left_out }) => is_left_out).map(pairOf);

function choose(pairs: Pair[]): Promise<void> {
  leftOut.value = pairs;
  return remake();
}

/** Which pairs of links nobody watches, each with why: taken out of the list, or declared, and the findings follow. */
export function PairChoice() {
  const said = newCellWords.value.room;
  const known = made.value?.pairs ?? [];
  const now = chosen();
  const added = now.filter((pair) => !known.some((each) => isSame(pairOf(each), pair)));
  const pairs = [...known.map(pairOf), ...added];
  return (
    <fieldset class="choice">
      <legend>{said.pairs}</legend>
      <p class="hint">{pairs.length > 0 ? said.pairsHint : said.noPairs}</p>
      <div class="options">
        {pairs.map((pair) => (
          <OnePair key={pair.join('\n')} pair={pair} now={now} />
        ))}
      </div>
      <NewPair now={now} />
    </fieldset>
  );
}

function OnePair({ pair, now }: { pair: Pair; now: Pair[] }) {
  const isOut = now.some((each) => isSame(each, pair));
  const why = made.value?.pairs.find((each) => isSame(pairOf(each), pair))?.why;
  const flip = () => choose(isOut ? now.filter((each) => !isSame(each, pair)) : [...now, pair]);
  return (
    <label class="option">
      <input type="checkbox" checked={isOut} disabled={working.value} onChange={flip} />
      <span>
        <b>{newCellWords.value.room.pair(...pair)}</b>
        {why && (
          <small>
            <MessageText message={why} />
          </small>
        )}
      </span>
    </label>
  );
}

/** Two links that have a body and do not hang behind the sensor. */
function NewPair({ now }: { now: Pair[] }) {
  const said = newCellWords.value.room;
  const [arm, robot] = [frames.value, outline.value];
  const [first, second] = [useSignal(''), useSignal('')];
  if (arm === null || robot === null) return null;
  const carried = linksBehind(robot, arm);
  const names = robot.links.filter(({ name, is_body }) => is_body && !carried.includes(name));
  const options: [string, string][] = [['', '–'], ...names.map(({ name }): [string, string] => [name, name])];
  const pair: Pair = [first.value, second.value];
  const isNew = new Set(['', ...pair]).size === 3 && !now.some((each) => isSame(each, pair));
  const add = async () => {
    await choose([...now, pair]);
    first.value = second.value = '';
  };
  return (
    <div class="two">
      <Select
        label={said.first}
        options={options}
        chosen={first.value}
        choose={(name) => {
          first.value = name;
        }}
      />
      <Select
        label={said.second}
        options={options}
        chosen={second.value}
        choose={(name) => {
          second.value = name;
        }}
      />
      <Press disabled={!isNew || working.value} act={add}>
        {said.leaveOut}
      </Press>
    </div>
  );
}
