import type { ClosestPair, LeftOutPair, PlanSummary } from '../api';
import { MessageText } from '../ui/message-text';
import { number, seconds, spelt } from '../ui/units';
import { words } from '../words';
import { say } from '../words/messages';
import { partMessage } from './part-message';

/** What a check found that shares no code with the planner: where it is closest, where it is fastest, and what it does not judge. */
export function SecondLook({ summary }: { summary: PlanSummary }) {
  const said = words.value.secondLook;
  const found = summary.second_opinion;
  if (!found) return null;
  const { body, speed_m_s, limit_m_s, part, time_s } = found.fastest;
  return (
    <section class="second-look">
      <h2>{said.title}</h2>
      <p>{said.how(number(found.samples, 0))}</p>
      <table>
        <thead>
          <tr>
            <th scope="col">{said.what}</th>
            <th scope="col">{said.least}</th>
            <th scope="col">{said.where}</th>
          </tr>
        </thead>
        <tbody>
          {found.closest.map((each) => (
            <Closest key={each.kind} {...each} />
          ))}
          <tr>
            <th scope="row">{said.fastest}</th>
            <td>
              {spelt('speed', speed_m_s)} <small>{said.limit(spelt('speed', limit_m_s))}</small>
            </td>
            <td>
              {said.corner(bodySaid(body))} <small>{when(part, time_s)}</small>
            </td>
          </tr>
          <LostLoad summary={summary} />
          <Torque summary={summary} />
        </tbody>
      </table>
      <LeftOut pairs={summary.left_out ?? []} />
    </section>
  );
}

/** A kind of pair where it comes closest to what it has to keep. */
function Closest({ kind, first, second, distance_m, required_m, part, time_s }: ClosestPair) {
  const said = words.value.secondLook;
  return (
    <tr>
      <th scope="row">{said.kinds[kind] ?? kind}</th>
      <td>
        {spelt('length', distance_m)}{' '}
        <small>{required_m < 0 ? said.mayTouch : said.limit(spelt('length', required_m))}</small>
      </td>
      <td>
        {betweenSaid(first, second)} <small>{when(part, time_s)}</small>
      </td>
    </tr>
  );
}

/** How far a load that comes off anywhere on the way flies past a zone. */
function LostLoad({ summary }: { summary: PlanSummary }) {
  const said = words.value.secondLook;
  const lost = summary.second_opinion?.lost_load;
  if (!lost) return null;
  return (
    <tr>
      <th scope="row">{said.lost}</th>
      <td>{spelt('length', lost.distance_m)}</td>
      <td>
        {said.past(lost.zone)} <small>{when(lost.part, lost.time_s)}</small>
      </td>
    </tr>
  );
}

/** The joint that has to give the largest share of its torque. */
function Torque({ summary }: { summary: PlanSummary }) {
  const said = words.value.secondLook;
  const most = summary.torques?.largest;
  if (!most) return null;
  return (
    <tr>
      <th scope="row">{said.torque}</th>
      <td>
        {said.ofTorque(spelt('torque', most.torque_n_m), number(100 * most.ratio, 0))}{' '}
        <small>{said.limit(spelt('torque', most.limit_n_m))}</small>
      </td>
      <td>
        {most.joint} <small>{when(most.part, most.time_s)}</small>
      </td>
    </tr>
  );
}

/** Pairs of which nothing is asked, those with the same reason together. */
function LeftOut({ pairs }: { pairs: LeftOutPair[] }) {
  const said = words.value.secondLook;
  if (pairs.length === 0) return null;
  const reasons = new Map(pairs.map(({ why }) => [why.text, why]));
  return (
    <details class="others">
      <summary>{said.leftOut(pairs.length)}</summary>
      <ul>
        {[...reasons].map(([text, why]) => (
          <li key={text}>
            <MessageText message={why} />
            <small>
              {pairs
                .filter((pair) => pair.why.text === text)
                .map(({ first, second }) => betweenSaid(first, second))
                .join(', ')}
            </small>
          </li>
        ))}
      </ul>
    </details>
  );
}

/** Two bodies by their names. */
export const betweenSaid = (first: string, second: string) =>
  words.value.secondLook.between(bodySaid(first), bodySaid(second));

const bodySaid = (name: string) => (name === 'payload' ? words.value.secondLook.load : name);

const when = (part: string, time_s: number) =>
  words.value.secondLook.when(say(partMessage(part)), seconds(time_s));
