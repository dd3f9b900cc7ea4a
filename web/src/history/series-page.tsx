import '../look/series.css';
import type { Message } from '../api';
import { MessageText } from '../ui/message-text';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { go, setFilter, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { Select } from '../ui/select';
import { moment, number, percent } from '../ui/units';
import { words } from '../words';
import { condition, PRIORS, prior, type ReadSeries, shown } from './series';
import { pairsApart, verdictOf } from './series-rows';
import { RunsTable, ScatterTable, SharesTable } from './series-tables';
import { seriesWords } from './series-words';
import { SpreadPlot } from './spread-plot';

function SeriesPage() {
  const said = seriesWords.value;
  const found = shown.value;
  if (found === null) return <Reading />;
  const { series } = found.answer;
  const apart = series.apart ? series.runs.indexOf(series.apart.run) : -1;
  return (
    <div class="page series">
      <h1>{said.title}</h1>
      <Verdict found={found} />
      <Choices />
      <section class="spreads">
        <h2>{said.drawn}</h2>
        <p class="hint">{said.howDrawn}</p>
        <div class="spread-list">
          {series.parameters.map((row) => (
            <SpreadPlot key={row.name} row={row} apart={apart} />
          ))}
        </div>
      </section>
      <section>
        <h2>{said.runs}</h2>
        <RunsTable found={found} apart={apart} />
      </section>
      <section>
        <h2>{said.numbers}</h2>
        <p class="hint">{said.standard}</p>
        <ScatterTable found={found} />
      </section>
      <section>
        <h2>{said.shares}</h2>
        <SharesTable found={found} />
      </section>
    </div>
  );
}

function Verdict({ found }: { found: ReadSeries }) {
  const said = seriesWords.value;
  const { frame, series } = found.answer;
  const { agree, headline } = verdictOf(found);
  const pairs = pairsApart(found);
  const odd = found.runs.find(({ run }) => run === series.apart?.run);
  return (
    <section class="verdict">
      <p class="verdict-words">{`${agree ? '=' : '≠'} ${headline}`}</p>
      {series.apart && <p>{said.othersAgree}</p>}
      {odd !== undefined && (
        <p class="downloads">
          <a class="download" href={to('runs', odd.run)}>
            {words.value.comparison.first(moment(odd.ended_at ?? odd.requested_at))}
          </a>
        </p>
      )}
      {pairs !== null && <p>{pairs}</p>}
      <p>
        {series.chance === null
          ? words.value.comparison.nothingInCommon
          : said.chance(percent(series.chance))}
      </p>
      {series.prior_used && <p>{said.priorUsed(series.prior ?? said.reference)}</p>}
      {series.remarks.filter(isNews).map((remark) => (
        <p key={remark.code} class="remark">
          <MessageText message={remark} />
        </p>
      ))}
      <p class="hint">{frame === 'flange' ? said.flange : said.sensor}</p>
    </section>
  );
}

/** That all count as made under one condition stands in the field below. */
const isNews = ({ code }: Message) => code !== 'payload-one-condition';

function Choices() {
  const said = seriesWords.value;
  return (
    <section class="filters">
      <Select
        label={said.conditions}
        options={[
          ['', said.alike],
          ['day', said.byDay],
          ['cell', said.byCell],
          ['person', said.byPerson],
        ]}
        chosen={condition.value ?? ''}
        choose={(name) => setFilter('conditions', name)}
      />
      <Select
        label={said.known}
        options={[['', said.notUsed], ...PRIORS.map((each): [string, string] => [each, spelledShare(each)])]}
        chosen={prior.value}
        choose={(share) => setFilter('prior', share)}
      />
    </section>
  );
}

const spelledShare = (share: string) => seriesWords.value.percent(`± ${number(Number(share), 0)} %`);

function Actions() {
  return (
    <Press kind="primary" act={() => go('history')}>
      {seriesWords.value.back}
    </Press>
  );
}

const screen: Screen = { Page: SeriesPage, Actions, next: () => seriesWords.value.next };

export const seriesScreen = () => screen;
