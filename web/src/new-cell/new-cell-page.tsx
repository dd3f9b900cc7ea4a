import '../look/new-cell.css';
import { useEffect, useRef } from 'preact/hooks';
import { may } from '../session/session';
import { AskFirst } from '../ui/ask-first';
import { say } from '../ui/notice';
import { Press } from '../ui/press';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { ArmStep } from './arm-step';
import { CheckStep } from './check-step';
import { DescriptionStep } from './description-step';
import {
  description,
  discard,
  draft,
  edits,
  frames,
  goBack,
  goOn,
  hasUnread,
  importDraft,
  isOpen,
  isTaken,
  made,
  outline,
  picture,
  STEPS,
  type Step,
  step,
  working,
} from './draft';
import { lackOfFrames } from './frames';
import { JointsStep } from './joints-step';
import { newCellWords } from './new-cell-words';
import { RefusedHere } from './said';
import { HomeStep, RoomStep, SensorStep } from './value-steps';
import { lacksSensorName } from './values';

const PAGES: Record<Step, () => preact.JSX.Element | null> = {
  description: DescriptionStep,
  arm: ArmStep,
  joints: JointsStep,
  home: HomeStep,
  sensor: SensorStep,
  room: RoomStep,
  check: CheckStep,
};

/** A cell made from a robot's description: a question after the other, with a picture and what is doubtful. */
function NewCell() {
  const said = newCellWords.value;
  const Here = PAGES[step.value];
  const top = useRef<HTMLHeadingElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each step begins at its top
  useEffect(() => top.current?.scrollIntoView(), [step.value]);
  return (
    <div class="page new-cell">
      <h1 ref={top}>{said.title}</h1>
      <Steps />
      <div class="new-cell-parts">
        <section class="stack">
          <h2>{said.steps[step.value]}</h2>
          <RefusedHere />
          <Here />
          {draft.value && (
            <div>
              <AskFirst label={said.discard} question={said.discardAsk} yes={said.discardYes} act={discard} />
            </div>
          )}
        </section>
        {step.value !== 'description' && <Picture />}
      </div>
    </div>
  );
}

function Closed() {
  const said = newCellWords.value;
  return (
    <div class="page">
      <h1>{said.title}</h1>
      <p>{said.closed}</p>
    </div>
  );
}

function Steps() {
  const said = newCellWords.value;
  return (
    <ol class="steps" aria-label={said.title}>
      {STEPS.map((each, k) => (
        <li key={each}>
          <button
            type="button"
            class="press press-plain"
            aria-current={each === step.value ? 'step' : undefined}
            disabled={!isOpen(each) || working.value}
            onClick={() => {
              step.value = each;
            }}
          >
            {k + 1} {said.steps[each]}
          </button>
        </li>
      ))}
    </ol>
  );
}

function Picture() {
  const said = newCellWords.value;
  const shown = picture.value;
  return (
    <figure class="home-picture">
      {shown ? <img src={shown} alt={said.picture} /> : <p class="hint">{said.noPicture}</p>}
      {working.value && <p role="status">{said.working}</p>}
    </figure>
  );
}

/** What keeps this step from being left; null where nothing does. */
function lack(): string | null {
  const said = newCellWords.value;
  if (working.value) return step.value === 'description' ? null : said.working;
  if (step.value === 'description') return description.value.file ? null : said.next.description;
  const [arm, robot] = [frames.value, outline.value];
  const lacking = arm && robot && lackOfFrames(arm, robot);
  if (lacking === 'name') return said.arm.badName;
  if (arm && isTaken(arm.name)) return said.arm.taken;
  if (lacking === 'behind') return said.arm.lackBehind;
  if (lacking || hasUnread.value) return said.badNumber;
  return lacksSensorName(edits.value, made.value) ? said.sensor.lackName : null;
}

function Actions() {
  const said = newCellWords.value;
  if (!may('engineer')) return null;
  const last = step.value === 'check';
  return (
    <>
      {step.value !== 'description' && (
        <Press disabled={working.value} act={goBack}>
          {said.back}
        </Press>
      )}
      <Press kind="primary" disabled={lack() !== null || working.value} act={last ? finish : goOn}>
        {last ? said.import : said.forth}
      </Press>
    </>
  );
}

async function finish(): Promise<void> {
  const name = await importDraft();
  if (name === null) return;
  say(() => newCellWords.value.check.imported(name), 'passes');
  go('cells', name);
}

const page: Screen = {
  Page: () => (may('engineer') ? <NewCell /> : <Closed />),
  Actions,
  next: () => (may('engineer') ? (lack() ?? newCellWords.value.next[step.value]) : newCellWords.value.closed),
};

export const newCellScreen = (): Screen => page;
