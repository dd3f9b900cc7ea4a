import { useSignal } from '@preact/signals';
import type { PayloadPublic } from '../api';
import { Choice } from '../ui/choice';
import { spelt } from '../ui/units';
import { words } from '../words';
import { containsWords, expectedMass, library } from './library';
import { ToolThumbnail } from './tool-thumbnail';

/** More than these are searched. */
const FEW = 6;

interface Props {
  chosen: string;
  choose: (name: string) => void;
}

/** One of the tools that the cell knows and can use, each with its picture. */
export function ToolChoice({ chosen, choose }: Props) {
  const said = words.value.setup;
  const search = useSignal('');
  const usable = (library.value ?? []).filter(({ flaw }) => flaw === null);
  const many = usable.length > FEW;
  const found = usable.filter((tool) => tool.name === chosen || !many || containsWords(tool, search.value));
  return (
    <>
      {many && (
        <label class="field search">
          <span>{said.searchTools}</span>
          <input
            type="search"
            value={search.value}
            onInput={({ currentTarget }) => {
              search.value = currentTarget.value;
            }}
          />
        </label>
      )}
      <div class={many ? 'tool-choice tool-choice-many' : 'tool-choice'}>
        <Choice legend={said.tool} options={found.map(optionOf)} chosen={chosen} choose={choose} />
      </div>
      {many && search.value && found.every(({ name }) => name === chosen) && (
        <p class="hint" role="status">
          {said.noTool(search.value)}
        </p>
      )}
    </>
  );
}

function optionOf(tool: PayloadPublic) {
  const mass_kg = expectedMass(tool);
  const last = tool.last_accepted?.mass_kg;
  const notes = [
    tool.name,
    ...(mass_kg === null ? [] : [spelt('mass', mass_kg)]),
    ...(last == null ? [] : [words.value.setup.lastFound(spelt('mass', last))]),
  ];
  return {
    value: tool.name,
    label: (
      <>
        <ToolThumbnail box={tool.box} /> {tool.title}
      </>
    ),
    note: notes.join(' · '),
  };
}
