import type { Signal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { Press } from '../ui/press';

interface Props<Entry> {
  /** Null until they are known. */
  entries: Entry[] | null;
  /** What is said where there are none. */
  none: string;
  show: (entry: Entry) => ComponentChildren;
  /** What the button says that shows the form. */
  add: string;
  adding: Signal<boolean>;
  form: ComponentChildren;
}

/** What there is of one kind, with a button that adds to it. */
export function EntryList<Entry>({ entries, none, show, add, adding, form }: Props<Entry>) {
  return (
    <>
      {adding.value ? (
        form
      ) : (
        <div class="row">
          <Press
            act={() => {
              adding.value = true;
            }}
          >
            {add}
          </Press>
        </div>
      )}
      {entries?.length === 0 && <p>{none}</p>}
      <ul class="tiles">{(entries ?? []).map(show)}</ul>
    </>
  );
}
