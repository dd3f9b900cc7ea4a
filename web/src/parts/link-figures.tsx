import { control, mine } from '../stores/control';
import { number, percent, seconds } from '../units';
import { words } from '../words';
import { Facts } from './facts';

/** How good the connection is that a run would depend on; a poor one is warned of, not refused. */
export function LinkFigures() {
  const said = words.value.link;
  const known = control.value;
  if (!mine.value || known === null) return null;
  const lease = seconds(known.lease_s);
  const { link } = known;
  return (
    <section class="link-figures">
      <h2>{said.title}</h2>
      {link?.advised === false && (
        <p class="abnormal">
          <span aria-hidden="true">▲</span> {said.poor}
        </p>
      )}
      {link === null ? (
        <p>{said.measuring}</p>
      ) : (
        <Facts
          facts={[
            {
              name: said.roundTrip,
              value: milliseconds(link.round_trip_p50_s),
              note: said.mostly(milliseconds(link.round_trip_p99_s)),
            },
            { name: said.lost, value: percent(link.lost_share), note: said.ofAnswers(link.answers) },
            { name: said.longest, value: seconds(link.longest_gap_s), note: said.limit(lease) },
          ]}
        />
      )}
      <p class="hint">{said.hint(lease)}</p>
    </section>
  );
}

function milliseconds(time_s: number): string {
  return `${number(1000 * time_s, 0)} ms`;
}
