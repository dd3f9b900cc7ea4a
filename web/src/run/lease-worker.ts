/**
 * Keeps control of a cell: sends the server's stamps back at once, and opens a lost connection again with the same fence. It does so
 * beside the page, because drawing in three dimensions can hold the page up for longer than an answer may take. With each answer
 * it says how long ago the page itself gave a sign of life: a page that stands still cannot be stopped from.
 */
export type ToLease = { kind: 'keep'; address: string; fence: number } | { kind: 'alive' };
export type FromLease = { kind: 'stamp'; stamp_s: number } | { kind: 'closed' } | { kind: 'refused' };

const RETRY_MS = 300;
/** Stamps come every 50 ms: a socket without one for so long is lost, whether or not anybody has closed it. */
const SILENCE_MS = 1500;
const LOOK_MS = 250;
const POLICY_VIOLATION = 1008;

let alive_ms = performance.now();
let number = 0;

function keep(address: string, fence: number): void {
  let socket: WebSocket | null = null;
  let heard_ms = 0;
  let retry = 0;
  const open = () => {
    self.clearTimeout(retry);
    leave(socket);
    heard_ms = performance.now();
    const opened = new WebSocket(address);
    opened.onmessage = ({ data }) => {
      heard_ms = performance.now();
      answer(opened, fence, (JSON.parse(data) as { stamp_s: number }).stamp_s);
    };
    opened.onclose = ({ code }) => {
      tell({ kind: code === POLICY_VIOLATION ? 'refused' : 'closed' });
      retry = self.setTimeout(open, RETRY_MS);
    };
    socket = opened;
  };
  open();
  self.addEventListener('online', open);
  self.setInterval(() => {
    if (performance.now() - heard_ms < SILENCE_MS) return;
    tell({ kind: 'closed' });
    open();
  }, LOOK_MS);
}

function answer(socket: WebSocket, fence: number, stamp_s: number): void {
  const page_age_s = (performance.now() - alive_ms) / 1000;
  socket.send(JSON.stringify({ fence, number, stamp_s, page_age_s }));
  number += 1;
  tell({ kind: 'stamp', stamp_s });
}

function leave(socket: WebSocket | null): void {
  if (socket === null) return;
  socket.onclose = null;
  socket.onmessage = null;
  socket.close();
}

function tell(message: FromLease): void {
  self.postMessage(message);
}

self.onmessage = ({ data }: MessageEvent<ToLease>) => {
  alive_ms = performance.now();
  if (data.kind === 'keep') keep(data.address, data.fence);
};
