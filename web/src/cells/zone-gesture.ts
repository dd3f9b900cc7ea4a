import type { RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { Zone } from '../api';
import type { Point, ViewName } from './footprint';
import type { Shape } from './shapes';
import { begin, draft, drag, drawing, endDrag, takeUp } from './zone-draft';
import { COARSE, dragged, drawn, FINE, type Grid, type Grip, tapped } from './zone-handles';

/** Less than this is a tap, px. */
const TAP_PX = 8;

/** One finger, pen or mouse button on its way. */
interface Gesture {
  pointer: number;
  grid: Grid;
  from: Point;
  from_px: [number, number];
  /** What is dragged, and by what; null where a new zone is being drawn. */
  held: { shape: Shape; grip: Grip } | null;
}

interface Events {
  onPointerDown: (event: PointerEvent) => void;
  onPointerMove: (event: PointerEvent) => void;
  onPointerUp: (event: PointerEvent) => void;
  onPointerCancel: (event: PointerEvent) => void;
}

/**
 * What fingers, pens and mice do in a picture: drag zones by what carries `data-grip`, and draw new ones.
 *
 * @param zones those that can be dragged, by `data-zone`; none for who may not.
 * @param floor_m on which a new one stands.
 * @param busy is told whether anything is dragged: meanwhile the picture must stay as it is.
 */
export function useGesture(
  picture: RefObject<SVGSVGElement | null>,
  view: ViewName,
  zones: Zone[],
  floor_m: number,
  busy: (is: boolean) => void,
): Events {
  const gesture = useRef<Gesture | null>(null);
  useEffect(() => keepFinger(picture.current), [picture]);
  const where = (event: PointerEvent): Point => {
    const matrix = picture.current?.getScreenCTM()?.inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [x, -y];
  };
  const down = (event: PointerEvent) => {
    if (gesture.current || event.button !== 0) return;
    const draws = drawing.value !== null && view === 'above';
    const held = draws ? null : holdOf(event.target as Element, zones);
    if (held === null && !draws) return;
    event.preventDefault();
    picture.current?.setPointerCapture(event.pointerId);
    gesture.current = {
      pointer: event.pointerId,
      grid: event.pointerType === 'touch' ? COARSE : FINE,
      from: where(event),
      from_px: [event.clientX, event.clientY],
      held,
    };
    busy(true);
  };
  const move = (event: PointerEvent) => {
    const now = gesture.current;
    if (now?.pointer !== event.pointerId || isTap(now, event)) return;
    const to = where(event);
    if (now.held) drag(dragged(now.held.shape, now.held.grip, view, now.from, to, now.grid));
    else draw(now, to, floor_m);
  };
  const end = (event: PointerEvent, given: boolean) => {
    const now = gesture.current;
    if (now?.pointer !== event.pointerId) return;
    gesture.current = null;
    if (!given && now.held) drag(now.held.shape);
    else if (now.held) endDrag(now.held.shape);
    else if (given && drawing.value) begin(tapped(drawing.value, now.from, floor_m, now.grid));
    busy(false);
  };
  return {
    onPointerDown: down,
    onPointerMove: move,
    onPointerUp: (event) => end(event, true),
    onPointerCancel: (event) => end(event, false),
  };
}

/** A stroke that draws a new zone becomes one that drags its corner. */
function draw(now: Gesture, to: Point, floor_m: number): void {
  const kind = drawing.value ?? draft.value?.shape.kind ?? 'box';
  const shape = drawn(kind, now.from, to, floor_m, now.grid);
  if (drawing.value) begin(shape);
  else drag(shape);
}

/** What is taken hold of there: a handle of the draft, or a zone, which becomes the draft. */
function holdOf(target: Element, zones: Zone[]): Gesture['held'] {
  const handle = target.closest<SVGElement>('[data-grip]')?.dataset.grip;
  if (handle && draft.value) return { shape: draft.value.shape, grip: JSON.parse(handle) as Grip };
  const name = target.closest<SVGElement>('[data-zone]')?.dataset.zone;
  const zone = zones.find((each) => each.name === name);
  if (!zone) return null;
  takeUp(zone);
  return draft.value && { shape: draft.value.shape, grip: { at: 'body' } };
}

function isTap(now: Gesture, event: PointerEvent): boolean {
  const far = Math.hypot(event.clientX - now.from_px[0], event.clientY - now.from_px[1]);
  return far < TAP_PX && (now.held ? draft.value?.shape === now.held.shape : drawing.value !== null);
}

/** A browser takes a finger over to scroll the page after its first moves, unless its `touchstart` is refused: `touch-action` is too late. */
function keepFinger(picture: SVGSVGElement | null): (() => void) | undefined {
  if (picture === null) return undefined;
  const refuse = (event: TouchEvent) => {
    const held = (event.target as Element).closest('[data-grip], [data-zone]');
    if (event.cancelable && (held || drawing.peek())) event.preventDefault();
  };
  picture.addEventListener('touchstart', refuse, { passive: false });
  return () => picture.removeEventListener('touchstart', refuse);
}
