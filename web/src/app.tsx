import { cells } from './pages/cells';
import { gapScreen } from './pages/gap';
import { historyScreen } from './pages/history';
import { runScreen } from './pages/run';
import { settings } from './pages/settings';
import { setup } from './pages/setup';
import { signingIn } from './pages/sign-in';
import { trialsScreen } from './pages/trials';
import { CommandBar } from './parts/command-bar';
import { Header } from './parts/header';
import { Navigation } from './parts/navigation';
import type { Screen } from './parts/screen';
import { route } from './route';
import { session } from './stores/session';

/** A page for each first piece of the address; a new page is a line here, and in parts/navigation.tsx. */
const SCREENS: Record<string, () => Screen> = {
  '': () => setup,
  runs: runScreen,
  gap: gapScreen,
  trials: trialsScreen,
  history: historyScreen,
  cells: () => cells,
  settings: () => settings,
};

export function App() {
  if (session.value === undefined) return null;
  const here = SCREENS[route.value[0] ?? ''] ?? (() => setup);
  const screen = session.value === null ? signingIn : here();
  return (
    <>
      <Header />
      {session.value !== null && <Navigation />}
      <main>
        <screen.Page />
      </main>
      <CommandBar screen={screen} />
    </>
  );
}
