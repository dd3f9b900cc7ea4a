import { useSignal } from '@preact/signals';
import type { PayloadPublic } from '../api';
import { placeOf, sizeOf } from '../cells/shapes';
import { tool as chosenTool } from '../run/order';
import { may } from '../session/session';
import { AskFirst } from '../ui/ask-first';
import { ask } from '../ui/client';
import { type Fact, Facts } from '../ui/facts';
import { Measured } from '../ui/measured';
import { MessageText } from '../ui/message-text';
import { nameOf } from '../ui/names';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { go, to } from '../ui/route';
import { moment, number, scaled, scaleOf, spelt } from '../ui/units';
import { bolted } from './bolted';
import { isUnexpected, massRange, readLibrary } from './library';
import { ToolForm } from './tool-form';
import { ToolPicture } from './tool-picture';
import { toolWords } from './tool-words';

/** A tool: how it looks, what is known and what runs have found of it; used by one tap. */
export function ToolTile({ tool }: { tool: PayloadPublic }) {
  const said = toolWords.value;
  const editing = useSignal(false);
  if (editing.value)
    return (
      <li class="wide">
        <ToolForm
          tool={tool}
          done={(saved) => {
            editing.value = false;
            if (saved) say(() => toolWords.value.saved(saved.title), 'passes');
          }}
        />
      </li>
    );
  return (
    <li class="tile tool-tile">
      <ToolPicture box={tool.box} com_m={comOf(tool)} bolted={bolted.value} />
      <div class="stack">
        <h2>{tool.title}</h2>
        <p class="hint">
          {said.forOrders(tool.name)}
          {tool.id === null && ` · ${said.ofFile}`}
        </p>
        {tool.flaw && (
          <p class="abnormal" role="alert">
            <span aria-hidden="true">▲</span> {said.unusable}: <MessageText message={tool.flaw} />
          </p>
        )}
        <Facts facts={factsOf(tool)} />
        {tool.note && <p class="note">{tool.note}</p>}
        <Origin tool={tool} />
      </div>
      <Acts
        tool={tool}
        edit={() => {
          editing.value = true;
        }}
      />
    </li>
  );
}

function Acts({ tool, edit }: { tool: PayloadPublic; edit: () => void }) {
  const said = toolWords.value;
  const { title, cell, id, last_accepted: last } = tool;
  return (
    <div class="row">
      {tool.flaw === null && may('operator') && (
        <Press
          act={() => {
            chosenTool.value = tool.name;
            go();
          }}
        >
          {said.use}
        </Press>
      )}
      {last && (
        <a class="download" href={to('runs', last.run)}>
          {said.result}
        </a>
      )}
      {tool.runs > 0 && (
        <a class="download" href={`${to('history')}?${historyOf(tool)}`}>
          {said.history}: {said.runs(tool.runs)}
        </a>
      )}
      {id !== null && may('engineer') && (
        <>
          <Press act={edit}>{said.edit}</Press>
          <AskFirst
            label={said.remove}
            question={said.removeAsk(title)}
            yes={said.removeYes}
            act={async () => {
              await ask('DELETE /api/cells/{cell}/payloads/{saved}', { path: { cell, saved: id } });
              say(() => toolWords.value.removed(title), 'passes');
              await readLibrary();
            }}
          />
        </>
      )}
    </div>
  );
}

function historyOf({ cell, id, name }: PayloadPublic): string {
  const named = id === null ? { tool: name } : { saved: id };
  return new URLSearchParams({ cell, ...named }).toString();
}

function Origin({ tool }: { tool: PayloadPublic }) {
  const said = toolWords.value;
  const { saved_by, saved_at, changed_by, changed_at } = tool;
  if (!saved_by || !saved_at) return null;
  return (
    <p class="hint">
      {said.savedBy(nameOf(saved_by), moment(saved_at))}
      {changed_by && changed_at && `; ${said.changedBy(nameOf(changed_by), moment(changed_at))}`}
    </p>
  );
}

/** The centre of mass as it was found last, else as it is known. */
function comOf({ last_accepted, reference }: PayloadPublic): (number | null)[] | null {
  if (last_accepted && !last_accepted.com_m.includes(null)) return last_accepted.com_m;
  return reference?.first_moment_kg_m.map((value) => value / reference.mass_kg) ?? null;
}

function factsOf(tool: PayloadPublic): Fact[] {
  const said = toolWords.value;
  const { box, reference, last_accepted: last } = tool;
  const expected = massRange(tool);
  const unexpected = last?.mass_kg != null && isUnexpected(tool, last.mass_kg);
  return [
    { name: said.box, value: sizeOf(box), note: said.boxCentre(placeOf(box)) },
    ...(reference
      ? [{ name: said.reference, value: spelt('mass', reference.mass_kg), note: reference.source }]
      : []),
    ...(expected ? [{ name: said.expected, value: expected }] : []),
    {
      name: said.mass,
      value: last ? (
        <Measured quantity="mass" value={last.mass_kg} std={last.mass_std_kg} />
      ) : (
        <span class="hint">{said.noResult}</span>
      ),
      note: last && (
        <>
          {moment(last.accepted_at)}
          {unexpected && (
            <span class="abnormal">
              <span aria-hidden="true">▲</span> {said.unexpected}
            </span>
          )}
        </>
      ),
    },
    ...(last ? [{ name: said.com, value: threeOf(last.com_m, last.com_std_m) }] : []),
  ];
}

/** Along x, y, z, as far as the uncertainty reaches. */
function threeOf(values: (number | null)[], stds: (number | null)[]): string {
  const scale = scaleOf('length');
  const each = values.map((value, k) => (value === null ? '–' : scaled(scale, value, stds[k] ?? null).value));
  const half = Math.max(...stds.map((std) => (std === null ? 0 : 1.96 * scale.factor * std)));
  return `${each.join(' | ')}${half > 0 ? ` ± ${number(half, 1 - Math.floor(Math.log10(half)))}` : ''} ${scale.unit}`;
}
