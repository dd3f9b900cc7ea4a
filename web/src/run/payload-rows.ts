import type { IdentificationPublic, Message } from '../api';
import type { Quantity } from '../ui/units';
import { say } from '../words/messages';

/** One line of the answer; SI. */
export interface Row {
  key: string;
  part: 'mass' | 'com' | 'inertia';
  axis: string;
  quantity: Quantity;
  value: number | null | undefined;
  std: number | null | undefined;
  reference: number | null | undefined;
  reason: string | undefined;
}

const AXES = ['x', 'y', 'z'];
const MOMENTS = ['xx', 'xy', 'xz', 'yy', 'yz', 'zz'];
const PHI = ['m', 'mc_x', 'mc_y', 'mc_z', 'Ixx', 'Ixy', 'Ixz', 'Iyy', 'Iyz', 'Izz'];

/** What an answer says of a body. */
export type Body = Pick<
  IdentificationPublic,
  | 'mass_kg'
  | 'mass_std_kg'
  | 'com_m'
  | 'com_std_m'
  | 'inertia_com_kg_m2'
  | 'inertia_com_std_kg_m2'
  | 'reasons'
  | 'reference'
>;

/** Its ten parameters: mass, centre of mass, inertia about it. */
export function payloadRows(answer: Body): Row[] {
  const reference = aboutCom(answer.reference?.phi ?? []);
  const row = (
    part: Row['part'],
    axis: string,
    quantity: Quantity,
    k: number,
    value?: number | null,
    std?: number | null,
  ): Row => ({
    key: part + axis,
    part,
    axis,
    quantity,
    value,
    std,
    reference: reference[k],
    reason: whyNot(answer.reasons[PHI[k] ?? '']),
  });
  return [
    row('mass', '', 'mass', 0, answer.mass_kg, answer.mass_std_kg),
    ...AXES.map((axis, k) => row('com', axis, 'length', 1 + k, answer.com_m[k], answer.com_std_m[k])),
    ...MOMENTS.map((axis, k) =>
      row('inertia', axis, 'inertia', 4 + k, answer.inertia_com_kg_m2[k], answer.inertia_com_std_kg_m2[k]),
    ),
  ];
}

/** Mass, centre of mass and inertia about it, of parameters about the sensor (the parallel-axis theorem). */
function aboutCom(phi: (number | null)[]): (number | null)[] {
  const [m, cx, cy, cz, ...inertia] = phi;
  if (m == null || cx == null || cy == null || cz == null || m <= 0) return [];
  const r = [cx / m, cy / m, cz / m] as const;
  const squared = r[0] ** 2 + r[1] ** 2 + r[2] ** 2;
  const steiner = [
    [0, 0],
    [0, 1],
    [0, 2],
    [1, 1],
    [1, 2],
    [2, 2],
  ].map(([i = 0, j = 0]) => m * ((i === j ? squared : 0) - (r[i] ?? 0) * (r[j] ?? 0)));
  return [m, ...r, ...inertia.map((value, k) => (value == null ? null : value - (steiner[k] ?? 0)))];
}

/** Why a parameter is not determined, where it is not. */
function whyNot(reason: Message | undefined): string | undefined {
  return reason && say(reason);
}
