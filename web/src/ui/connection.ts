import { computed, signal, untracked } from '@preact/signals';
import { Refusal } from './refusal';

const TICK_MS = 250;
/** Ticks without any answer until the connection counts as lost. Ticks, not time: a page that stood still itself has not waited. */
const PATIENCE_TICKS = 5;
/** The same from a request on that did not get through: long enough for the next ones. */
const DOUBT_TICKS = 3;
const RETRY_MS = 1000;
/** How long the page stays covered until everything on it has been read anew. */
const REREAD_MS = 2000;

/** The tablet's clock, ms; goes on with every tick. */
export const now_ms = signal(Date.now());
/** When the service was heard of last, by the tablet's clock, ms; null while the connection is there. */
export const lostSince_ms = signal<number | null>(null);
/** Whether nothing can be asked of the service, so that neither is STOP. */
export const lost = computed(() => lostSince_ms.value !== null);

let heard_ms = Date.now();
let ticks = 0;
let ahead_ms = 0;
let returning = false;
const rereads = new Set<() => unknown>();

/** Notes an answer of the service, whatever it says, and by how much its clock goes before the tablet's. */
export function heard(answer: Response): void {
  heardAt(Date.parse(answer.headers.get('Date') ?? ''));
}

/** Notes that the service has said something, and when by its own clock, ms, where it says so. */
export function heardAt(service_ms: number | null): void {
  heard_ms = Date.now();
  ticks = 0;
  if (service_ms !== null && !Number.isNaN(service_ms)) ahead_ms = service_ms - heard_ms;
  if (lost.peek()) void comeBack();
}

/** Notes that a request did not get through. */
export function unheard(): void {
  ticks = Math.max(ticks, PATIENCE_TICKS - DOUBT_TICKS);
}

/** How long it is until a moment that the service named, s. Both clocks are compared to a second. */
export function secondsUntil(moment: string): number {
  return Math.max(0, (Date.parse(moment) - ahead_ms - now_ms.value) / 1000);
}

/** Has something done whenever a lost connection is back, before the page is uncovered; returns what ends that. */
export function onReturn(reread: () => unknown): () => void {
  rereads.add(reread);
  return () => rereads.delete(reread);
}

async function comeBack(): Promise<void> {
  if (returning) return;
  returning = true;
  const patience = new Promise((resolve) => window.setTimeout(resolve, REREAD_MS));
  await Promise.race([Promise.allSettled([...rereads].map((reread) => reread())), patience]);
  returning = false;
  if (ticks < PATIENCE_TICKS) lostSince_ms.value = null;
}

window.setInterval(() => {
  now_ms.value = Date.now();
  ticks = document.hidden ? 0 : ticks + 1;
  if (ticks >= PATIENCE_TICKS) lostSince_ms.value ??= heard_ms;
}, TICK_MS);

/** Asks again and again while somebody looks; returns what ends it. */
export function every(period_ms: number, ask: () => Promise<void>, retry_ms = period_ms): () => void {
  return asked(ask, (answered) => (answered ? period_ms : retry_ms));
}

/** Asks until there is an answer, be it a no, and once more whenever a lost connection is back; returns what ends it. */
export function until(ask: () => Promise<void>): () => void {
  return asked(ask, (answered) => (answered ? null : RETRY_MS));
}

function asked(ask: () => Promise<void>, again_ms: (answered: boolean) => number | null): () => void {
  let timer = 0;
  let turn = 0;
  const round = async (): Promise<void> => {
    window.clearTimeout(timer);
    turn += 1;
    const mine = turn;
    const answered = await ask().then(
      () => true,
      (error) => error instanceof Refusal,
    );
    const next_ms = again_ms(answered);
    if (mine === turn && next_ms !== null) timer = window.setTimeout(round, next_ms);
  };
  const forget = onReturn(round);
  void untracked(round);
  return () => {
    turn += 1;
    window.clearTimeout(timer);
    forget();
  };
}
