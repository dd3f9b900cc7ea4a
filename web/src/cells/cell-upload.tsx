import { useSignal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import type { Flaw } from '../api';
import { FlawList } from '../ui/flaw-list';
import { messageOf, type Notice, noticeOf } from '../ui/notice';
import { Press } from '../ui/press';
import { Refusal } from '../ui/refusal';
import { Told } from '../ui/told';
import { words } from '../words';
import { cells } from './cells';
import { checkCell, takeCellIn } from './shown-cell';

interface Checked {
  file: File;
  /** The cell's name, where it can be used. */
  name?: string;
  /** Why it cannot be used. */
  flaws?: Flaw[];
  /** Why it could not be checked. */
  unchecked?: Notice;
  taken?: boolean;
}

/** A zip of a cell is checked as soon as it is chosen, and taken in when somebody says so. */
export function CellUpload() {
  const said = words.value.cells;
  const input = useRef<HTMLInputElement>(null);
  const checked = useSignal<Checked | null>(null);
  const check = async (file: File | undefined) => {
    if (file === undefined) return;
    checked.value = { file };
    checked.value = await judged(file);
  };
  return (
    <section class="cell-upload">
      <h2>{said.upload}</h2>
      <p class="hint">{said.uploadHint}</p>
      <input
        type="file"
        accept=".zip,application/zip"
        hidden
        ref={input}
        onChange={({ currentTarget }) => {
          void check(currentTarget.files?.[0]);
          currentTarget.value = '';
        }}
      />
      <Press act={() => input.current?.click()}>{said.choose}</Press>
      {checked.value && (
        <Judgement
          checked={checked.value}
          taken={(done) => {
            checked.value = done;
          }}
        />
      )}
    </section>
  );
}

async function judged(file: File): Promise<Checked> {
  try {
    return { file, name: await checkCell(file) };
  } catch (error) {
    const flaws = error instanceof Refusal ? (error.problem.flaws ?? []) : [];
    return flaws.length > 0 ? { file, flaws } : { file, unchecked: noticeOf(error) };
  }
}

function Judgement({ checked, taken }: { checked: Checked; taken: (done: Checked) => void }) {
  const said = words.value.cells;
  const { file, name, flaws, unchecked } = checked;
  if (flaws) return <FlawList title={said.flawed(file.name)} flaws={flaws} />;
  if (unchecked) return <Unchecked why={unchecked} />;
  if (name === undefined) return <p role="status">{said.checking(file.name)}</p>;
  if (checked.taken) return <p role="status">{said.taken(name)}</p>;
  const replaces = (cells.value ?? []).some((each) => each.name === name);
  return (
    <>
      <p role="status">✓ {said.sound(name)}</p>
      <Press
        act={async () => {
          await takeCellIn(file, name, replaces);
          taken({ ...checked, taken: true });
        }}
      >
        {replaces ? said.replace(name) : said.add}
      </Press>
    </>
  );
}

function Unchecked({ why }: { why: Notice }) {
  return (
    <div class="abnormal" role="alert">
      <span aria-hidden="true">▲</span> <Told message={messageOf(why)} />
    </div>
  );
}
