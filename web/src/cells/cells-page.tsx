import '../look/zones.css';
import { Viewer } from '../run/viewer';
import { may } from '../session/session';
import { FlawList } from '../ui/flaw-list';
import { go, to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { CellChoice } from './cell-choice';
import { CellFacts } from './cell-facts';
import { CellFlaws } from './cell-flaws';
import { CellSketch } from './cell-sketch';
import { CellUpload } from './cell-upload';
import { cells as allCells, type Cell } from './cells';
import { looked, shownCell } from './shown-cell';
import { draft, drawing } from './zone-draft';
import { ZoneEditor } from './zone-editor';
import { zoneWords } from './zone-words';

function Cells() {
  const said = words.value.cells;
  const shown = shownCell.value;
  return (
    <div class="page cells">
      <section>
        <h1>{said.title}</h1>
        <CellChoice legend={said.list} chosen={looked.value} choose={(name) => go('cells', name)} />
        <Flawed />
        {may('engineer') && (
          <section>
            <h2>{said.fromRobot}</h2>
            <p class="hint">{said.fromRobotHint}</p>
            <a class="download" href={to('new-cell')}>
              {said.fromRobotBegin}
            </a>
          </section>
        )}
        {may('engineer') && <CellUpload />}
      </section>
      <section>
        {shown?.drawn && <Viewer key={shown.sha256} cell={looked.value} />}
        {shown?.cell && !shown.drawn && <Undrawn cell={shown.cell} />}
      </section>
      {shown?.cell && <ZoneEditor shown={shown} />}
      {shown?.cell && <CellFacts cell={shown.cell} />}
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
  if (drawing.value) return zoneWords.value.nextDrawing;
  if (draft.value) return zoneWords.value.nextChanging;
  if (shownCell.value?.flaws.length) return said.nextFlawed;
  return may('engineer') ? said.nextEngineer : said.next;
}

const page: Screen = { Page: Cells, next };

export const cellsScreen = (): Screen => page;
