import type { LinkPublic } from '../api';
import { number, percent, seconds } from '../ui/units';
import { words } from '../words';
import { control, mine } from './control';

/** How good the connection is that a run would depend on; a poor one is warned of, not refused. */
export function LinkFigures() {
  const said = words.value.link;
  const known = control.value;
  if (!mine.value || known === null) return null;
  const { link } = known;
  const lease = seconds(known.lease_s);
  return (
    <section class="link-figures">
      {link?.advised === false && (
        <p class="abnormal">
          <span aria-hidden="true">▲</span> {said.poor}
        </p>
      )}
      <p>
        <b>{said.title}:</b> {link === null ? said.measuring : figures(link, lease)}
      </p>
      <p class="hint">{said.hint(lease)}</p>
    </section>
  );
}

function figures(link: LinkPublic, lease: string): string {
  const [usual, mostly] = [milliseconds(link.round_trip_p50_s), milliseconds(link.round_trip_p99_s)];
  return words.value.link.figures(
    usual,
    mostly,
    percent(link.lost_share),
    seconds(link.longest_gap_s),
    lease,
  );
}

function milliseconds(time_s: number): string {
  return `${number(1000 * time_s, 0)} ms`;
}
