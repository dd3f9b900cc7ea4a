import { computed } from '@preact/signals';
import { language } from '../session/settings';
import { JobProgress } from '../ui/job-progress';
import { isUnderWay } from '../ui/jobs';
import { Press } from '../ui/press';
import { Reading } from '../ui/reading';
import { Reserved } from '../ui/reserved';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { words } from '../words';
import { OpenedTrials } from './opened-trials';
import { ScoreSheet } from './score-sheet';
import { cancelTrials, opened, openSeals, trials } from './trials';

const answered = computed(() => trials.value?.opened ?? null);

function Trial() {
  const said = words.value.gap.trials;
  const shown = trials.value;
  if (shown === null) return <Reading />;
  return (
    <div class="page trials">
      <section>
        <h1>
          {said.title}: {said.count(shown.count)}
        </h1>
        <h2>{said.seal}</h2>
        {shown.seals === null && <p>{said.sealFirst}</p>}
        <ol class="seals">
          {shown.seals?.map(({ seed, sha256 }) => (
            <li key={seed}>
              <code>{sha256}</code>
            </li>
          ))}
        </ol>
        {shown.state !== 'done' && <JobProgress title={said.running} job={shown} />}
      </section>
      {answered.value && (
        <OpenedTrials trials={answered.value} seals={shown.seals ?? []} opened={opened.value} />
      )}
      {opened.value && answered.value && (
        <ScoreSheet id={shown.trials} trials={answered.value} language={language.value} />
      )}
    </div>
  );
}

function Actions() {
  const said = words.value.gap.trials;
  const shown = trials.value;
  return (
    <>
      {shown !== null && isUnderWay(shown) && (
        <Reserved roles={['engineer']} act={() => cancelTrials(shown.trials)}>
          {words.value.gap.cancel}
        </Reserved>
      )}
      {answered.value !== null && !opened.value && (
        <Press kind="primary" act={openSeals}>
          {said.openSeal}
        </Press>
      )}
      <Press act={() => go('trials')}>{said.back}</Press>
    </>
  );
}

function next(): string {
  const said = words.value.gap.trials;
  const shown = trials.value;
  if (shown === null || isUnderWay(shown)) return said.waitNext;
  if (answered.value === null) return said.cancelledNext;
  return opened.value ? said.openedNext : said.openNext;
}

export const trialScreen: Screen = { Page: Trial, Actions, next };
