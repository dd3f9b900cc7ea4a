import { signal, untracked } from '@preact/signals';
import type { EventMessage, LiveBatch } from '../api';
import { socketAddress } from '../ui/client';
import { onReturn } from '../ui/connection';
import { leave } from '../ui/socket';
import { clearTraces, trace } from './traces';

/** What the socket of a run sends. */
export type LiveMessage = EventMessage | LiveBatch;

const RETRY_MS = 400;
const OVER = 1000;
/** There is no such run, or it may not be seen. */
const REFUSED = 1008;
/** How often samples are shown: often enough for the eye, and leaves a small tablet its time. */
const SHOW_MS = 100;

/** Events of the shown run, in their order. */
export const events = signal<EventMessage[]>([]);
/** The newest samples of the shown run. */
export const batch = signal<LiveBatch | null>(null);
/** Whether its socket is open, or rightly closed. */
export const following = signal(true);

/**
 * Follows a run: what has happened, then what happens. A lost socket is opened again and goes on behind the last event.
 *
 * @param heard is called for each event.
 * @returns what ends it.
 */
export function follow(run: string, heard: (message: EventMessage) => void): () => void {
  let socket: WebSocket | null = null;
  let timer = 0;
  let samples: LiveBatch[] = [];
  let ended = false;
  events.value = [];
  batch.value = null;
  clearTraces();

  const open = () => {
    window.clearTimeout(timer);
    const after = events.value.at(-1)?.sequence ?? 0;
    socket = new WebSocket(socketAddress(`/api/runs/${run}/live?after=${after}&samples=thin`));
    socket.onopen = () => {
      following.value = true;
    };
    socket.onmessage = ({ data }) => {
      const message = JSON.parse(data) as LiveMessage;
      if (ended) return;
      if (message.kind === 'samples') samples.push(message);
      else {
        events.value = [...events.value, message];
        heard(message);
      }
    };
    socket.onclose = ({ code }) => {
      if (ended || code === OVER || code === REFUSED) return;
      following.value = false;
      timer = window.setTimeout(open, RETRY_MS);
    };
  };
  const showing = window.setInterval(() => {
    const newest = samples.at(-1);
    if (newest === undefined) return;
    batch.value = newest;
    trace(samples);
    samples = [];
  }, SHOW_MS);
  const forget = onReturn(() => {
    if (socket !== null) socket.onclose = null;
    leave(socket);
    open();
  });
  untracked(open);
  return () => {
    ended = true;
    forget();
    window.clearTimeout(timer);
    window.clearInterval(showing);
    leave(socket);
    following.value = true;
  };
}
