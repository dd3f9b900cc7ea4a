import { computed } from '@preact/signals';
import { cells } from '../cells/cells';
import { NothingYet } from '../ui/nothing-yet';
import { Press } from '../ui/press';
import { filters, go, route, setFilter, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { Select } from '../ui/select';
import { words } from '../words';
import { comparison } from './comparison-page';
import { DriftPlot } from './drift-plot';
import { type Followed, PARAMETERS } from './followed-parameters';
import {
  found,
  historyCell,
  historyTool,
  historyTools,
  isCutOff,
  mayHaveEarlier,
  pickCell,
  picked,
  pickTool,
  search,
  showEarlier,
} from './history';
import { RunList } from './run-list';

/** What is shown over time; the mass, where the address names nothing else. */
const followed = computed<Followed>(() => {
  const named = filters.value.get('shown') ?? '';
  return named in PARAMETERS ? (named as Followed) : 'mass';
});

function History() {
  const said = words.value.history;
  const runs = found.value ?? [];
  return (
    <div class="page history">
      <h1>{said.title}</h1>
      <Filters />
      {runs.length > 0 && (
        <DriftPlot runs={runs} followed={followed.value} of={[historyCell.value, toolName()]} />
      )}
      <section>
        {found.value?.length === 0 ? <Nothing /> : <RunList runs={runs} />}
        {search.value && isCutOff.value && <p class="hint">{said.cutOff}</p>}
        {mayHaveEarlier.value && <Press act={showEarlier}>{said.earlier}</Press>}
      </section>
    </div>
  );
}

function Nothing() {
  const said = words.value.history;
  if (historyTool.value && !search.value) {
    return (
      <NothingYet>
        {said.noneOfTool} <Press act={() => pickTool('')}>{said.allTools}</Press>
      </NothingYet>
    );
  }
  if (!search.value) {
    return (
      <NothingYet href={to()} act={words.value.setup.begin}>
        {said.none}
      </NothingYet>
    );
  }
  return (
    <p role="status">
      {said.noneFound(search.value)} <Press act={() => setFilter('search', '')}>{said.showAll}</Press>
    </p>
  );
}

function Filters() {
  const said = words.value.history;
  const names = (cells.value ?? []).map(({ name }) => name);
  return (
    <section class="filters">
      <Select
        label={said.cell}
        options={names.map((name) => [name, name])}
        chosen={historyCell.value}
        choose={pickCell}
      />
      <Select
        label={said.tool}
        options={[['', said.allTools], ...toolOptions()]}
        chosen={historyTool.value}
        choose={pickTool}
      />
      <Select
        label={said.shown}
        options={Object.entries(said.parameters)}
        chosen={followed.value}
        choose={(value) => {
          setFilter('shown', value === 'mass' ? '' : value);
        }}
      />
      <label class="field search">
        <span>{said.search}</span>
        <input
          type="search"
          value={search.value}
          placeholder={said.searchFor}
          onInput={({ currentTarget }) => setFilter('search', currentTarget.value)}
        />
      </label>
    </section>
  );
}

/** As orders call it, for names of files. */
function toolName(): string {
  return historyTool.value && (found.value?.[0]?.payload ?? historyTool.value);
}

/** One that was deleted since, or is not known yet, is shown as the address has it. */
function toolOptions(): [string, string][] {
  const known = historyTools.value.map(({ value, title }): [string, string] => [value, title]);
  const named = historyTool.value;
  const gone = named !== '' && !known.some(([value]) => value === named);
  return gone ? [...known, [named, found.value?.[0]?.payload ?? named]] : known;
}

function Actions() {
  const count = picked.value.length;
  const said = words.value.history;
  return (
    <>
      <Press disabled={count < 2} act={() => go('timeline', ...picked.value)}>
        {said.effects}
      </Press>
      <Press
        kind="primary"
        disabled={count < 2}
        act={() => go(count > 2 ? 'series' : 'history', ...picked.value)}
      >
        {said.compare}
      </Press>
    </>
  );
}

function next(): string {
  const said = words.value.history;
  const count = picked.value.length;
  return count > 2 ? said.nextMore(count) : ([said.next, said.nextOne, said.nextTwo][count] ?? said.next);
}

const history: Screen = { Page: History, Actions, next };

/** All runs, or two of them where the address names two. */
export function historyScreen(): Screen {
  return route.value.length > 2 ? comparison : history;
}
