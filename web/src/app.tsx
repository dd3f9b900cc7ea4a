import { alarmsScreen } from './alarms/alarms-page';
import { HelpLayer } from './help/help-layer';
import { historyScreen } from './history/history-page';
import { ordersScreen } from './orders/orders-page';
import { CommandBar } from './run/command-bar';
import { controlScreen } from './run/control-page';
import { LostLayer } from './run/lost-layer';
import { runScreen } from './run/run-page';
import { setup } from './run/setup-page';
import { session } from './session/session';
import { settings } from './session/settings-page';
import { signingIn } from './session/sign-in-page';
import { absent } from './ui/absent';
import { Header } from './ui/header';
import { Navigation } from './ui/navigation';
import { notThere } from './ui/not-there-page';
import { route } from './ui/route';
import type { Screen } from './ui/screen';
import { screenLater } from './ui/screen-later';
import { fetchLaterMessages } from './words/messages';

const adminScreen = screenLater(async () => (await import('./admin/admin-page')).screenHere);
const cellsScreen = screenLater(async () => (await import('./cells/cells-page')).cellsScreen);
const gapScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./gap/gap-page')).gapScreen;
});
const importScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./imports/import-page')).importScreen;
});
const manualScreen = screenLater(async () => (await import('./help/manual-page')).manualScreen);
const newCellScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./new-cell/new-cell-page')).newCellScreen;
});
const seriesScreen = screenLater(async () => (await import('./history/series-page')).seriesScreen);
const timelineScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./history/timeline-page')).timelineScreen;
});
const toolsScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./tools/tools-page')).toolsScreen;
});
const trialsScreen = screenLater(async () => {
  await fetchLaterMessages();
  return (await import('./trials/trials-page')).trialsScreen;
});

/** A page for each first piece of the address; a new page is a line here, and in parts/navigation.tsx. */
const SCREENS = new Map<string, () => Screen>([
  ['', () => setup],
  ['runs', runScreen],
  ['gap', gapScreen],
  ['import', importScreen],
  ['trials', trialsScreen],
  ['history', historyScreen],
  ['series', seriesScreen],
  ['timeline', timelineScreen],
  ['tools', toolsScreen],
  ['cells', cellsScreen],
  ['new-cell', newCellScreen],
  ['orders', () => ordersScreen],
  ['alarms', () => alarmsScreen],
  ['control', () => controlScreen],
  ['settings', () => settings],
  ['admin', adminScreen],
  ['manual', manualScreen],
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
      <HelpLayer />
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
