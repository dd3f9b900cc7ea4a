import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Flaw } from '../api';
import { robots } from '../run/now';
import { FlawList } from '../ui/flaw-list';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { Refusal } from '../ui/refusal';
import { words } from '../words';
import type { Cell } from './cells';
import { onlyMoved } from './shapes';
import { checkZone, saveZone } from './shown-cell';
import { changed, type Draft, drop, rename, stepBack } from './zone-draft';
import { ZoneFields } from './zone-fields';
import { zoneWords } from './zone-words';

/** How long nothing changes before the service is asked what it thinks of it. */
const PAUSE_MS = 300;
const NAME = /^[A-Za-z0-9_-]{1,64}$/;

/** What the service says of a zone as it is drawn; `flaws` is null where it could not say anything. */
interface Looked {
  at: string;
  flaws: Flaw[] | null;
}

/** The zone that is being changed: its numbers, what speaks against it, what saving it means. */
export function ZoneChanging({ cell, now }: { cell: Cell; now: Draft }) {
  const said = zoneWords.value;
  const flaw = flawOfName(cell, now);
  const judged = useJudgement(now, flaw === null && changed.value);
  const moves = now.original !== null && onlyMoved(now.original.shape, now.shape);
  const refused = !moves && (judged?.flaws?.length ?? 0) > 0;
  const save = async () => {
    await saveZone(now);
    drop();
    say(() => zoneWords.value.saved(now.name), 'passes');
  };
  return (
    <section class="tile zone-changing">
      <h3>{now.original ? said.changing(now.name) : said.fresh}</h3>
      {now.original === null && <NameField name={now.name} flaw={flaw} />}
      <ZoneFields shape={now.shape} />
      {changed.value && flaw === null && <Judgement judged={judged} refused={refused} />}
      {changed.value && <p class="hint">{said.means[whatItMeans(cell.name)]}</p>}
      <div class="ways">
        <Press
          kind="primary"
          disabled={!changed.value || flaw !== null || judged === null || refused}
          act={save}
        >
          {moves ? said.savedMove : said.save}
        </Press>
        <Press disabled={now.past.length === 0} act={stepBack}>
          <span aria-hidden="true">↶</span> {said.back}
        </Press>
        <Press act={drop}>{said.discard}</Press>
      </div>
    </section>
  );
}

function NameField({ name, flaw }: { name: string; flaw: string | null }) {
  return (
    <label class="field">
      <span>{zoneWords.value.name}</span>
      <input
        value={name}
        autocapitalize="off"
        aria-invalid={flaw !== null}
        onInput={({ currentTarget }) => rename(currentTarget.value)}
      />
      {flaw && <small class="hint flaw">{flaw}</small>}
    </label>
  );
}

function Judgement({ judged, refused }: { judged: Looked | null; refused: boolean }) {
  const said = zoneWords.value;
  const { notLooked, staysFree, blocks } = words.value.cells;
  if (judged === null) return <p role="status">{said.waits}</p>;
  if (judged.flaws === null) return <p role="status">{notLooked}</p>;
  if (judged.flaws.length === 0) return <p role="status">✓ {staysFree}</p>;
  return <FlawList title={refused ? said.refused : blocks} flaws={judged.flaws} />;
}

/** What the service says of the draft as it is now; null until it has. */
function useJudgement(now: Draft, asks: boolean): Looked | null {
  const looked = useSignal<Looked | null>(null);
  const at = JSON.stringify([now.name, now.original === null, now.shape]);
  useEffect(() => {
    if (!asks) return undefined;
    const look = async () => {
      looked.value = { at, flaws: await checkZone(now).catch(nothingSaid) };
    };
    const timer = window.setTimeout(look, PAUSE_MS);
    return () => window.clearTimeout(timer);
  }, [at, asks, now, looked]);
  return looked.value?.at === at ? looked.value : null;
}

/** Whoever cannot be asked keeps nobody from saying where the people are. */
function nothingSaid(error: unknown): null {
  const unreachable = error instanceof TypeError || error instanceof DOMException;
  if (!unreachable && !(error instanceof Refusal)) throw error;
  return null;
}

function flawOfName(cell: Cell, now: Draft): string | null {
  if (now.original !== null) return null;
  if (!NAME.test(now.name)) return zoneWords.value.badName;
  const taken = [...(cell.zones ?? []), ...(cell.obstacles ?? [])].some(({ name }) => name === now.name);
  return taken ? zoneWords.value.takenName : null;
}

/** Of which kind the consequence for plans and the robot is. */
function whatItMeans(cell: string): 'free' | 'planned' | 'moving' {
  const robot = robots.value?.find((each) => each.cell === cell);
  if (robot === undefined) return 'free';
  return robot.state === 'Resetting' || robot.state === 'Idle' ? 'planned' : 'moving';
}
