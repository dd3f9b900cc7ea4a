import '../look/tools.css';
import { useSignal } from '@preact/signals';
import type { PayloadPublic } from '../api';
import { ActWhen } from '../ui/act-when';
import { ask } from '../ui/client';
import { NumberField } from '../ui/number-field';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { scaleOf, spelt } from '../ui/units';
import { words } from '../words';
import { library, readLibrary } from './library';
import {
  beginDraft,
  boxOfDraft,
  draftOf,
  isName,
  nameOfDraft,
  rangeOfDraft,
  type Three,
  type ToolBeginning,
  type ToolDraft,
} from './tool-draft';
import { ToolPicture } from './tool-picture';
import { toolWords } from './tool-words';

interface Props {
  /** What a new tool begins with. */
  begin?: ToolBeginning;
  /** The tool that is changed; absent for a new one. */
  tool?: PayloadPublic;
  /** It was saved, or null where nobody wants to any more. */
  done: (saved: PayloadPublic | null) => void;
}

/** A tool for the library, drawn while it is typed. */
export function ToolForm({ begin, tool, done }: Props) {
  const said = toolWords.value.form;
  const draft = useSignal<ToolDraft>(tool ? draftOf(tool) : beginDraft(begin ?? {}));
  const keeps = useSignal(true);
  const change = (part: Partial<ToolDraft>) => {
    draft.value = { ...draft.value, ...part };
  };
  const box = boxOfDraft(draft.value);
  const save = async () => {
    const saved = await (tool
      ? changeTool(tool, draft.value, keeps.value)
      : saveTool(begin?.cell ?? '', draft.value, begin?.run?.id ?? null));
    await readLibrary();
    done(saved);
  };
  return (
    <section class="tool-form tile">
      <h2>{tool ? said.editTitle(tool.title) : said.newTitle}</h2>
      {begin?.run && <p class="hint">{begin.run.whole ? said.ofRun : said.ofRunPartly}</p>}
      <div class="tool-form-parts">
        <div class="stack">
          <Names draft={draft.value} tool={tool} change={change} />
          <Shape draft={draft.value} change={change} />
          <Expected draft={draft.value} change={change} />
          {tool?.reference && (
            <label class="keep-reference">
              <input
                type="checkbox"
                checked={keeps.value}
                onChange={({ currentTarget }) => {
                  keeps.value = currentTarget.checked;
                }}
              />
              <span>
                {said.keep(spelt('mass', tool.reference.mass_kg), tool.reference.source)}
                <small>{said.keepHint}</small>
              </span>
            </label>
          )}
          <TextField
            label={said.note}
            hint={said.noteHint}
            text={draft.value.note}
            change={(note) => change({ note })}
          />
        </div>
        {box && <ToolPicture box={box} />}
      </div>
      <div class="row">
        <ActWhen lacking={lackOf(draft.value, tool)} act={save}>
          {said.save}
        </ActWhen>
        <Press act={() => done(null)}>{words.value.cancel}</Press>
      </div>
    </section>
  );
}

interface PartProps {
  draft: ToolDraft;
  change: (part: Partial<ToolDraft>) => void;
}

function Names({ draft, tool, change }: PartProps & { tool: PayloadPublic | undefined }) {
  const said = toolWords.value.form;
  const name = nameOfDraft(draft);
  const flaw = name === '' || isName(name) ? (isTaken(name, tool) ? said.taken : null) : said.badName;
  return (
    <>
      <TextField label={said.title} text={draft.title} change={(title) => change({ title })} />
      <TextField
        label={said.name}
        hint={said.nameHint}
        flaw={flaw}
        text={name}
        change={(text) => change({ name: text })}
      />
    </>
  );
}

function Shape({ draft, change }: PartProps) {
  const said = toolWords.value.form;
  const { unit } = scaleOf('length');
  const isOpen = draft.turn.some((text) => text !== '0');
  return (
    <>
      <Triple legend={said.size(unit)} texts={draft.size} change={(size) => change({ size })} />
      <Triple
        legend={said.centre(unit)}
        signed
        texts={draft.centre}
        change={(centre) => change({ centre })}
      />
      <details class="others" open={isOpen}>
        <summary>{said.turn}</summary>
        <Triple
          legend={said.turn}
          hidden
          signed
          names={['roll', 'pitch', 'yaw']}
          texts={draft.turn}
          change={(turn) => change({ turn })}
        />
      </details>
      {boxOfDraft(draft) === null && draft.size.some((text) => text !== '') && (
        <p class="hint flaw">{said.badNumbers}</p>
      )}
    </>
  );
}

interface TripleProps {
  legend: string;
  hidden?: boolean;
  signed?: boolean;
  names?: Three;
  texts: Three;
  change: (texts: Three) => void;
}

function Triple({
  legend,
  hidden = false,
  signed = false,
  names = ['x', 'y', 'z'],
  texts,
  change,
}: TripleProps) {
  return (
    <fieldset>
      <legend class={hidden ? 'out-of-sight' : ''}>{legend}</legend>
      <div class="three">
        {names.map((name, k) => (
          <NumberField
            key={name}
            label={name}
            signed={signed}
            text={texts[k] ?? ''}
            flaw={false}
            change={(text) => change(texts.with(k, text) as Three)}
          />
        ))}
      </div>
    </fieldset>
  );
}

function Expected({ draft, change }: PartProps) {
  const said = toolWords.value.form;
  const bad = rangeOfDraft(draft) === null;
  return (
    <fieldset>
      <legend>{said.range(scaleOf('mass').unit)}</legend>
      <div class="two">
        <NumberField label={said.least} text={draft.least} flaw={bad} change={(least) => change({ least })} />
        <NumberField label={said.most} text={draft.most} flaw={bad} change={(most) => change({ most })} />
      </div>
      <p class={bad ? 'hint flaw' : 'hint'}>{bad ? said.badRange : said.rangeHint}</p>
    </fieldset>
  );
}

function isTaken(name: string, tool: PayloadPublic | undefined): boolean {
  const others = (library.value ?? []).filter(({ id }) => id === null || id !== tool?.id);
  return others.some((each) => each.name.toLowerCase() === name.toLowerCase());
}

/** What keeps the form from being saved; null where nothing does. */
function lackOf(draft: ToolDraft, tool: PayloadPublic | undefined): string | null {
  const said = toolWords.value.form;
  const name = nameOfDraft(draft);
  if (draft.title.trim() === '') return said.lackTitle;
  if (!isName(name)) return said.badName;
  if (isTaken(name, tool)) return said.taken;
  if (boxOfDraft(draft) === null) return said.badNumbers;
  return rangeOfDraft(draft) === null ? said.badRange : null;
}

function bodyOf(draft: ToolDraft) {
  const [mass_least_kg = null, mass_most_kg = null] = rangeOfDraft(draft) ?? [];
  const { title, note } = draft;
  return {
    name: nameOfDraft(draft),
    title: title.trim(),
    box: boxOfDraft(draft),
    note: note.trim() || null,
    mass_least_kg,
    mass_most_kg,
  };
}

async function saveTool(cell: string, draft: ToolDraft, run: string | null): Promise<PayloadPublic> {
  const path = { cell };
  return ask('POST /api/cells/{cell}/payloads', { path, body: { ...bodyOf(draft), run } });
}

async function changeTool({ cell, id }: PayloadPublic, draft: ToolDraft, keeps: boolean) {
  const path = { cell, saved: id ?? '' };
  const body = { ...bodyOf(draft), ...(keeps ? {} : { reference: null }) };
  return ask('PATCH /api/cells/{cell}/payloads/{saved}', { path, body });
}
