import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Zone } from '../api';
import { may } from '../session/session';
import { words } from '../words';
import type { Cell } from './cells';
import { footprint, type Point, pointsOf, type Square, square, VIEWS, type ViewName } from './footprint';
import { centreOf, type Three } from './shapes';
import { type Draft, draft, drawing, step } from './zone-draft';
import { useGesture } from './zone-gesture';
import { COARSE, type Handle, handlesOf, moved } from './zone-handles';
import { zoneWords } from './zone-words';

const BASE_M = 0.09;
/** What of the cell is to be seen around robot and zones, m. */
const AROUND_M = 0.4;
/** Radius of what a finger finds, and of what is seen of it, px. */
const FINGER_PX = 24;
const DOT_PX = 10;
/** How far a handle is outside of the edge that it drags, px. */
const AWAY_PX = 14;
/** An arrow that goes round, px. */
const TURN_SIGN = 'M-4 -4A5.5 5.5 0 1 1 -5.5 1M-7 -6L-4 -4L-6.5 -1';
const ARROWS: Record<ViewName, Record<string, Three>> = {
  above: { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0] },
  side: { ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1] },
};

interface Props {
  cell: Cell;
  view: ViewName;
  /** Whether the picture shows what is being changed, as large as it can, and not the whole cell. */
  closer: boolean;
}

/** A cell from above or from the side, in which zones are dragged, resized, turned and drawn. */
export function ZonePicture({ cell, view, closer }: Props) {
  const picture = useRef<SVGSVGElement>(null);
  const held = useSignal<Square | null>(null);
  const width_px = useWidth(picture);
  const zones = cell.zones ?? [];
  const now = draft.value;
  const seen = held.value ?? squareOf(cell, now, view, closer);
  const mine = may('engineer', 'operator');
  const events = useGesture(picture, view, mine ? zones : [], cell.floor_z_m ?? 0, (is) => {
    held.value = is ? seen : null;
  });
  const base = seenIn(cell.robot.base?.xyz_m ?? [0, 0, 0], view);
  return (
    // biome-ignore lint/a11y/useSemanticElements: a picture is no fieldset
    <svg
      ref={picture}
      viewBox={`${seen.left} ${seen.top} ${seen.size} ${seen.size}`}
      class={mine && drawing.value && view === 'above' ? 'drawing' : ''}
      role="group"
      aria-label={words.value.cells.views[view]}
      {...events}
    >
      {(cell.obstacles ?? []).map(({ name, shape }) => (
        <polygon key={name} class="obstacle" points={pointsOf(footprint(shape, VIEWS[view]))} />
      ))}
      {zones.map((zone) => (
        <polygon
          key={zone.name}
          class={`zone ${now?.original?.name === zone.name ? 'zone-before' : ''}`}
          data-zone={mine ? zone.name : undefined}
          points={pointsOf(footprint(zone.shape, VIEWS[view]))}
        />
      ))}
      <circle class="base" cx={base[0]} cy={-base[1]} r={BASE_M} />
      {now && <Changed now={now} view={view} px={seen.size / width_px} />}
    </svg>
  );
}

/** The zone that is being changed, with its handles; `px` says how many metres one is. */
function Changed({ now, view, px }: { now: Draft; view: ViewName; px: number }) {
  const pressed = (event: KeyboardEvent) => {
    const way = ARROWS[view][event.key];
    if (way === undefined) return;
    event.preventDefault();
    const far = (event.shiftKey ? 10 : 1) * COARSE.step_m;
    step(moved(now.shape, way.map((each) => each * far) as Three, COARSE));
  };
  return (
    <>
      {/* biome-ignore lint/a11y/useSemanticElements: a polygon is no button, and arrows move it */}
      <polygon
        class="zone-new"
        role="button"
        tabindex={0}
        aria-label={zoneWords.value.arrows(now.name)}
        data-grip={JSON.stringify({ at: 'body' })}
        points={pointsOf(footprint(now.shape, VIEWS[view]))}
        onKeyDown={pressed}
      />
      {handlesOf(now.shape, view, AWAY_PX * px).map((handle) => (
        <Grip key={JSON.stringify(handle.grip)} handle={handle} px={px} />
      ))}
    </>
  );
}

/** What a finger takes hold of: larger than what is seen of it. The typed fields do the same for who has none. */
function Grip({ handle: { grip, place }, px }: { handle: Handle; px: number }) {
  const [u, v] = place;
  return (
    <g class={`grip grip-${grip.at}`} data-grip={JSON.stringify(grip)}>
      <circle class="grip-finger" cx={u} cy={-v} r={FINGER_PX * px} />
      <circle class="grip-dot" cx={u} cy={-v} r={DOT_PX * px} />
      {grip.at === 'turn' && (
        <path class="grip-turn-sign" d={TURN_SIGN} transform={`translate(${u} ${-v}) scale(${px})`} />
      )}
    </g>
  );
}

/** What is shown while nothing is dragged: robot and zones, the changed one wherever it was dragged to; or that alone. */
function squareOf(cell: Cell, now: Draft | null, view: ViewName, closer: boolean): Square {
  const outline = now ? footprint(now.shape, VIEWS[view]) : [];
  if (now && closer) return square(outline, square(outline, 0).size / 4);
  const base = seenIn(cell.robot.base?.xyz_m ?? [0, 0, 0], view);
  const zones = (cell.zones ?? []).flatMap(({ shape }: Zone) => footprint(shape, VIEWS[view]));
  const centre = now ? [seenIn(centreOf(now.shape), view)] : [];
  return square([base, ...zones, ...outline, ...centre], AROUND_M);
}

function seenIn(point: Three, view: ViewName): Point {
  const [a, b] = VIEWS[view];
  return [point[a], point[b]];
}

/** How wide the picture is on this screen, px. */
function useWidth(picture: { current: SVGSVGElement | null }): number {
  const width = useSignal(400);
  useEffect(() => {
    const measure = () => {
      width.value = Math.max(1, picture.current?.clientWidth ?? 1);
    };
    const watching = new ResizeObserver(measure);
    if (picture.current) watching.observe(picture.current);
    return () => watching.disconnect();
  }, [picture, width]);
  return width.value;
}
