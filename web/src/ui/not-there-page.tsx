import { words } from '../words';
import { Press } from './press';
import { go, route, runInRoute, to } from './route';
import type { Screen } from './screen';

function NotThere() {
  const said = words.value.absent;
  return (
    <div class="page not-there">
      <section>
        <h1>{runInRoute.value === null ? said.page : said.run}</h1>
        <p class="hint">{said.here(to(...route.value))}</p>
      </section>
    </div>
  );
}

function Actions() {
  return (
    <Press kind="primary" act={() => go()}>
      {words.value.absent.start}
    </Press>
  );
}

/** An address that names nothing of this service. */
export const notThere: Screen = { Page: NotThere, Actions, next: () => words.value.absent.next };
