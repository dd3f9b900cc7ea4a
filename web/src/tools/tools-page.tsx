import '../look/tools.css';
import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { cells, chosenCell } from '../cells/cells';
import { may } from '../session/session';
import { until } from '../ui/connection';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { filters, setFilter } from '../ui/route';
import type { Screen } from '../ui/screen';
import { Select } from '../ui/select';
import { containsWords, library, readLibrary } from './library';
import { ToolForm } from './tool-form';
import { ToolTile } from './tool-tile';
import { toolWords } from './tool-words';

const search = () => filters.value.get('search') ?? '';

/** The tools of a cell, each with its picture and what runs have found of it. */
function Tools() {
  const said = toolWords.value;
  const all = library.value;
  useEffect(() => until(readLibrary), []);
  if (all === null) return <Reading />;
  const found = all.filter((tool) => containsWords(tool, search()));
  return (
    <div class="page tools">
      <h1>{said.title}</h1>
      <Filters />
      <NewTool />
      {all.length === 0 && <p>{said.none}</p>}
      {all.length > 0 && found.length === 0 && (
        <p role="status">
          {said.noneFound(search())} <Press act={() => setFilter('search', '')}>{said.showAll}</Press>
        </p>
      )}
      <ul class="tool-tiles">
        {found.map((tool) => (
          <ToolTile key={tool.id ?? tool.name} tool={tool} />
        ))}
      </ul>
    </div>
  );
}

function Filters() {
  const said = toolWords.value;
  return (
    <section class="filters">
      <Select
        label={said.cell}
        options={(cells.value ?? []).map(({ name }) => [name, name])}
        chosen={chosenCell.value}
        choose={(name) => {
          chosenCell.value = name;
        }}
      />
      <label class="field search">
        <span>{said.search}</span>
        <input
          type="search"
          value={search()}
          placeholder={said.searchFor}
          onInput={({ currentTarget }) => setFilter('search', currentTarget.value)}
        />
      </label>
    </section>
  );
}

function NewTool() {
  const said = toolWords.value;
  const adding = useSignal(false);
  if (!may('operator', 'engineer')) return null;
  if (!adding.value)
    return (
      <div>
        <Press
          act={() => {
            adding.value = true;
          }}
        >
          {said.add}
        </Press>
      </div>
    );
  return (
    <ToolForm
      begin={{ cell: chosenCell.value }}
      done={(tool) => {
        adding.value = false;
        if (tool) say(() => toolWords.value.saved(tool.title), 'passes');
      }}
    />
  );
}

const tools: Screen = { Page: Tools, next: () => toolWords.value.next };

export const toolsScreen = (): Screen => tools;
