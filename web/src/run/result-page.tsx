import type { ResultPublic } from '../api';
import { DiagnoseRun } from '../gap/diagnose-run';
import { TwinShare } from '../gap/twin-share';
import { RunBefore } from '../history/run-before';
import { may } from '../session/session';
import { language } from '../session/settings';
import { library } from '../tools/library';
import { SaveTool } from '../tools/save-tool';
import { addressOf } from '../ui/client';
import { Facts } from '../ui/facts';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { go } from '../ui/route';
import type { Screen } from '../ui/screen';
import { clock, moment, number, spelt } from '../ui/units';
import { words } from '../words';
import { Uncertainty } from './budget';
import { CertificateLinks } from './certificate-links';
import { Exports } from './exports';
import { GoodEnough } from './good-enough';
import { ParameterTable } from './parameter-table';
import { ProposedBy } from './proposed-by';
import { resultSentence } from './result-sentence';
import { acceptResult, result as found, run } from './run';
import { RunRecord } from './run-record';
import { TargetMet } from './target-met';
import { Verification } from './verification';
import { Warnings } from './warnings';
import { Workpiece } from './workpiece';

function Result() {
  const said = words.value.result;
  const answer = found.value;
  if (answer === null) return <p class="page">…</p>;
  return (
    <div class="page result">
      <section>
        <h1>{said.title}</h1>
        <p class="hint">{whichRun()}</p>
        <ProposedBy />
        <p class="verdict-words">{resultSentence(answer)}</p>
        <GoodEnough requirement={answer.requirement} />
        <TargetMet target={answer.target} />
        <ParameterTable answer={answer} />
        <p class="hint">
          {words.value.interval}, {said.frame}. {answer.reference?.source}
        </p>
        <Workpiece answer={answer} />
        <Uncertainty answer={answer} />
        <SaveResult answer={answer} />
      </section>
      <aside>
        <Warnings all={answer.warnings} />
        <TwinShare shares={answer.twin} />
        <RunBefore answer={answer} />
        <Verification parts={answer.verification} />
        <Checks />
        {!run.value?.diagnosis && (
          <section class="to-gap">
            <h2>{words.value.gap.title}</h2>
            <DiagnoseRun run={answer.run} label={words.value.gap.diagnoseRun} />
          </section>
        )}
        <h2 class="keep">{said.downloads}</h2>
        <p class="downloads">
          <a class="download" href={addressOf('/api/runs/{run}/recording', { run: answer.run })} download>
            {said.recording}
          </a>
          <a
            class="download"
            href={addressOf('/api/runs/{run}/report', { run: answer.run }, { language: language.value })}
            target="_blank"
            rel="noreferrer"
          >
            {said.report}
          </a>
          <Press act={() => window.print()}>{said.print}</Press>
        </p>
        <CertificateLinks run={answer.run} accepted={(run.value?.accepted_by ?? null) !== null} />
        <Exports run={answer.run} />
        <RunRecord />
      </aside>
    </div>
  );
}

/** The result as a tool for runs to come. */
function SaveResult({ answer }: { answer: ResultPublic }) {
  const { cell, payload } = answer;
  const known = library.value?.find(({ name }) => name === payload);
  const box = run.value?.order.payload_box ?? known?.box;
  if (cell === null || !box) return null;
  const { parameters } = answer.workpiece ? { parameters: answer.workpiece.phi } : answer;
  const whole = !parameters.includes(null);
  return (
    <SaveTool
      label={words.value.result.saveTool}
      begin={() => ({
        cell,
        box,
        mass_kg: whole ? null : (parameters[0] ?? null),
        run: { id: answer.run, whole },
      })}
    />
  );
}

/** What a printed result has to say of itself. */
function whichRun(): string {
  const shown = run.value;
  if (shown === null) return '';
  const accepted =
    shown.accepted_by === null ? [] : [words.value.history.accepted(nameOf(shown.accepted_by))];
  return [
    shown.cell,
    shown.payload,
    moment(shown.ended_at ?? shown.requested_at),
    shown.run,
    ...accepted,
  ].join(' · ');
}

function Checks() {
  const said = words.value.result;
  const { residual, safety, seconds } = found.value ?? {};
  const noises = (first: number) => {
    const ratio = [0, 1, 2].map(
      (k) => (residual?.rms[first + k] ?? 0) / (residual?.noise_std[first + k] ?? 1),
    );
    return said.ofNoise(number(Math.max(...ratio), 1));
  };
  return (
    <section>
      <h2>{said.checks}</h2>
      <Facts
        facts={[
          ...(residual
            ? [
                { name: said.residual, value: noises(0) },
                { name: said.residualTorque, value: noises(3) },
              ]
            : []),
          ...(safety
            ? [
                {
                  name: said.smallest,
                  value:
                    safety.min_distance_m === null
                      ? words.value.unknown
                      : spelt('length', safety.min_distance_m),
                  note: safety.nearest,
                },
                { name: said.fastest, value: spelt('speed', safety.max_speed_m_s) },
                { name: said.restarts, value: String(safety.restarts) },
              ]
            : []),
          { name: said.robotTime, value: clock(seconds?.robot ?? 0) },
        ]}
      />
    </section>
  );
}

/** After the motion that a diagnosis proposed comes the diagnosis of both; after a run, its acceptance. */
function Actions() {
  const said = words.value.result;
  const shown = run.value;
  if (shown === null) return null;
  const continued = shown.diagnosis !== null;
  return (
    <>
      {continued && <DiagnoseRun kind="primary" run={shown.run} label={words.value.gap.diagnoseBoth} />}
      {shown.accepted_by === null && may('operator') ? (
        <Press kind={continued ? 'plain' : 'primary'} act={() => acceptResult(shown.run)}>
          <span aria-hidden="true">✓</span> {said.accept}
        </Press>
      ) : (
        <Press kind={continued ? 'plain' : 'primary'} act={() => go()}>
          {said.again}
        </Press>
      )}
    </>
  );
}

function next(): string {
  const said = words.value.result;
  if (run.value?.diagnosis) return words.value.gap.bothNext;
  const accepted = run.value?.accepted_by ?? null;
  return accepted === null ? said.next : said.acceptedNext(nameOf(accepted));
}

export const result: Screen = { Page: Result, Actions, next };
