import { activeRun } from '../run/runs';
import { may } from '../session/session';
import { words } from '../words';
import { route, to } from './route';

/** The pages that can be gone to at any time. */
export function Navigation() {
  const said = words.value.nav;
  const active = activeRun.value;
  const work = active === null ? to() : to('runs', active.run);
  const here = route.value[0] ?? 'runs';
  const ofGap = here === 'gap' || here === 'import' || here === 'trials';
  return (
    <nav class="navigation" aria-label={said.label}>
      <a href={work} aria-current={here === 'runs' ? 'page' : undefined}>
        {said.work}
      </a>
      <a href={to('orders')} aria-current={here === 'orders' ? 'page' : undefined}>
        {words.value.orders.nav}
      </a>
      <a href={to('gap')} aria-current={ofGap ? 'page' : undefined}>
        {words.value.gap.nav}
      </a>
      <a
        href={to('history')}
        aria-current={['history', 'series', 'timeline'].includes(here ?? '') ? 'page' : undefined}
      >
        {said.history}
      </a>
      <a href={to('tools')} aria-current={here === 'tools' ? 'page' : undefined}>
        {said.tools}
      </a>
      <a href={to('cells')} aria-current={here === 'cells' || here === 'new-cell' ? 'page' : undefined}>
        {said.cells}
      </a>
      <a href={to('settings')} aria-current={here === 'settings' ? 'page' : undefined}>
        {said.settings}
      </a>
      {may('admin', 'engineer') && (
        <a href={to('admin')} aria-current={here === 'admin' ? 'page' : undefined}>
          {said.admin}
        </a>
      )}
    </nav>
  );
}
