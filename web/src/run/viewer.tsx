import type { ComponentChildren } from 'preact';
import { useEffect } from 'preact/hooks';
import { dark } from '../session/settings';
import { Press } from '../ui/press';
import { words } from '../words';
import { drawnCell, type Look, turnCamera, viewName } from './view';

const LOOKS: Look[] = ['front', 'top', 'operator', 'fit', 'reset'];

/** The cell in three dimensions, as the service shows it to this page, and from where it is looked at. */
export function Viewer({ cell, children }: { cell: string; children?: ComponentChildren }) {
  useEffect(() => {
    drawnCell.value = cell;
    return () => {
      drawnCell.value = '';
    };
  }, [cell]);
  const said = words.value.view;
  return (
    <div class="view">
      {cell && (
        <>
          <iframe
            class="viewer"
            title={words.value.viewer}
            src={`/viewer/${encodeURIComponent(cell)}/${viewName}/${dark.value ? '?darkMode' : ''}`}
          />
          <fieldset class="looks">
            <legend class="out-of-sight">{said.from}</legend>
            {LOOKS.map((look) => (
              <Press key={look} act={() => turnCamera(cell, look)}>
                {said.looks[look]}
              </Press>
            ))}
          </fieldset>
        </>
      )}
      {children}
    </div>
  );
}
