const WIDTH = 180;
const HEIGHT = 28;
/** Intervals from the middle to either edge. */
const REACH = 3;

/** How far a difference is from nothing, in multiples of its interval: inside the band it is no more than chance. */
export function DifferenceMark({ times }: { times: number }) {
  const at = (multiple: number) => (WIDTH / 2) * (1 + (0.85 * multiple) / REACH);
  const outside = Math.abs(times) > REACH;
  const x = at(Math.max(-REACH, Math.min(REACH, times)));
  const y = HEIGHT / 2;
  return (
    <svg class="difference-mark" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      <rect x={at(-1)} y={3} width={at(1) - at(-1)} height={HEIGHT - 6} />
      <line x1={at(0)} y1={0} x2={at(0)} y2={HEIGHT} />
      {outside ? (
        <path d={`M${x} ${y - 8}l${8 * Math.sign(times)} 8l${-8 * Math.sign(times)} 8z`} />
      ) : (
        <circle cx={x} cy={y} r={6} />
      )}
    </svg>
  );
}
