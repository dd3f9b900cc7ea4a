import type UPlot from 'uplot';

/** One notch of a wheel. */
const NOTCH = 0.8;
/** Of the whole; nearer there are no samples to be told apart. */
const NEAREST = 1e-3;

/** From the first moment of a plot's data to the last, s. */
export function extentOf(data: UPlot.AlignedData): [number, number] {
  return [data[0][0] ?? 0, data[0].at(-1) ?? 0];
}

/** Shows so much more or less of the time around a place on the screen; never beyond the data. */
export function zoom(plot: UPlot, factor: number, at_px: number): void {
  const [first, last] = extentOf(plot.data);
  const { min, max } = plot.scales.x ?? {};
  if (min == null || max == null) return;
  const [from, to] = [Math.max(min, first), Math.min(max, last)];
  const width = Math.min(last - first, Math.max(NEAREST * (last - first), factor * (to - from)));
  const middle = Math.min(to, Math.max(from, plot.posToVal(at_px, 'x')));
  const begin = middle - (to > from ? ((middle - from) / (to - from)) * width : 0);
  const shifted = Math.min(last - width, Math.max(first, begin));
  plot.setScale('x', { min: shifted, max: shifted + width });
}

/** Shows the whole again. */
export function reset(plot: UPlot): void {
  const [min, max] = extentOf(plot.data);
  plot.setScale('x', { min, max });
}

/** Whether only a part of the data is shown. */
export function isZoomed(plot: UPlot): boolean {
  const [first, last] = extentOf(plot.data);
  const { min, max } = plot.scales.x ?? {};
  if (min == null || max == null) return false;
  const least = 1e-6 * (last - first);
  return min > first + least || max < last - least;
}

/** Wheel and two fingers zoom, one finger moves the crosshair. A page scrolls on where there is nothing to zoom out of. */
export function followGestures(plot: UPlot): void {
  const { over } = plot;
  const fingers = new Map<number, PointerEvent>();
  const leftOf = (event: MouseEvent) => event.clientX - over.getBoundingClientRect().left;
  over.addEventListener(
    'wheel',
    (event) => {
      if (event.deltaY > 0 && !isZoomed(plot)) return;
      event.preventDefault();
      zoom(plot, event.deltaY < 0 ? NOTCH : 1 / NOTCH, leftOf(event));
    },
    { passive: false },
  );
  over.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'touch') fingers.set(event.pointerId, event);
  });
  over.addEventListener('pointermove', (event) => {
    const before = fingers.get(event.pointerId);
    if (before === undefined) return;
    const other = [...fingers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
    fingers.set(event.pointerId, event);
    if (other === undefined) {
      const top = event.clientY - over.getBoundingClientRect().top;
      plot.setCursor({ left: leftOf(event), top });
      return;
    }
    const apart = (one: PointerEvent) => Math.max(1, Math.abs(one.clientX - other.clientX));
    zoom(plot, apart(before) / apart(event), (leftOf(event) + leftOf(other)) / 2);
  });
  const lift = ({ pointerId }: PointerEvent) => fingers.delete(pointerId);
  over.addEventListener('pointerup', lift);
  over.addEventListener('pointercancel', lift);
}
