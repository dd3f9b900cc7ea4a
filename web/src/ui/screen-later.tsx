import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { words } from '../words';
import { until } from './connection';
import { Press } from './press';
import { Reading } from './reading';
import type { Screen } from './screen';

/** A screen whose code comes when somebody goes there: a tablet that carries out runs loads no more than these need. */
export function screenLater(load: () => Promise<() => Screen>): () => Screen {
  const screenHere = signal<(() => Screen) | null>(null);
  /** Whether the code did not come: after an update of the service it has another name. */
  const old = signal(false);
  const begin = async () => {
    try {
      screenHere.value = await load();
    } catch (error) {
      old.value = true;
      throw error;
    }
  };
  const Page = () => {
    useEffect(() => until(begin), []);
    return old.value ? <Outdated /> : <Reading />;
  };
  const loading: Screen = { Page, next: () => words.value.reading.title };
  return () => screenHere.value?.() ?? loading;
}

function Outdated() {
  const said = words.value.reading;
  return (
    <div class="page">
      <section>
        <h1>{said.title}</h1>
        <p>{said.old}</p>
        <div>
          <Press act={() => location.reload()}>{said.reload}</Press>
        </div>
      </section>
    </div>
  );
}
