import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { ControlPublic } from '../api';
import { ask } from '../ui/client';
import { Facts } from '../ui/facts';
import { Press } from '../ui/press';
import { Refusal } from '../ui/refusal';
import { seconds } from '../ui/units';
import { adminWords } from './admin-words';
import { milliseconds } from './milliseconds';

const QUESTIONS = 40;
const PAUSE_MS = 100;
/** Of a lease: an answer that takes longer comes too near to it (`server/runs/link.py`). */
const ADVISED_SHARE = 0.75;

/** How the service answers this device, measured where it stands: round trips in s, null for a question without an answer. */
export function OwnConnection({ cells }: { cells: ControlPublic[] }) {
  const said = adminWords.value.connections;
  const trips = useSignal<(number | null)[]>([]);
  const leaving = useRef(false);
  useEffect(() => {
    leaving.current = false;
    return () => {
      leaving.current = true;
    };
  }, []);
  const measure = async () => {
    trips.value = [];
    while (trips.value.length < QUESTIONS && !leaving.current) {
      trips.value = [...trips.value, await roundTrip()];
      await new Promise((resolve) => window.setTimeout(resolve, PAUSE_MS));
    }
  };
  const done = trips.value.length;
  return (
    <section class="own-connection">
      <h2>{said.here}</h2>
      <p class="hint">{said.hereHint}</p>
      <div class="row">
        <Press act={measure}>{said.measure}</Press>
        {done > 0 && done < QUESTIONS && <span role="status">{said.measuring(done, QUESTIONS)}</span>}
      </div>
      {done === QUESTIONS && <Measured trips={trips.value} cells={cells} />}
    </section>
  );
}

async function roundTrip(): Promise<number | null> {
  const began_ms = performance.now();
  try {
    await ask('GET /api/session');
  } catch (error) {
    if (error instanceof Refusal) throw error;
    return null;
  }
  return (performance.now() - began_ms) / 1000;
}

function Measured({ trips, cells }: { trips: (number | null)[]; cells: ControlPublic[] }) {
  const said = adminWords.value.connections;
  const answered = trips.filter((each) => each !== null).sort((a, b) => a - b);
  const slowest_s = answered.at(-1) ?? Number.POSITIVE_INFINITY;
  const poor = cells.filter(({ lease_s }) => slowest_s > ADVISED_SHARE * lease_s);
  const shortest_s = Math.min(...poor.map(({ lease_s }) => lease_s));
  const facts = [
    { name: said.median, value: milliseconds(answered[Math.floor(answered.length / 2)] ?? Number.NaN) },
    { name: said.slowest, value: milliseconds(slowest_s) },
    { name: said.unanswered, value: said.of(trips.length - answered.length, trips.length) },
  ];
  return (
    <>
      {answered.length > 0 && <Facts facts={facts} />}
      {poor.length === 0 ? (
        <p role="status">✓ {said.good}</p>
      ) : (
        <p class="abnormal" role="alert">
          <span aria-hidden="true">▲</span>{' '}
          {said.poor(poor.map(({ cell }) => cell).join(', '), seconds(shortest_s))}
        </p>
      )}
    </>
  );
}
