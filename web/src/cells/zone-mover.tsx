import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Flaw, Zone } from '../api';
import { FlawList } from '../ui/flaw-list';
import { NumberField } from '../ui/number-field';
import { Press } from '../ui/press';
import { Refusal } from '../ui/refusal';
import { NARROW_SPACE, number, scaleOf, typed } from '../ui/units';
import { words } from '../words';
import { CellSketch } from './cell-sketch';
import type { Cell } from './cells';
import { centreOf } from './shapes';
import { checkZone, moveZone } from './shown-cell';

const AXES = ['x', 'y', 'z'] as const;
/** How long nobody types before a place is looked at. */
const PAUSE_MS = 300;

type Place = [number, number, number];

interface Props {
  cell: Cell;
  zone: Zone;
}

/** Three fields for the centre of a zone, which follow it until somebody types; a typed place is shown before the zone moves there. */
export function ZoneMover({ cell, zone }: Props) {
  const said = words.value.cells;
  const texts = useSignal<(string | null)[]>([null, null, null]);
  const { factor, unit, places } = scaleOf('length');
  const now = centreOf(zone.shape);
  const there = now.map((value) => number(factor * value, places).replaceAll(NARROW_SPACE, ''));
  const written = AXES.map((_, k) => texts.value[k] ?? there[k] ?? '');
  const to = texts.value.every((text) => text === null) ? null : placeOfTexts(written, factor);
  const leave = () => {
    texts.value = [null, null, null];
  };
  return (
    <fieldset>
      <legend>
        {said.moveTo(zone.name)}, {unit}
      </legend>
      <div class="three">
        {AXES.map((axis, k) => (
          <NumberField
            key={axis}
            label={axis}
            signed
            text={written[k] ?? ''}
            flaw={typed(written[k] ?? '') === null}
            change={(text) => {
              texts.value = texts.value.with(k, text);
            }}
          />
        ))}
      </div>
      <p class="hint">{said.moveHint}</p>
      {to && <Preview cell={cell} zone={zone} to={to} leave={leave} />}
    </fieldset>
  );
}

function placeOfTexts(written: string[], factor: number): Place | null {
  const [x = null, y = null, z = null] = written.map((text) => typed(text));
  return x === null || y === null || z === null ? null : [x / factor, y / factor, z / factor];
}

/** What the service says of a place; `flaws` is null where it could not say anything. */
interface Looked {
  at: string;
  flaws: Flaw[] | null;
}

/** Where a zone would be and what that would mean; then one tap moves it, whatever that is: people are where they are. */
function Preview({ cell, zone, to, leave }: Props & { to: Place; leave: () => void }) {
  const said = words.value.cells;
  const looked = useSignal<Looked | null>(null);
  const at = to.join(' ');
  useEffect(() => {
    const look = async () => {
      const place = at.split(' ').map(Number) as Place;
      const flaws = await checkZone(zone.name, place).catch(nothingSaid);
      looked.value = { at, flaws };
    };
    const timer = window.setTimeout(look, PAUSE_MS);
    return () => window.clearTimeout(timer);
  }, [at, zone.name, looked]);
  const judged = looked.value?.at === at ? looked.value : null;
  return (
    <div class="zone-preview">
      <CellSketch cell={cell} moving={{ zone, to }} />
      <Judgement judged={judged} />
      <div class="ways">
        <Press kind="primary" disabled={judged === null} act={() => moveZone(zone.name, to).then(leave)}>
          {said.move}
        </Press>
        <Press act={leave}>{said.leave}</Press>
      </div>
    </div>
  );
}

function Judgement({ judged }: { judged: Looked | null }) {
  const said = words.value.cells;
  if (judged === null) return <p role="status">{said.looking}</p>;
  if (judged.flaws === null) return <p role="status">{said.notLooked}</p>;
  if (judged.flaws.length === 0) return <p role="status">✓ {said.staysFree}</p>;
  return <FlawList title={said.blocks} flaws={judged.flaws} />;
}

/** Whoever cannot be asked keeps nobody from saying where the people are. */
function nothingSaid(error: unknown): null {
  const unreachable = error instanceof TypeError || error instanceof DOMException;
  if (!unreachable && !(error instanceof Refusal)) throw error;
  return null;
}
