import { signal } from '@preact/signals';
import type { FunctionComponent } from 'preact';
import { useEffect } from 'preact/hooks';
import { until } from '../ui/connection';
import { helpOpen } from './help';
import { touring } from './tour';

/** The code of help and tour, which comes when somebody asks for the first of them. */
const parts = signal<{ HelpPanel: FunctionComponent; Tour: FunctionComponent } | null>(null);

async function load(): Promise<void> {
  const [{ HelpPanel }, { Tour }] = await Promise.all([import('./help-panel'), import('./tour-card')]);
  parts.value = { HelpPanel, Tour };
}

/** Help and tour, over the page and never over the bars with what stops the robot. */
export function HelpLayer() {
  const wanted = helpOpen.value || touring.value !== null;
  useEffect(() => (wanted && parts.value === null ? until(load) : undefined), [wanted]);
  const found = parts.value;
  if (found === null || !wanted) return null;
  return touring.value === null ? <found.HelpPanel /> : <found.Tour />;
}
