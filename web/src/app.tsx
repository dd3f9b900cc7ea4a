import { cells } from './pages/cells';
import { gapScreen } from './pages/gap';
import { historyScreen } from './pages/history';
import { notThere } from './pages/not-there';
import { runScreen } from './pages/run';
import { settings } from './pages/settings';
import { setup } from './pages/setup';
import { signingIn } from './pages/sign-in';
import { trialsScreen } from './pages/trials';
import { CommandBar } from './parts/command-bar';
import { Header } from './parts/header';
import { LostLayer } from './parts/lost-layer';
import { Navigation } from './parts/navigation';
import type { Screen } from './parts/screen';
import { route } from './route';
import { absent } from './stores/absent';
import { session } from './stores/session';

/** A page for each first piece of the address; a new page is a line here, and in parts/navigation.tsx. */
const SCREENS = new Map<string, () => Screen>([
  ['', () => setup],
  ['runs', runScreen],
  ['gap', gapScreen],
  ['trials', trialsScreen],
  ['history', historyScreen],
  ['cells', () => cells],
  ['settings', () => settings],
]);

export function App() {
  if (session.value === undefined) return <LostLayer />;
  const screen = session.value === null ? signingIn : screenHere();
  return (
    <>
      <Header />
      {session.value !== null && <Navigation />}
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: without a finger it is scrolled by its keys */}
      <main tabIndex={0}>
        <screen.Page />
      </main>
      <CommandBar screen={screen} />
      <LostLayer />
    </>
  );
}

function screenHere(): Screen {
  const name = route.value[0] ?? '';
  const found = SCREENS.get(name);
  return found === undefined || absent.value ? notThere : found();
}
