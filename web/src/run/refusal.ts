import type { RunPublic } from '../api';
import { cell } from '../cells/cells';
import { spelt } from '../ui/units';
import { words } from '../words';
import type { Message } from '../words/catalogue';
import { sayValue } from '../words/messages';
import type { Field } from './order';

/** Where what a run was refused for can be changed: a field of its order, or the cell. */
export type Remedy = Field | 'home' | 'zone';

type Parameters = NonNullable<Message['parameters']>;

/** Why nothing could be planned, in words of what was typed and in the chosen units; null where the engine's say it as well. */
export function refusalSaid({ code, parameters = {} }: Message): string | null {
  const said = words.value.refusal;
  switch (code) {
    case 'robot-box-inside-at-home':
    case 'robot-box-near-at-home':
      return said.atHome(pairSaid({ ...parameters, first: 'payload' }));
    case 'robot-home-too-close':
      return said.atHome(pairSaid(parameters));
    case 'planning-end-inside':
    case 'planning-end-too-close':
    case 'planning-stands-inside':
    case 'planning-stands-too-close':
      return said.atStart(pairSaid(parameters));
    case 'planning-no-start-configuration':
      return said.noStart(String(parameters.axis));
    case 'planning-no-start-configuration-near':
      return `${said.noStart(String(parameters.axis))} ${said.nearest(lengthOf(parameters.best_clearance_m), bodySaid(parameters.nearest))}`;
    case 'planning-other-axes':
      return `${refusalSaid(parameters.refusal as Message) ?? sayValue(parameters.refusal)} ${said.otherAxes(String(parameters.axes))}`;
    case 'planning-no-path':
      return said.noPath;
    case 'planning-too-heavy': {
      const [needed, limit] = [parameters.torque_n_m, parameters.limit_n_m].map((torque) =>
        spelt('torque', Number(torque)),
      );
      return said.tooHeavy(String(parameters.joint), needed ?? '', limit ?? '');
    }
    default:
      return null;
  }
}

/** What may be changed so that it can be planned, the likeliest first. */
export function remediesFor({ reason, in_the_way, order }: RunPublic): Remedy[] {
  if (reason === null) return [];
  const zone: Remedy[] = cell.value?.zones?.some(({ name }) => name === in_the_way) ? ['zone'] : [];
  const { code, parameters = {} } = reason as Message;
  const cause = code === 'planning-other-axes' ? (parameters.refusal as Message).code : code;
  const axes: Remedy[] = (order.axes ?? 'xyz').length > 1 ? ['axes'] : [];
  if (cause.startsWith('robot-box')) return ['box', 'tool', ...zone, 'home'];
  if (cause.startsWith('robot-')) return [...zone, 'home'];
  if (cause.startsWith('planning-too-heavy')) return ['tool', 'mass', 'home'];
  if (cause.startsWith('planning-no-start')) return [...axes, 'box', ...zone, 'effort'];
  if (cause.startsWith('planning-end') || cause.startsWith('planning-stands'))
    return ['box', 'tool', ...zone];
  if (cause.startsWith('planning-')) return ['effort', 'box', ...zone];
  return cause.startsWith('runs-speed') ? ['speed'] : [];
}

/** Two bodies that are too near each other. */
function pairSaid({ first, second, distance_m, depth_m, required_m }: Parameters): string {
  const said = words.value.refusal;
  const depth = Number(depth_m ?? -Number(distance_m));
  const [one, other] = [bodySaid(first), bodySaid(second)];
  return depth > 0
    ? said.inside(one, lengthOf(depth), other)
    : said.near(one, lengthOf(-depth), other, lengthOf(required_m));
}

/** A body by its name: of what the sensor carries it is the box that counts. */
function bodySaid(body: unknown): string {
  if (typeof body !== 'object' || body === null)
    return body === 'payload' ? words.value.refusal.carried : String(body);
  const { code, parameters } = body as Message;
  if (code === 'body-payload') return words.value.refusal.carried;
  return parameters?.name === undefined ? sayValue(body) : String(parameters.name);
}

const lengthOf = (length_m: unknown) => spelt('length', Number(length_m));
