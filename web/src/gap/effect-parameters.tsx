import { words } from '../words';
import { type Parameter, parameterShown, parameterTitle } from './effect-values';

/** So many of one effect are seen at once; a cross-talk has thirty. */
const CLEAREST = 6;

/** Parameters of an effect with their intervals, those that stand out most first. */
export function EffectParameters({ parameters }: { parameters: Record<string, Parameter> }) {
  const all = Object.entries(parameters);
  const clearest = all
    .toSorted(([, one], [, other]) => clearness(other) - clearness(one))
    .slice(0, CLEAREST)
    .map(([name]) => name);
  const rest = all.filter(([name]) => !clearest.includes(name));
  return (
    <>
      <List parameters={all.filter(([name]) => clearest.includes(name))} />
      {rest.length > 0 && (
        <details class="others">
          <summary>{words.value.gap.moreParameters(rest.length)}</summary>
          <List parameters={rest} />
        </details>
      )}
    </>
  );
}

function clearness({ value, std }: Parameter): number {
  return std === null || std <= 0 ? 0 : Math.abs(value) / std;
}

function List({ parameters }: { parameters: [string, Parameter][] }) {
  return (
    <dl class="effect-parameters">
      {parameters.map(([name, parameter]) => (
        <div key={name}>
          <dt>{parameterTitle(name, parameter)}</dt>
          <dd>
            <Sized name={name} parameter={parameter} />
          </dd>
        </div>
      ))}
    </dl>
  );
}

/** A value with its interval, or why there is none. */
function Sized({ name, parameter }: { name: string; parameter: Parameter }) {
  const said = words.value.gap;
  const { value, half, unit } = parameterShown(name, parameter);
  return (
    <span class="measured">
      <b>{value}</b>
      {half !== null && <i>± {half}</i>}
      <small>{unit}</small>
      {half === null && <small>({said.noInterval})</small>}
      {parameter.at_bound === true && <small>({said.atBound})</small>}
    </span>
  );
}
