import type { ResultSummary } from '../api';
import type { Quantity } from '../ui/units';
import type { Words } from '../words/en';

/** What can be followed from run to run. */
export type Followed = keyof Words['history']['parameters'];

interface Parameter {
  quantity: Quantity;
  /** Value and standard uncertainty, SI; null where it is not determined. */
  of: (result: ResultSummary) => [number | null | undefined, number | null | undefined];
}

const com = (k: number): Parameter => ({
  quantity: 'length',
  of: ({ com_m, com_std_m }) => [com_m[k], com_std_m[k]],
});
const offset = (k: number): Parameter => ({
  quantity: k < 3 ? 'force' : 'torque',
  of: (result) => [result.offset[k], result.offset_std[k]],
});

export const PARAMETERS: Record<Followed, Parameter> = {
  mass: { quantity: 'mass', of: ({ mass_kg, mass_std_kg }) => [mass_kg, mass_std_kg] },
  com_x: com(0),
  com_y: com(1),
  com_z: com(2),
  offset_fx: offset(0),
  offset_fy: offset(1),
  offset_fz: offset(2),
  offset_tx: offset(3),
  offset_ty: offset(4),
  offset_tz: offset(5),
};
