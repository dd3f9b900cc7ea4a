import type { ComponentChildren } from 'preact';
import type { Scatter } from '../api';
import { Measured } from '../ui/measured';
import { to } from '../ui/route';
import { INTERVAL, moment, number, percent, type Quantity, scaleOf } from '../ui/units';
import type { ReadSeries } from './series';
import { headingOf, quantityOf } from './series-rows';
import { seriesWords } from './series-words';

/** The runs by their numbers, each with its mass and a way to its result. */
export function RunsTable({ found, apart }: { found: ReadSeries; apart: number }) {
  const said = seriesWords.value;
  const mass = found.answer.series.parameters.find(({ name }) => name === 'm');
  return (
    <Pushed>
      <table class="series-table">
        <thead>
          <tr>
            <th scope="col">{said.number}</th>
            <th scope="col">{said.when}</th>
            <th scope="col">{headingOf('m')}</th>
            {found.conditions && <th scope="col">{said.condition}</th>}
          </tr>
        </thead>
        <tbody>
          {found.runs.map((run, k) => (
            <tr key={run.run}>
              <th scope="row">{k === apart ? `≠ ${k + 1}` : k + 1}</th>
              <td>
                <a class="series-run" href={to('runs', run.run)}>
                  {moment(run.ended_at ?? run.requested_at)}
                </a>
              </td>
              <td>
                <Measured quantity="mass" value={mass?.values[k] ?? null} std={mass?.stds[k] ?? null} />
              </td>
              {found.conditions && <td>{found.conditions[k]}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </Pushed>
  );
}

/** What the runs say together and how they scatter, one row a parameter. */
export function ScatterTable({ found }: { found: ReadSeries }) {
  const said = seriesWords.value;
  const { parameters } = found.answer.series;
  const of =
    (key: 'stated_std' | 'repeatability_std' | 'between_std' | 'reproducibility_std') => (row: Scatter) =>
      row[key];
  const columns: [string, (row: Scatter) => number | null][] = [
    [said.stated, of('stated_std')],
    [said.repeatability, of('repeatability_std')],
    ...(found.conditions
      ? ([
          [said.between, of('between_std')],
          [said.reproducibility, of('reproducibility_std')],
        ] as [string, (row: Scatter) => number | null][])
      : []),
    [said.unstated, unstated],
  ];
  return (
    <Pushed>
      <table class="series-table">
        <thead>
          <tr>
            <th scope="col">{said.quantity}</th>
            <th scope="col">{said.together}</th>
            {columns.map(([name]) => (
              <th scope="col" key={name}>
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {parameters.map((row) => (
            <tr key={row.name}>
              <th scope="row">{headingOf(row.name)}</th>
              <td>
                <Measured quantity={quantityOf(row)} value={row.mean} std={halfToStd(row.half_width)} />
              </td>
              {columns.map(([name, value]) => (
                <td key={name}>{size(quantityOf(row), value(row))}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </Pushed>
  );
}

/** Who has which share in what the runs say together. */
export function SharesTable({ found }: { found: ReadSeries }) {
  const said = seriesWords.value;
  const { runs, parameters, prior_used } = found.answer.series;
  return (
    <Pushed>
      <table class="series-table series-shares">
        <thead>
          <tr>
            <th scope="col">{said.quantity}</th>
            {prior_used && <th scope="col">{said.prior}</th>}
            {runs.map((run, k) => (
              <th scope="col" key={run}>
                {k + 1}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {parameters
            .filter(({ mean }) => mean !== null)
            .map((row) => (
              <tr key={row.name}>
                <th scope="row">{headingOf(row.name)}</th>
                {prior_used && <td>{percent(row.prior_weight)}</td>}
                {runs.map((run, k) => (
                  <td key={run}>{percent(row.weights[k] ?? 0)}</td>
                ))}
              </tr>
            ))}
        </tbody>
      </table>
    </Pushed>
  );
}

function Pushed({ children }: { children: ComponentChildren }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys
    <div class="scrolls" tabIndex={0}>
      {children}
    </div>
  );
}

/** Of the stated scatter. */
const NEGLIGIBLE = 0.01;

const halfToStd = (half: number | null) => (half === null ? null : half / INTERVAL);

/** What is beyond the stated scatter; what rounding leaves of none is none. */
const unstated = ({ unstated_std, stated_std }: Scatter) =>
  unstated_std > NEGLIGIBLE * (stated_std ?? 0) ? unstated_std : null;

/** A standard deviation to two digits, in the unit of its row. */
function size(quantity: Quantity, std: number | null): string {
  if (std === null) return '–';
  const value = scaleOf(quantity).factor * std;
  return number(value, value > 0 ? 1 - Math.floor(Math.log10(value)) : 0);
}
