import '../look/help.css';
import { useSignal } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { runs } from '../run/runs';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import { helpWords } from './help-words';
import { endTour, touring } from './tour';

type StepName = keyof typeof helpWords.value.tour.steps;

interface Step {
  name: StepName;
  /** What it is about: the first of these that is to be seen. */
  shows: string[];
  /** The page that it is on; any where there is none. */
  page?: () => string;
}

const STEPS: Step[] = [
  { name: 'frame', shows: ['.header'] },
  { name: 'tool', shows: ['#field-tool'], page: () => to() },
  { name: 'plan', shows: ['.command-bar .actions .press', '.command-bar .next'], page: () => to() },
  { name: 'release', shows: ['.command-bar .next'] },
  { name: 'stop', shows: ['.command-bar'] },
  { name: 'result', shows: ['.result table', '.run-list', 'main h1'], page: pageOfResult },
  { name: 'help', shows: ['.help-button'] },
];
const LOOK_MS = 100;
/** Between what is shown and the frame around it, px. */
const BESIDE_PX = 4;

/** The newest result that there is, else where results are going to be. */
function pageOfResult(): string {
  const complete = runs.peek()?.find(({ state }) => state === 'Complete');
  return complete ? to('runs', complete.run) : to('history');
}

/** One step: what it is about has a frame around it, and a card beside it says what it is for. */
export function Tour() {
  const said = helpWords.value.tour;
  const number = touring.value ?? 0;
  const step = STEPS[number];
  const place = usePlace(step);
  const heading = useRef<HTMLHeadingElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each step is read to who cannot see it
  useEffect(() => heading.current?.focus(), [number]);
  // before the card is painted: a key that is pressed as soon as it is seen counts
  useLayoutEffect(() => {
    const leave = ({ key }: KeyboardEvent) => key === 'Escape' && endTour();
    document.addEventListener('keydown', leave);
    return () => document.removeEventListener('keydown', leave);
  }, []);
  if (step === undefined) return null;
  const last = number === STEPS.length - 1;
  const isLow = place !== null && place.top + place.height / 2 > innerHeight / 2 && place.bottom < barTop();
  return (
    <>
      {place && <Frame place={place} />}
      <section class={isLow ? 'tour-card tour-card-high' : 'tour-card'} aria-label={said.title}>
        <h2 tabIndex={-1} ref={heading} aria-describedby="tour-said">
          {said.count(number + 1, STEPS.length)}
        </h2>
        <p id="tour-said">{said.steps[step.name]}</p>
        <div class="row">
          <Press act={() => go(number, last)}>{last ? said.finish : said.next}</Press>
          <Press disabled={number === 0} act={() => go(number - 2, false)}>
            {said.back}
          </Press>
          {!last && <Press act={endTour}>{said.skip}</Press>}
        </div>
      </section>
    </>
  );
}

function go(from: number, last: boolean): void {
  if (last) endTour();
  else touring.value = from + 1;
}

function Frame({ place }: { place: DOMRect }) {
  const { left, top, width, height } = place;
  const style = {
    left: `${left - BESIDE_PX}px`,
    top: `${top - BESIDE_PX}px`,
    width: `${width + 2 * BESIDE_PX}px`,
    height: `${height + 2 * BESIDE_PX}px`,
  };
  return <div class="tour-frame" style={style} aria-hidden="true" />;
}

/** Where that is what a step shows, wherever it is scrolled to; null while it is not to be seen. */
function usePlace(step: Step | undefined): DOMRect | null {
  const place = useSignal<DOMRect | null>(null);
  useEffect(() => {
    if (step?.page) location.hash = step.page();
    let found: Element | null = null;
    let size = '';
    const look = () => {
      const now = find(step?.shows ?? []);
      const turned = `${innerWidth} ${innerHeight}`;
      if (now !== found || size !== turned) now?.scrollIntoView({ block: 'start' });
      found = now;
      size = turned;
      const seen = now && seenOf(now);
      if (JSON.stringify(seen) !== JSON.stringify(place.value)) place.value = seen;
    };
    look();
    const timer = window.setInterval(look, LOOK_MS);
    return () => window.clearInterval(timer);
  }, [step, place]);
  return place.value;
}

function find(selectors: string[]): Element | null {
  const all = selectors.flatMap((selector) => [...document.querySelectorAll(selector)]);
  return all.find((each) => each.checkVisibility()) ?? null;
}

/** What is to be seen of it: of what stands on the page, no more than the page shows. */
function seenOf(each: Element): DOMRect | null {
  const { left, top, right, bottom } = each.getBoundingClientRect();
  const page = each.closest('main')?.getBoundingClientRect() ?? new DOMRect(0, 0, innerWidth, innerHeight);
  const [high, low] = [Math.max(top, page.top), Math.min(bottom, page.bottom)];
  return low > high ? new DOMRect(left, high, right - left, low - high) : null;
}

const barTop = () => document.querySelector('.command-bar')?.getBoundingClientRect().top ?? innerHeight;
