import { socketAddress } from './client';
import { heardAt, now_ms, onReturn, unheard } from './connection';

const RETRY_MS = 200;
/** The service says something every half second or second: a socket that is silent for longer is opened anew. */
const SILENCE_MS = 2500;
/** There is no such thing, or it may not be seen. */
const REFUSED = 1008;

/**
 * Hears what the service says over a websocket, for as long as it is wanted; a lost or silent one is opened again.
 *
 * @param hear is called with each message.
 * @returns what ends it.
 */
export function hearAll<M extends object>(path: string, hear: (message: M) => void): () => void {
  let socket: WebSocket | null = null;
  let timer = 0;
  let heard_ms = 0;

  const open = () => {
    window.clearTimeout(timer);
    leave(socket);
    heard_ms = Date.now();
    const opened = new WebSocket(socketAddress(path));
    opened.onmessage = ({ data }) => {
      heard_ms = Date.now();
      const message = JSON.parse(data) as M;
      heardAt('at' in message ? Date.parse(String(message.at)) : null);
      hear(message);
    };
    opened.onclose = ({ code }) => {
      if (code === REFUSED) return;
      unheard();
      timer = window.setTimeout(open, RETRY_MS);
    };
    socket = opened;
  };
  const watch = now_ms.subscribe((now) => {
    if (socket !== null && now - heard_ms > SILENCE_MS) open();
  });
  const forget = onReturn(open);
  window.addEventListener('online', open);
  open();
  return () => {
    window.removeEventListener('online', open);
    forget();
    watch();
    window.clearTimeout(timer);
    leave(socket);
  };
}

/** A socket that is still being opened is closed once it is open: browsers take the other way for a failure. */
export function leave(socket: WebSocket | null): void {
  if (socket === null) return;
  socket.onclose = null;
  socket.onmessage = null;
  if (socket.readyState === WebSocket.CONNECTING) socket.onopen = () => socket.close();
  else socket.close();
}
