import { useSignal } from '@preact/signals';
import { chosenCell } from '../cells/cells';
import { Choice } from '../ui/choice';
import { Reserved } from '../ui/reserved';
import { go } from '../ui/route';
import { words } from '../words';
import { diagnoseUpload } from './diagnoses';

const ELSEWHERE = '';

/** A recording of somebody's own, as a zip. */
export function RecordingUpload() {
  const said = words.value.gap;
  const file = useSignal<File | null>(null);
  const madeIn = useSignal(chosenCell.value);
  const begin = async () => {
    if (file.value !== null) go('gap', (await diagnoseUpload(file.value, madeIn.value || null)).diagnosis);
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
            }}
          />
        </label>
        <span role="status">{file.value?.name ?? said.noFile}</span>
      </p>
      <p class="hint">{said.uploadHint}</p>
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
