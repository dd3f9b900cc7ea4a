import { useSignal } from '@preact/signals';
import { useEffect, useId } from 'preact/hooks';
import { NARROW_SPACE, number, scaleOf, typed } from '../ui/units';
import { anglesOf, centred, centreOf, isUpright, type Shape, type Three } from './shapes';
import { step } from './zone-draft';
import { zoneWords } from './zone-words';

const AXES = ['x', 'y', 'z'] as const;
const DEGREE = Math.PI / 180;
/** As the service has it. */
const SHORTEST_M = 0.02;

/** What is typed of a zone: its centre, its size, how it is turned. The picture follows the numbers, and they follow the picture. */
export function ZoneFields({ shape }: { shape: Shape }) {
  const said = zoneWords.value;
  const { unit } = scaleOf('length');
  const centre = centreOf(shape);
  const [roll, pitch, yaw] = anglesOf(shape);
  return (
    <>
      <fieldset>
        <legend>
          {said.centre}, {unit}
        </legend>
        <div class="three">
          {AXES.map((axis, k) => (
            <LengthField
              key={axis}
              label={axis}
              value_m={centre[k] ?? 0}
              change={(value) => step(centred(shape, centre.with(k, value) as Three))}
            />
          ))}
        </div>
      </fieldset>
      {isUpright(shape) ? <SizeFields shape={shape} /> : <p class="hint">{said.leans}</p>}
      {isUpright(shape) && shape.kind === 'box' && (
        <ValueField
          label={`${said.turn}, °`}
          text={plain(yaw / DEGREE, 1)}
          take={(value) =>
            step({ ...shape, pose: { ...shape.pose, rpy_rad: [roll, pitch, (value % 360) * DEGREE] } })
          }
        />
      )}
    </>
  );
}

function SizeFields({ shape }: { shape: Shape }) {
  const said = zoneWords.value;
  const { unit } = scaleOf('length');
  return (
    <fieldset>
      <legend>
        {said.size}, {unit}
      </legend>
      <div class="three">
        {shape.kind === 'box' ? (
          said.sides.map((label, k) => (
            <LengthField
              key={label}
              label={label}
              value_m={shape.size_m[k] ?? 0}
              least_m={SHORTEST_M}
              change={(value) => step({ ...shape, size_m: shape.size_m.with(k, value) as Three })}
            />
          ))
        ) : (
          <LengthField
            label={said.diameter}
            value_m={2 * shape.radius_m}
            least_m={SHORTEST_M}
            change={(value) => step({ ...shape, radius_m: value / 2 })}
          />
        )}
        {(shape.kind === 'cylinder' || shape.kind === 'capsule') && (
          <LengthField
            label={shape.kind === 'capsule' ? said.middle : said.length}
            value_m={shape.length_m}
            least_m={SHORTEST_M}
            change={(value) => step({ ...shape, length_m: value })}
          />
        )}
      </div>
    </fieldset>
  );
}

interface LengthProps {
  label: string;
  value_m: number;
  /** The least that it may be; a place may be anything. */
  least_m?: number;
  change: (value_m: number) => void;
}

/** A length in the chosen unit. */
function LengthField({ label, value_m, least_m, change }: LengthProps) {
  const { factor, places } = scaleOf('length');
  return (
    <ValueField
      label={label}
      text={plain(factor * value_m, places)}
      least={least_m === undefined ? undefined : factor * least_m}
      take={(value) => change(value / factor)}
    />
  );
}

interface ValueProps {
  label: string;
  /** What it is now. */
  text: string;
  least?: number | undefined;
  take: (value: number) => void;
}

/** A field that shows what is now until somebody types, and again what is now as soon as that changes elsewhere. */
function ValueField({ label, text, least, take }: ValueProps) {
  const said = zoneWords.value;
  const written = useSignal<string | null>(null);
  const note = useId();
  const value = written.value === null ? null : typed(written.value);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is typed counts until what is shown becomes another number
  useEffect(() => {
    if (value === null || plain(value, decimalsOf(text)) !== text) written.value = null;
  }, [text]);
  const low = value !== null && least !== undefined && value < least;
  const flaw = written.value !== null && (value === null || low);
  return (
    <label class="field">
      <span>{label}</span>
      <input
        inputMode={least === undefined ? 'text' : 'decimal'}
        value={written.value ?? text}
        aria-invalid={flaw}
        aria-describedby={flaw ? note : undefined}
        onInput={({ currentTarget }) => {
          written.value = currentTarget.value;
          const given = typed(currentTarget.value);
          if (given !== null && (least === undefined || given >= least)) take(given);
        }}
        onBlur={() => {
          if (!flaw) written.value = null;
        }}
      />
      {flaw && (
        <small id={note} class="hint flaw">
          {low ? said.badLength : said.badNumber}
        </small>
      )}
    </label>
  );
}

/** A number as it is typed. */
function plain(value: number, places: number): string {
  return number(value, places).replaceAll(NARROW_SPACE, '');
}

function decimalsOf(text: string): number {
  return text.split(/[.,]/)[1]?.length ?? 0;
}
