import { useSignal } from '@preact/signals';
import { chosenCell } from '../cells/cells';
import { Choice } from '../ui/choice';
import { Reserved } from '../ui/reserved';
import { go } from '../ui/route';
import { words } from '../words';
import { diagnoseUpload } from './diagnoses';

const ELSEWHERE = '';
/** Of a name. */
const MOST_LETTERS = 120;

/** A recording of somebody's own, as a zip. */
export function RecordingUpload() {
  const said = words.value.gap;
  const file = useSignal<File | null>(null);
  const name = useSignal('');
  const madeIn = useSignal(chosenCell.value);
  const begin = async () => {
    if (file.value === null) return;
    go('gap', (await diagnoseUpload(file.value, madeIn.value || null, name.value.trim() || null)).diagnosis);
  };
  return (
    <section class="recording-upload">
      <h2>{said.ofUpload}</h2>
      <p class="file-choice">
        <label class="download">
          {said.chooseFile}
          <input
            type="file"
            aria-label={said.file}
            accept=".zip,application/zip"
            onChange={({ currentTarget }) => {
              file.value = currentTarget.files?.[0] ?? null;
              name.value = file.value?.name.replace(/\.zip$/i, '').slice(0, MOST_LETTERS) ?? '';
            }}
          />
        </label>
        <span role="status">{file.value?.name ?? said.noFile}</span>
      </p>
      <p class="hint">{said.uploadHint}</p>
      <label class="field">
        <span>{said.uploadName}</span>
        <input
          type="text"
          maxLength={MOST_LETTERS}
          value={name.value}
          onInput={({ currentTarget }) => {
            name.value = currentTarget.value;
          }}
        />
      </label>
      <Choice
        legend={said.madeIn}
        options={[
          { value: chosenCell.value, label: chosenCell.value },
          { value: ELSEWHERE, label: said.elsewhere, note: said.elsewhereHint },
        ]}
        chosen={madeIn.value}
        choose={(value) => {
          madeIn.value = value;
        }}
      />
      <Reserved roles={['engineer', 'operator']} disabled={file.value === null} act={begin}>
        {said.diagnose}
      </Reserved>
    </section>
  );
}
