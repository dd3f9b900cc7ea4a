import { signal, useSignal } from '@preact/signals';
import type { FunctionComponent } from 'preact';
import type { PayloadPublic } from '../api';
import { may } from '../session/session';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { words } from '../words';
import type { ToolBeginning } from './tool-draft';

interface FormProps {
  begin: ToolBeginning;
  done: (saved: PayloadPublic | null) => void;
}

/** The form comes when somebody wants to save something. */
const form = signal<FunctionComponent<FormProps> | null>(null);

interface Props {
  label: string;
  begin: () => ToolBeginning;
  saved?: (tool: PayloadPublic) => void;
}

/** A button that saves what is on the page in the tool library, for whoever may. */
export function SaveTool({ label, begin, saved }: Props) {
  const beginning = useSignal<ToolBeginning | null>(null);
  if (!may('operator', 'engineer')) return null;
  const Form = form.value;
  if (beginning.value === null || Form === null)
    return (
      <div>
        <Press
          act={async () => {
            form.value ??= (await import('./tool-form')).ToolForm;
            beginning.value = begin();
          }}
        >
          {label}
        </Press>
      </div>
    );
  return (
    <Form
      begin={beginning.value}
      done={(tool) => {
        beginning.value = null;
        if (tool === null) return;
        say(() => words.value.setup.toolSaved(tool.title), 'passes');
        saved?.(tool);
      }}
    />
  );
}
