import type { Disk } from '../api';
import { ask } from '../ui/client';
import { Facts } from '../ui/facts';
import { number } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';

const PATIENCE_MS = 60_000;
const HOUR_S = 3600;
const MEGA = 1e6;
const GIGA = 1e9;

/** What is left on the disk of the data folder, and what takes it. */
export function DiskRoom() {
  const said = adminWords.value.service;
  const { answer } = useAnswer(() => ask('GET /api/support/disk', { patience_ms: PATIENCE_MS }));
  return (
    <section>
      <h2>{said.disk}</h2>
      {answer.value && <Room disk={answer.value} />}
    </section>
  );
}

function Room({ disk }: { disk: Disk }) {
  const said = adminWords.value.service;
  const hours = disk.robot_s / HOUR_S;
  const facts = [
    { name: said.free, value: said.of(bytes(disk.free_bytes), bytes(disk.total_bytes)) },
    { name: said.room, value: said.robotTime(number(hours, hours < 10 ? 1 : 0)) },
  ];
  return (
    <>
      <Facts facts={facts} />
      {disk.little && (
        <p class="abnormal" role="alert">
          <span aria-hidden="true">▲</span> {said.little}
        </p>
      )}
      <table>
        <caption class="hint">{said.what}</caption>
        <thead>
          <tr>
            <th scope="col">{said.part}</th>
            <th scope="col">{said.size}</th>
            <th scope="col">{said.files}</th>
          </tr>
        </thead>
        <tbody>
          {disk.parts.map(({ name, size_bytes, files }) => (
            <tr key={name}>
              <th scope="row">{said.parts[name]}</th>
              <td>{bytes(size_bytes)}</td>
              <td>{number(files, 0)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="hint">{said.diskHint}</p>
    </>
  );
}

/** A size as disks are labelled. */
function bytes(size: number): string {
  if (size >= GIGA) return `${number(size / GIGA, 1)} GB`;
  if (size >= MEGA) return `${number(size / MEGA, 1)} MB`;
  return `${number(size / 1e3, 1)} kB`;
}
