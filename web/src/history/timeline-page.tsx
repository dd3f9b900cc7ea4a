import '../look/series.css';
import type { EffectTimeline, Sighting } from '../api';
import { DiagnoseRun } from '../gap/diagnose-run';
import { effectName, type Parameter, parameterShown, parameterTitle } from '../gap/effect-values';
import { MessageText } from '../ui/message-text';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { go, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { moment } from '../ui/units';
import { add, type ReadTimeline, shown, timelineWords } from './timeline';

function TimelinePage() {
  const said = timelineWords.value;
  const found = shown.value;
  if (found === null) return <Reading />;
  const { recordings, timeline } = found.answer;
  return (
    <div class="page series">
      <h1>{said.title}</h1>
      <section class="verdict">
        {recordings.length < 2 ? (
          <p>{said.tooFew}</p>
        ) : (
          timeline.summary.map((message, k) => (
            <p class="verdict-words" key={k}>
              <MessageText message={message} />
            </p>
          ))
        )}
      </section>
      {recordings.length > 0 && <EachRecording found={found} />}
      <Missing found={found} />
      <More found={found} />
    </div>
  );
}

/** A row for each effect with what stands out most of it, a column for each recording. */
function EachRecording({ found }: { found: ReadTimeline }) {
  const said = timelineWords.value;
  const { recordings, timeline } = found.answer;
  return (
    <section>
      <h2>{said.each}</h2>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys */}
      <div class="scrolls" tabIndex={0}>
        <table class="series-table">
          <thead>
            <tr>
              <th scope="col">{said.effect}</th>
              {recordings.map(({ run, name, diagnosis, requested_at }, k) => (
                <th scope="col" key={diagnosis}>
                  {k + 1}{' '}
                  <a class="series-run" href={to('gap', diagnosis)}>
                    {run === null ? (name ?? moment(requested_at)) : whenOf(found, run)}
                  </a>
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {timeline.effects.map((effect) => (
              <Row key={effect.id} effect={effect} />
            ))}
          </tbody>
        </table>
      </div>
      <p class="hint">{timeline.effects.length === 0 ? said.none : said.interval}</p>
    </section>
  );
}

function Row({ effect }: { effect: EffectTimeline }) {
  const said = timelineWords.value;
  const [name, parameter] = leadingParameter(effect) ?? [null, null];
  return (
    <tr>
      <th scope="row">
        {effectName(effect.id)}
        {parameter !== null && <small> {parameterTitle(name, parameter)}</small>}
      </th>
      {effect.sightings.map((sighting, k) => (
        <td key={k}>
          <span>{said.states[sighting.state]}</span>
          <Size name={name} sighting={sighting} />
        </td>
      ))}
    </tr>
  );
}

function Size({ name, sighting }: { name: string | null; sighting: Sighting }) {
  const parameter = name === null || sighting.state === 'absent' ? undefined : sighting.parameters[name];
  if (name === null || parameter === undefined) return null;
  const { value, half, unit } = parameterShown(name, parameter);
  return (
    <span class="measured">
      {' '}
      <b>{value}</b>
      {half !== null && <i>± {half}</i>}
      <small>{unit}</small>
    </span>
  );
}

/** That which stands out most from its uncertainty in any run that shows the effect; null where nothing was fitted. */
function leadingParameter({ sightings }: EffectTimeline): [string, Parameter] | null {
  const all = sightings
    .filter(({ state }) => state !== 'absent')
    .flatMap(({ parameters }) => Object.entries(parameters))
    .toSorted(([, one], [, other]) => clearness(other) - clearness(one));
  return all[0] ?? null;
}

function clearness({ value, std }: Parameter): number {
  return std ? Math.abs(value) / std : 0;
}

function Missing({ found }: { found: ReadTimeline }) {
  const said = timelineWords.value;
  const undiagnosed = found.answer.undiagnosed.filter((name) => found.runs.has(name));
  if (undiagnosed.length === 0) return null;
  return (
    <section>
      <h2>{said.missing}</h2>
      <ul class="rows">
        {undiagnosed.map((run) => (
          <li key={run}>
            <b>{whenOf(found, run)}</b>
            <DiagnoseRun run={run} label={said.diagnose} />
          </li>
        ))}
      </ul>
    </section>
  );
}

/** Uploaded recordings that could stand among them. */
function More({ found }: { found: ReadTimeline }) {
  const said = timelineWords.value;
  if (found.more.length === 0) return null;
  return (
    <section>
      <h2>{said.uploads}</h2>
      <p class="hint">{said.uploadsHint}</p>
      <ul class="rows">
        {found.more.map((each) => (
          <li key={each.diagnosis}>
            <span>
              <b>{each.name ?? moment(each.requested_at)}</b>
              <small>{[each.cell, each.tool, moment(each.requested_at)].filter(Boolean).join(' · ')}</small>
            </span>
            <Press act={() => add(each)}>{said.add}</Press>
          </li>
        ))}
      </ul>
    </section>
  );
}

function whenOf({ runs }: ReadTimeline, name: string): string {
  const run = runs.get(name);
  return run === undefined ? name : moment(run.ended_at ?? run.requested_at);
}

function Actions() {
  return (
    <Press kind="primary" act={() => go('history')}>
      {timelineWords.value.back}
    </Press>
  );
}

const screen: Screen = { Page: TimelinePage, Actions, next: () => timelineWords.value.next };

export const timelineScreen = () => screen;
