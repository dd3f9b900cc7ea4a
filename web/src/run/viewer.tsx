import { words } from '../words';

/** The cell in three dimensions, as the service shows it; to look at only. */
export function Viewer({ cell }: { cell: string }) {
  return <iframe class="viewer" title={words.value.viewer} src={`/viewer/${encodeURIComponent(cell)}/`} />;
}
