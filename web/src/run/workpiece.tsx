import type { IdentificationPublic } from '../api';
import { MessageText } from '../ui/message-text';
import { spelt } from '../ui/units';
import { words } from '../words';
import { ParameterTable } from './parameter-table';

/** The workpiece without the tools that the cell knows; nothing where it knows none. */
export function Workpiece({ answer }: { answer: IdentificationPublic }) {
  const said = words.value.result;
  const alone = answer.workpiece;
  if (alone == null) return null;
  const tools = alone.tools.map((tool) => `${tool.title} (${spelt('mass', tool.phi[0] ?? 0)})`);
  return (
    <section class="workpiece">
      <h2>{said.workpiece}</h2>
      <p class="hint">{said.withoutTools(tools.join(', '))}</p>
      <ParameterTable
        answer={{
          mass_kg: alone.phi[0] ?? null,
          mass_std_kg: alone.std[0] ?? null,
          com_m: alone.com_m,
          com_std_m: alone.com_std_m,
          inertia_com_kg_m2: alone.inertia_com_kg_m2,
          inertia_com_std_kg_m2: alone.inertia_com_std_kg_m2,
          reasons: answer.reasons,
          reference: alone.reference,
        }}
      />
      {alone.remarks.map((each) => (
        <p class="hint" key={each.text}>
          <MessageText message={each} />
        </p>
      ))}
    </section>
  );
}
