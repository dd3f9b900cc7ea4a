import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { may } from '../session/session';
import { secondsUntil } from '../ui/connection';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { clock } from '../ui/units';
import { words } from '../words';
import {
  answerRequest,
  asked,
  askForControl,
  control,
  elsewhere,
  holder,
  mine,
  takeControl,
  withdrawRequest,
} from './control';
import { described } from './control-told';
import { askingFence } from './lease';

/** Somebody asks for control that this screen has, or this screen asks: on every page, until it is answered or time has passed. */
export function ControlRequest() {
  const request = control.value?.request ?? null;
  if (request === null) return null;
  if (mine.value && !request.accepted) return <Asked />;
  return asked.value && request.fence === askingFence.value ? <Asking /> : null;
}

/** Hand over or keep: with one tap. */
function Asked() {
  const said = words.value.handover;
  const known = control.value;
  if (known?.request == null) return null;
  const { cell, request } = known;
  const answer = (accept: boolean) => () => answerRequest(cell, request.fence, accept);
  return (
    <section class="control-request" role="alert" aria-label={said.title}>
      <Folded inShort={said.asks(nameOf(request.who))} left={clock(secondsUntil(request.passes_at))}>
        <p>
          <b>{said.asks(described(request.who, request.device))}</b> {said.goesOn}
        </p>
        <Countdown passes_at={request.passes_at} asked_at={request.asked_at} says={said.passesIn} />
      </Folded>
      <div class="answers">
        <Press kind="primary" act={answer(true)}>
          {said.accept}
        </Press>
        <Press act={answer(false)}>{said.keep}</Press>
      </div>
    </section>
  );
}

function Asking() {
  const said = words.value.handover;
  const known = control.value;
  if (known?.request == null) return null;
  const { request } = known;
  const from = known.holder === null ? said.nobody : described(known.holder, known.device ?? '');
  return (
    <section class="control-request" role="status" aria-label={said.title}>
      <Folded
        inShort={request.accepted ? said.passing : said.askedShort}
        left={clock(secondsUntil(request.passes_at))}
      >
        <p>
          <b>{request.accepted ? said.passing : said.asked(from)}</b>
        </p>
        <Countdown passes_at={request.passes_at} asked_at={request.asked_at} says={said.passesToYou} />
      </Folded>
      <div class="answers">
        <Press act={() => withdrawRequest(known.cell)}>{said.withdraw}</Press>
      </div>
    </section>
  );
}

interface Parts {
  inShort: string;
  /** Until control passes. */
  left: string;
  children: ComponentChildren;
}

/** On a phone one line that unfolds by a tap, for the page needs the room; elsewhere all of it. */
function Folded({ inShort, left, children }: Parts) {
  const open = useSignal(false);
  const flip = () => {
    open.value = !open.value;
  };
  return (
    <>
      <button type="button" class="unfold" aria-expanded={open.value} onClick={flip}>
        <b>{inShort}</b> <span>{left}</span>
        <span aria-hidden="true">{open.value ? '▴' : '▾'}</span>
      </button>
      <div class={open.value ? 'asked unfolded' : 'asked'}>{children}</div>
    </>
  );
}

interface Times {
  asked_at: string;
  passes_at: string;
  says: (left: string) => string;
}

/** How long it is until control passes by itself: a shape that empties, and words. */
function Countdown({ asked_at, passes_at, says }: Times) {
  const whole_s = (Date.parse(passes_at) - Date.parse(asked_at)) / 1000;
  const left_s = Math.min(whole_s, secondsUntil(passes_at));
  const text = says(clock(left_s));
  return (
    <div class="countdown" role="timer" aria-live="off">
      <progress max={whole_s} value={left_s} aria-label={text} />
      <span>{text}</span>
    </div>
  );
}

/** Asks for control that somebody else has; one's own on another screen comes here at once. Where neither is the case: nothing. */
export function AskForControl() {
  const said = words.value.handover;
  const known = control.value;
  if (known === null || !may('operator') || mine.value || holder.value === null) return null;
  if (elsewhere.value) return <Press act={() => takeControl(known.cell)}>{said.takeHere}</Press>;
  return known.request === null ? <Press act={() => askForControl(known.cell)}>{said.ask}</Press> : null;
}

/** Who else asks for control, where that is no business of this screen. */
export function OthersAsk() {
  const request = control.value?.request ?? null;
  if (request === null || mine.value || asked.value) return null;
  const said = words.value.handover;
  return <p>{said.othersAsk(nameOf(request.who), clock(secondsUntil(request.passes_at)))}</p>;
}
