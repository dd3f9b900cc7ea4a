import type { DiagnosisPublic } from '../api';
import { spelt } from '../ui/units';
import { words } from '../words';
import { effectName, openOf } from './effect-values';

type Diagnosis = NonNullable<DiagnosisPublic['result']>;

/** The answer of a diagnosis in a sentence. */
export function gapSentence(diagnosis: Diagnosis): string {
  const said = words.value.gap;
  const stage = (id: string | undefined) => said.stages[id ?? ''] ?? id ?? words.value.unknown;
  const named = openOf(diagnosis);
  const [best] = named;
  switch (diagnosis.verdict) {
    case 'explained':
      return said.verdict.explained(
        effectName(best?.id ?? ''),
        [...new Set(best?.stages ?? [])].map(stage).join(', '),
      );
    case 'ambiguous':
      return said.verdict.ambiguous(
        named.map(({ id }) => effectName(id)).join(` ${said.or} `),
        [...new Set(named.flatMap(({ stages }) => stages))].map(stage).join(', '),
      );
    case 'unknown':
      return said.verdict.unknown;
    default:
      return said.verdict[diagnosis.verdict];
  }
}

/** What is at stake for the payload if the effect is left out; null where there was too little to estimate one. */
export function consequence({ verdict, payload }: Diagnosis): string | null {
  const said = words.value.gap.payloadSaid;
  if (payload === null) return null;
  if (verdict === 'unknown') return said.unknown;
  const shift = payload.before.phi.map((value, k) => value - (payload.after.phi[k] ?? value));
  if (shift.every((each) => each === 0)) return said.same;
  const [mass = 0, ...rest] = shift;
  const moment = Math.hypot(...rest.slice(0, 3));
  const known = rest.slice(3).filter((_, k) => payload.after.determined?.[4 + k] !== false);
  const told = [spelt('mass', mass), spelt('moment', moment)] as const;
  if (known.length === 0) return said.shiftedButInertia(...told);
  return said.shifted(...told, spelt('inertia', Math.max(...known.map(Math.abs))));
}
