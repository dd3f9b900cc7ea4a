import type { OpenedTrial, Seal } from '../api';
import { effectName, inWords } from '../gap/effect-values';
import { MessageText } from '../ui/message-text';
import { number, percent } from '../ui/units';
import { words } from '../words';
import { SealCheck } from './seal-check';

interface Props {
  trials: OpenedTrial[];
  seals: Seal[];
  opened: boolean;
}

/** What the diagnosis says of each trial; beside it, once the seal is open, what was planted. */
export function OpenedTrials({ trials, seals, opened }: Props) {
  const said = words.value.gap.trials;
  return (
    <section class="opened-trials">
      {trials.map((trial) => (
        <article key={trial.seed}>
          <div>
            <h2>{said.says}</h2>
            <Said trial={trial} />
          </div>
          <div>
            <h2>{said.planted}</h2>
            {opened ? (
              <Planted trial={trial} seal={seals.find(({ seed }) => seed === trial.seed)?.sha256 ?? ''} />
            ) : (
              <p>{said.sealed}</p>
            )}
          </div>
        </article>
      ))}
    </section>
  );
}

function Said({ trial }: { trial: OpenedTrial }) {
  const said = words.value.gap;
  const { effects, also = [], none_probability, unknown_probability, gap_before, gap_after } = trial;
  const [best] = effects;
  const most = [
    ...(best ? [{ name: effectName(best.id), probability: best.probability }] : []),
    { name: said.noGap, probability: none_probability },
    { name: said.unknownEffect, probability: unknown_probability },
  ].sort((one, other) => other.probability - one.probability);
  return (
    <>
      <ul class="plain">
        {most.map(({ name, probability }, k) => (
          <li key={name}>
            {k === 0 ? <b>{name}</b> : name} {percent(probability)} <small>{inWords(probability)}</small>
          </li>
        ))}
      </ul>
      {also.length > 0 && (
        <p>
          {said.also}: <b>{also.map(effectName).join(', ')}</b>
        </p>
      )}
      {gap_before !== null && gap_after !== null && (
        <p>
          {said.gap}: {number(gap_before, 2)} → {number(gap_after, 2)}
        </p>
      )}
    </>
  );
}

function Planted({ trial, seal }: { trial: OpenedTrial; seal: string }) {
  const said = words.value.gap.trials;
  const { ids } = JSON.parse(trial.sealed) as { ids: string[] };
  return (
    <>
      <p>
        <b>{ids.length > 0 ? effectName(ids.join('+')) : said.nothing}</b>
      </p>
      {ids.length > 0 && (
        <p>
          <MessageText message={trial.planted} />; {said.size(number(trial.size, 1))}
        </p>
      )}
      <p>
        {said.mark}:{' '}
        <b>
          <MessageText message={trial.mark} />
        </b>
      </p>
      <SealCheck sealed={trial.sealed} seal={seal} />
    </>
  );
}
