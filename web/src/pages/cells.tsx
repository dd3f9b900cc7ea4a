import { CellChoice } from '../parts/cell-choice';
import { CellFacts } from '../parts/cell-facts';
import { CellUpload } from '../parts/cell-upload';
import type { Screen } from '../parts/screen';
import { Viewer } from '../parts/viewer';
import { ZonePlaces } from '../parts/zone-places';
import { go } from '../route';
import { may } from '../stores/session';
import { looked, shownCell } from '../stores/shown-cell';
import { words } from '../words';

function Cells() {
  const said = words.value.cells;
  const shown = shownCell.value;
  return (
    <div class="page cells">
      <section>
        <h1>{said.title}</h1>
        <CellChoice legend={said.list} chosen={looked.value} choose={(name) => go('cells', name)} />
        {may('engineer') && <CellUpload />}
        {shown && <ZonePlaces shown={shown} />}
      </section>
      <section>
        {looked.value && <Viewer cell={looked.value} />}
        {shown && <CellFacts cell={shown.cell} />}
      </section>
    </div>
  );
}

function next(): string {
  const said = words.value.cells;
  return may('engineer') ? said.nextEngineer : said.next;
}

export const cells: Screen = { Page: Cells, next };
