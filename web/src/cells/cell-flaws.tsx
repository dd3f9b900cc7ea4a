import type { CellPublic } from '../api';
import { may } from '../session/session';
import { FlawList } from '../ui/flaw-list';
import { words } from '../words';
import { ZoneBack } from './zone-back';

/** Why nothing can be planned in a cell as it is now, and what there is to be done about it. */
export function CellFlaws({ shown }: { shown: CellPublic }) {
  const said = words.value.cells;
  const { cell, flaws, in_the_way, moved } = shown;
  if (flaws.length === 0) return null;
  const movedInTheWay = moved.filter(({ zone }) => in_the_way.includes(zone));
  const ofFiles = flaws.length > movedInTheWay.length;
  return (
    <FlawList title={said.nothingPlanned} flaws={flaws}>
      {movedInTheWay.map((place) => {
        const zone = cell?.zones?.find(({ name }) => name === place.zone);
        return (
          zone && (
            <div class="mend" key={zone.name}>
              <p>{said.zoneInTheWay(zone.name)}</p>
              {may('engineer', 'operator') && <ZoneBack zone={zone} place={place} />}
            </div>
          )
        );
      })}
      {ofFiles && <p>{may('engineer') ? said.mendFiles : said.mendFilesElse}</p>}
    </FlawList>
  );
}
