import type { ControlPublic, EndedRequestPublic } from '../api';
import { nameOf } from '../ui/names';
import { say } from '../ui/notice';
import { words } from '../words';

type Outcome = EndedRequestPublic['outcome'];
type Passed = 'accepted' | 'unanswered' | 'vacant' | 'own';

/** Whether control has passed, and whether whoever had it did so themselves: the rest stays until it is read. */
const PASSED: Record<Passed, 'passes' | 'stays'> = {
  accepted: 'passes',
  own: 'passes',
  unanswered: 'stays',
  vacant: 'stays',
};

/** The fence of the last request that was told of, by cell. */
const told = new Map<string, number | null>();

/**
 * Says on this screen how a request for control ended, where it concerns it.
 *
 * @param own fence of this screen's control until now, or null.
 * @param asking fence with which this screen asked until now, or null.
 */
export function tellHandover(said: ControlPublic, own: number | null, asking: number | null): void {
  const ended = said.last_request;
  const before = told.get(said.cell);
  told.set(said.cell, ended?.fence ?? null);
  if (before === undefined) return; // what was before this page is no news
  if (ended !== null && ended.fence !== before) {
    if (ended.fence === asking) tellAsker(ended);
    else if (own !== null && hasPassed(ended.outcome) && ended.fence > own) tellHolder(ended, ended.outcome);
  } else if (own !== null && said.fence !== null && said.fence > own) {
    const who = described(said.holder ?? '', said.device ?? '');
    say(() => words.value.handover.told.taken(who), 'stays');
  }
}

/** How somebody is called, and on which screen. */
export function described(who: string, screen: string): string {
  return words.value.handover.by(nameOf(who), screen);
}

function hasPassed(outcome: Outcome): outcome is Passed {
  return outcome in PASSED;
}

function tellAsker({ outcome, holder }: EndedRequestPublic): void {
  const said = () => words.value.handover.told;
  if (hasPassed(outcome)) say(() => said().got, 'passes');
  else if (outcome === 'declined') say(() => said().declined(nameOf(holder ?? '')), 'stays');
  else if (outcome === 'overtaken') say(() => said().overtaken, 'stays');
  else if (outcome === 'silent') say(() => said().silent, 'stays');
}

function tellHolder({ who, device }: EndedRequestPublic, outcome: Passed): void {
  const to = described(who, device);
  say(() => words.value.handover.told[outcome](to), PASSED[outcome]);
}
