import { useSignal } from '@preact/signals';
import { Press } from '../ui/press';
import { Select } from '../ui/select';
import { number } from '../ui/units';
import { words } from '../words';
import { ArmAlone } from './arm-alone';
import { importWords } from './import-words';
import {
  cellNames,
  chooseCell,
  log,
  madeIn,
  reading,
  removeFile,
  sendFiles,
  sending,
  working,
} from './imports';

const ACCEPTED = '.csv,.gz,.txt,.parquet,.mcap,.bag,.db3,.zip,.toml,.urdf';
const KILOBYTE = 1e3;
const MEGABYTE = 1e6;

/** The files of a log: dropped or chosen, what was sent, how far that is. */
export function FileChoice() {
  const said = importWords.value;
  const over = useSignal(false);
  const drop = (event: DragEvent) => {
    event.preventDefault();
    over.value = false;
    void sendFiles([...(event.dataTransfer?.files ?? [])]);
  };
  return (
    <section class="stack">
      <h2>{said.files}</h2>
      {/* biome-ignore lint/a11y/noStaticElementInteractions: the button in it does the same without dragging */}
      <div
        class={over.value ? 'drop-place over' : 'drop-place'}
        onDragOver={(event) => {
          event.preventDefault();
          over.value = true;
        }}
        onDragLeave={() => {
          over.value = false;
        }}
        onDrop={drop}
      >
        <span class="drop-word">{said.drop}</span>
        <ChooseButton />
      </div>
      <p class="hint">{said.hint}</p>
      <Sent />
      <Progress />
      <Select
        label={words.value.gap.madeIn}
        options={[
          ['', words.value.gap.elsewhere],
          ...cellNames.value.map((each): [string, string] => [each, each]),
        ]}
        chosen={madeIn.value}
        choose={(cell) => void chooseCell(cell)}
      />
      <ArmAlone />
    </section>
  );
}

function ChooseButton() {
  const said = importWords.value;
  return (
    <span class="file-choice">
      <label class="download">
        {log.value ? said.more : said.choose}
        <input
          type="file"
          multiple
          disabled={working.value}
          aria-label={said.choose}
          accept={ACCEPTED}
          onChange={({ currentTarget }) => {
            const files = [...(currentTarget.files ?? [])];
            currentTarget.value = '';
            void sendFiles(files);
          }}
        />
      </label>
    </span>
  );
}

function Sent() {
  const said = importWords.value;
  const files = log.value?.files ?? [];
  if (files.length === 0) return null;
  return (
    <ul class="rows sent-files">
      {files.map(({ file, kind, size_bytes }) => (
        <li key={file}>
          <span>
            <b>{file}</b>
            <small>
              {said.kinds[kind]} · {sizeOf(size_bytes)}
            </small>
          </span>
          <Press disabled={working.value} act={() => removeFile(file)}>
            <span aria-hidden="true">{said.remove}</span>
            <span class="out-of-sight">{said.removeFile(file)}</span>
          </Press>
        </li>
      ))}
    </ul>
  );
}

function sizeOf(bytes: number): string {
  return bytes < MEGABYTE ? `${number(bytes / KILOBYTE, 1)} kB` : `${number(bytes / MEGABYTE, 1)} MB`;
}

function Progress() {
  const said = importWords.value;
  const { share, text } = sending.value
    ? { share: sending.value.share, text: said.sending(sending.value.file) }
    : { share: reading.value, text: said.reading };
  if (share === null) return null;
  return (
    <div>
      <progress max={1} value={share} aria-label={text} />
      <p role="status">
        {text} … {number(100 * share, 0)} %
      </p>
    </div>
  );
}
