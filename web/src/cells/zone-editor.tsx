import { useSignal } from '@preact/signals';
import type { CellPublic, Zone, ZonePlace } from '../api';
import { may } from '../session/session';
import { AskFirst } from '../ui/ask-first';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { moment } from '../ui/units';
import { words } from '../words';
import { Legend } from './cell-sketch';
import type { Cell } from './cells';
import type { ViewName } from './footprint';
import { isDrawable, placeOf, type ShapeKind, sizeOf } from './shapes';
import { deleteZone, putZoneBack } from './shown-cell';
import { ZoneBack } from './zone-back';
import { ZoneChanging } from './zone-changing';
import { begin, draft, drawing, drop, takeUp } from './zone-draft';
import { COARSE, tapped } from './zone-handles';
import { ZonePicture } from './zone-picture';
import { zoneWords } from './zone-words';

const VIEW_NAMES: ViewName[] = ['above', 'side'];
const KINDS: ShapeKind[] = ['box', 'cylinder', 'sphere'];
/** Where a new zone is put that nobody draws: so far from the base, m. */
const BESIDE_M = 1.5;

/** The protected zones: in the picture, which stays in sight, and beside it by numbers. */
export function ZoneEditor({ shown }: { shown: CellPublic }) {
  const { cell } = shown;
  if (cell === null) return null;
  return (
    <section class="zone-editor" aria-label={words.value.cells.zones}>
      <Pictures cell={cell} />
      <div class="zone-places">
        <h2>{words.value.cells.zones}</h2>
        <Hint cell={cell} />
        {may('engineer', 'operator') &&
          (drawing.value ? <Drawing cell={cell} kind={drawing.value} /> : <Add />)}
        {draft.value?.original === null && <ZoneChanging cell={cell} now={draft.value} />}
        {(cell.zones ?? []).map((zone) =>
          draft.value?.original?.name === zone.name ? (
            <ZoneChanging key={zone.name} cell={cell} now={draft.value} />
          ) : (
            <ZoneTile key={zone.name} zone={zone} shown={shown} />
          ),
        )}
        <Removed shown={shown} />
      </div>
    </section>
  );
}

function Hint({ cell }: { cell: Cell }) {
  const said = zoneWords.value;
  if (!may('engineer', 'operator')) return <p class="hint">{said.watch}</p>;
  return <p class="hint">{cell.zones?.length ? said.hint : said.hintNone}</p>;
}

/** The cell from above and from the side; a phone shows one of them at a time. */
function Pictures({ cell }: { cell: Cell }) {
  const said = zoneWords.value;
  const { views } = words.value.cells;
  const chosen = useSignal<ViewName>('above');
  const closer = useSignal(false);
  const now = draft.value;
  return (
    <figure class={`zone-pictures shows-${chosen.value}`}>
      {VIEW_NAMES.map((view) => (
        <div key={view} class={`zone-picture zone-picture-${view}`}>
          <ZonePicture cell={cell} view={view} closer={closer.value && now !== null} />
          <small>{views[view]}</small>
        </div>
      ))}
      <output class="zone-numbers">
        {now && `${now.name}: ${sizeOf(now.shape)}, ${placeOf(now.shape)}`}
      </output>
      <div class="row zone-views">
        <Press
          disabled={now === null}
          act={() => {
            closer.value = !closer.value;
          }}
        >
          {closer.value && now ? said.whole : said.closer}
        </Press>
        <div class="zone-view-choice">
          <Press
            act={() => {
              chosen.value = chosen.value === 'above' ? 'side' : 'above';
            }}
          >
            {views[chosen.value === 'above' ? 'side' : 'above']}
          </Press>
        </div>
      </div>
      <Legend changing={now !== null} />
    </figure>
  );
}

/** What a new zone is to be. */
function Add() {
  const said = zoneWords.value;
  return (
    <fieldset class="zone-add">
      <legend>{said.add}</legend>
      <div class="row">
        {KINDS.map((kind) => (
          <Press
            key={kind}
            act={() => {
              drop();
              drawing.value = kind;
            }}
          >
            <span aria-hidden="true">+</span> {said.kinds[kind]}
          </Press>
        ))}
      </div>
    </fieldset>
  );
}

/** A new zone is about to be drawn; who cannot draw has it put somewhere, and types the rest. */
function Drawing({ cell, kind }: { cell: Cell; kind: ShapeKind }) {
  const said = zoneWords.value;
  const [x = 0, y = 0] = cell.robot.base?.xyz_m ?? [];
  const beside = () => begin(tapped(kind, [x, y - BESIDE_M], cell.floor_z_m ?? 0, COARSE));
  return (
    <div class="tile" role="status">
      <p>{kind === 'box' ? said.draw.box : said.draw.round}</p>
      <div class="row">
        <Press act={beside}>{said.beside}</Press>
        <Press act={drop}>{words.value.cancel}</Press>
      </div>
    </div>
  );
}

/** A zone as it is stored: since when and by whom, and what can be done with it. */
function ZoneTile({ zone, shown }: { zone: Zone; shown: CellPublic }) {
  const said = words.value.cells;
  const own = zoneWords.value;
  const place = shown.moved.find((each) => each.zone === zone.name);
  return (
    <section class="tile">
      <h3>{zone.name}</h3>
      <p>
        {sizeOf(zone.shape)}, {said.centre(placeOf(zone.shape))}
      </p>
      <p class="hint">
        {!isDrawable(zone.shape) && `${own.fromFile} `}
        {place ? own.drawnBy(nameOf(place.moved_by), moment(place.received_at)) : said.asFile}
      </p>
      {may('engineer', 'operator') && (
        <>
          <div class="row">
            {isDrawable(zone.shape) && <Press act={() => takeUp(zone)}>{own.change}</Press>}
            <AskFirst
              label={own.remove}
              question={own.removeAsk(zone.name)}
              yes={own.removeYes}
              act={() => deleteZone(zone.name)}
            />
          </div>
          {place && !shown.in_the_way.includes(zone.name) && <ZoneBack zone={zone} place={place} />}
        </>
      )}
    </section>
  );
}

/** Zones that are no more, and the way back to them. */
function Removed({ shown }: { shown: CellPublic }) {
  const said = zoneWords.value;
  const there = new Set(shown.cell?.zones?.map(({ name }) => name));
  const gone = shown.moved.filter(({ zone }) => !there.has(zone));
  if (gone.length === 0) return null;
  return (
    <section class="tile">
      <h3>{said.removed}</h3>
      {gone.map((place) => (
        <div key={place.zone}>
          <p>
            {place.zone} <small>{said.removedBy(nameOf(place.moved_by), moment(place.received_at))}</small>
          </p>
          {may('engineer', 'operator') && (
            <Press act={() => bringBack(place)}>
              <span aria-hidden="true">↶</span> {said.bringBack(place.zone)}
            </Press>
          )}
        </div>
      ))}
    </section>
  );
}

/** As it was before, or as the file has it where it was deleted twice. */
const bringBack = (place: ZonePlace) => putZoneBack(place, place.previous ? 'before' : 'file');
