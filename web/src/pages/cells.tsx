import { CellChoice } from '../parts/cell-choice';
import { CellFacts } from '../parts/cell-facts';
import { CellFlaws } from '../parts/cell-flaws';
import { CellSketch } from '../parts/cell-sketch';
import { CellUpload } from '../parts/cell-upload';
import { FlawList } from '../parts/flaw-list';
import type { Screen } from '../parts/screen';
import { Viewer } from '../parts/viewer';
import { ZonePlaces } from '../parts/zone-places';
import { go } from '../route';
import { cells as allCells, type Cell } from '../stores/cells';
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
        <Flawed />
        {may('engineer') && <CellUpload />}
        {shown?.cell && <ZonePlaces shown={shown} />}
      </section>
      <section>
        {shown?.drawn && <Viewer key={shown.sha256} cell={looked.value} />}
        {shown?.cell && !shown.drawn && <Undrawn cell={shown.cell} />}
        {shown?.cell && <CellFacts cell={shown.cell} />}
      </section>
    </div>
  );
}

/** What is wrong with the cell that is looked at: as it is now, or where nobody can ask for it by its name, as the list has it. */
function Flawed() {
  if (shownCell.value) return <CellFlaws shown={shownCell.value} />;
  const listed = allCells.value?.find(({ name }) => name === looked.value);
  if (!listed || listed.flaws.length === 0) return null;
  return <FlawList title={words.value.cells.nothingPlanned} flaws={listed.flaws} />;
}

function Undrawn({ cell }: { cell: Cell }) {
  return (
    <section class="undrawn">
      <p>{words.value.cells.notDrawn}</p>
      <CellSketch cell={cell} />
    </section>
  );
}

function next(): string {
  const said = words.value.cells;
  if (shownCell.value?.flaws.length) return said.nextFlawed;
  return may('engineer') ? said.nextEngineer : said.next;
}

export const cells: Screen = { Page: Cells, next };
