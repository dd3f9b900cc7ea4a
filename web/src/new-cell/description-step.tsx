import { useRef } from 'preact/hooks';
import { Choice } from '../ui/choice';
import { Press } from '../ui/press';
import { TextField } from '../ui/text-field';
import { moment } from '../ui/units';
import { description, draft, fileName, sendFile, working } from './draft';
import { newCellWords } from './new-cell-words';

/** The robot's description is chosen, and which of its files describes it. */
export function DescriptionStep() {
  const said = newCellWords.value.description;
  const input = useRef<HTMLInputElement>(null);
  const sent = draft.value;
  return (
    <>
      <p class="hint">{said.hint}</p>
      <input
        type="file"
        accept=".zip,.urdf,.xacro,.xml"
        hidden
        ref={input}
        onChange={({ currentTarget }) => {
          const file = currentTarget.files?.[0];
          if (file) void sendFile(file);
          currentTarget.value = '';
        }}
      />
      <div class="row">
        <Press act={() => input.current?.click()}>{sent ? said.other : said.choose}</Press>
        {working.value ? (
          <span role="status">{said.reading(fileName.value)}</span>
        ) : (
          sent && <b>{fileName.value}</b>
        )}
      </div>
      {sent && (
        <>
          <Choice
            legend={said.which}
            options={sent.descriptions.map(({ file }) => ({
              value: file,
              label: file.replace(/^robot\//, ''),
            }))}
            chosen={description.value.file}
            choose={(file) => {
              description.value = { file, arguments: {} };
            }}
          />
          <Arguments />
          <p class="hint">{said.expires(moment(sent.expires_at))}</p>
        </>
      )}
    </>
  );
}

function Arguments() {
  const said = newCellWords.value.description;
  const chosen = draft.value?.descriptions.find(({ file }) => file === description.value.file);
  if (!chosen || chosen.arguments.length === 0) return null;
  return (
    <fieldset class="stack">
      <legend>{said.arguments}</legend>
      <p class="hint">{said.argumentsHint}</p>
      {chosen.arguments.map(({ name, default: usual }) => (
        <TextField
          key={name}
          label={usual ? `${name} (${usual})` : name}
          text={description.value.arguments[name] ?? ''}
          change={(text) => {
            const { file, arguments: all } = description.value;
            description.value = { file, arguments: { ...all, [name]: text } };
          }}
        />
      ))}
    </fieldset>
  );
}
