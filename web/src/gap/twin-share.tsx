import type { ResultPublic } from '../api';
import { to } from '../ui/route';
import { spelt } from '../ui/units';
import { words } from '../words';
import { effectName } from './effect-values';

type Share = NonNullable<ResultPublic['twin']>[number];

/** Which entries of the cell's twin a result takes into account, and how much each of them changes it. */
export function TwinShare({ shares = [] }: { shares: Share[] | undefined }) {
  const said = words.value.gap.twinShare;
  if (shares.length === 0) return null;
  return (
    <section class="twin-share">
      <h2>{said.title}</h2>
      <p class="hint">{said.note}</p>
      <ul>
        {shares.map((share) => (
          <li key={share.effect}>
            <b>{effectName(share.effect)}</b>
            <p>{changeOf(share)}</p>
            <small>{words.value.gap.from(share.recording)}</small>
          </li>
        ))}
      </ul>
      <a class="download" href={to('gap')}>
        {words.value.gap.twin}
      </a>
    </section>
  );
}

function changeOf({ change }: Share): string {
  const [mass, ...rest] = change;
  const known = (values: (number | null)[]) => values.filter((value) => value !== null);
  const inertia = known(rest.slice(3)).map(Math.abs);
  return words.value.gap.twinShare.changed(
    mass == null ? words.value.notDetermined : spelt('mass', mass),
    spelt('moment', Math.hypot(...known(rest.slice(0, 3)))),
    inertia.length === 0 ? words.value.notDetermined : spelt('inertia', Math.max(...inertia)),
  );
}
