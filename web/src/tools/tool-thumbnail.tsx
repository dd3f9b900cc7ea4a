import { signal } from '@preact/signals';
import type { FunctionComponent } from 'preact';
import { useEffect } from 'preact/hooks';
import type { Box } from '../api';
import { until } from '../ui/connection';

/** What draws a tool comes once the page stands: nobody waits for it. */
const picture = signal<FunctionComponent<{ box: Box; small: boolean }> | null>(null);

async function load(): Promise<void> {
  picture.value ??= (await import('./tool-picture')).ToolPicture;
}

/** A tool's box, small, beside its name. */
export function ToolThumbnail({ box }: { box: Box }) {
  useEffect(() => (picture.peek() === null ? until(load) : undefined), []);
  const Picture = picture.value;
  return <span class="tool-thumbnail">{Picture && <Picture box={box} small />}</span>;
}
