/**
 * Keeps control of a cell: sends the server's stamps back at once. It does so beside the page, because drawing in three dimensions
 * can hold the page up for longer than an answer may take; but a page that stands still for good cannot be stopped from, so
 * without its sign of life no stamp is answered.
 */
export type ToLease = { kind: 'keep'; address: string; fence: number } | { kind: 'alive' };
export type FromLease = { kind: 'stamp'; stamp_s: number } | { kind: 'lost' };

const PAGE_PATIENCE_MS = 2000;

let alive_ms = 0;

function keep(address: string, fence: number): void {
  const socket = new WebSocket(address);
  let number = 0;
  socket.onmessage = ({ data }) => {
    const { stamp_s } = JSON.parse(data) as { stamp_s: number };
    if (performance.now() - alive_ms > PAGE_PATIENCE_MS) return;
    socket.send(JSON.stringify({ fence, number, stamp_s }));
    number += 1;
    tell({ kind: 'stamp', stamp_s });
  };
  socket.onclose = () => tell({ kind: 'lost' });
}

function tell(message: FromLease): void {
  self.postMessage(message);
}

self.onmessage = ({ data }: MessageEvent<ToLease>) => {
  alive_ms = performance.now();
  if (data.kind === 'keep') keep(data.address, data.fence);
};
