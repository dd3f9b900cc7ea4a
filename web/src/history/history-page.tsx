import { signal } from '@preact/signals';
import { cells } from '../cells/cells';
import { Press } from '../ui/press';
import { go, route } from '../ui/route';
import type { Screen } from '../ui/screen';
import { Select } from '../ui/select';
import { words } from '../words';
import { comparison } from './comparison-page';
import { DriftPlot } from './drift-plot';
import { type Followed, PARAMETERS } from './followed-parameters';
import {
  historyCell,
  historyTool,
  historyTools,
  mayHaveEarlier,
  pair,
  past,
  pickCell,
  pickTool,
  showEarlier,
} from './history';
import { RunList } from './run-list';

const followed = signal<Followed>('mass');

function History() {
  const said = words.value.history;
  const runs = past.value ?? [];
  return (
    <div class="page history">
      <h1>{said.title}</h1>
      <Filters />
      <DriftPlot runs={runs} followed={followed.value} />
      <section>
        {past.value?.length === 0 ? <p>{said.none}</p> : <RunList runs={runs} />}
        {mayHaveEarlier.value && <Press act={showEarlier}>{said.earlier}</Press>}
      </section>
    </div>
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
        options={[['', said.allTools], ...historyTools.value]}
        chosen={historyTool.value}
        choose={pickTool}
      />
      <Select
        label={said.shown}
        options={Object.entries(said.parameters)}
        chosen={followed.value}
        choose={(value) => {
          if (value in PARAMETERS) followed.value = value as Followed;
        }}
      />
    </section>
  );
}

function Actions() {
  const [one, other] = pair.value;
  return (
    <Press
      kind="primary"
      disabled={one === undefined || other === undefined}
      act={() => go('history', ...pair.value)}
    >
      {words.value.history.compare}
    </Press>
  );
}

function next(): string {
  const said = words.value.history;
  return [said.next, said.nextOne, said.nextTwo][pair.value.length] ?? said.next;
}

const history: Screen = { Page: History, Actions, next };

/** All runs, or two of them where the address names two. */
export function historyScreen(): Screen {
  return route.value.length > 2 ? comparison : history;
}
