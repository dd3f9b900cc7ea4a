import type { IdentificationPublic } from '../api';
import { spelt } from '../ui/units';
import { words } from '../words';
import { payloadRows } from './payload-rows';

/** What a run found, in a sentence: the mass, and what of the rest is determined. */
export function resultSentence(answer: IdentificationPublic): string {
  const said = words.value.result;
  const { mass_kg, mass_std_kg } = answer;
  if (mass_kg === null) return said.verdict.nothing;
  const mass = spelt('mass', mass_kg, mass_std_kg);
  const missing = payloadRows(answer).filter(({ value }) => value == null);
  if (missing.length === 0) return said.verdict.all(mass);
  const inertia = missing.filter(({ part }) => part === 'inertia');
  if (inertia.length === missing.length && inertia.length === 6) return said.verdict.noInertia(mass);
  const names = missing.map(({ part, axis }) => `${said[part]} ${axis}`.trim());
  return said.verdict.some(mass, names.join(', '));
}
