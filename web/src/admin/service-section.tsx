import type { ComponentChildren } from 'preact';
import type { Versions } from '../api';
import { ask } from '../ui/client';
import { moment, number } from '../ui/units';
import { adminWords } from './admin-words';
import { useAnswer } from './answer';
import { DiskRoom } from './disk-room';

/** What this service is made of, the room it has, and what to send when something is wrong with it. */
export function ServiceSection() {
  return (
    <div class="halves">
      <DiskRoom />
      <div class="stack">
        <Bundle />
        <MadeOf />
      </div>
    </div>
  );
}

function Bundle() {
  const said = adminWords.value.service;
  return (
    <section>
      <h2>{said.bundle}</h2>
      <p>{said.bundleWhat}</p>
      <p class="hint">{said.bundleNot}</p>
      <div class="row">
        <a class="download" href="/api/support/bundle" download>
          {said.bundleAct}
        </a>
        <span class="hint">{said.bundleWait}</span>
      </div>
    </section>
  );
}

function MadeOf() {
  const said = adminWords.value.service;
  const { answer } = useAnswer(() => ask('GET /api/support/versions'));
  return (
    <section>
      <h2>{said.versions}</h2>
      {answer.value && <VersionFacts versions={answer.value} />}
    </section>
  );
}

function VersionFacts({ versions }: { versions: Versions }) {
  const said = adminWords.value.service;
  const rows: [string, ComponentChildren][] = [
    [said.release, <code key="">{versions.release}</code>],
    [said.engine, <code key="">{versions.engine}</code>],
    [said.started, moment(versions.started_at)],
    [said.database, <code key="">{versions.database}</code>],
    [said.tables, <code key="">{versions.schema_revision}</code>],
    [said.python, <code key="">{versions.python}</code>],
    [said.system, <code key="">{versions.system}</code>],
    [said.processors, number(versions.processors, 0)],
  ];
  return (
    <>
      <table>
        <tbody>
          {rows.map(([name, value]) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{value}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <details class="libraries">
        <summary>{said.libraries(versions.packages.length)}</summary>
        <ul>
          {versions.packages.map(({ name, version }) => (
            <li key={name}>
              <code>
                {name} {version}
              </code>
            </li>
          ))}
        </ul>
      </details>
    </>
  );
}
