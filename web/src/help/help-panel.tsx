import '../look/help.css';
import { useEffect, useRef } from 'preact/hooks';
import { session } from '../session/session';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import { words } from '../words';
import { helpOpen, type Topic, topic } from './help';
import { helpWords } from './help-words';
import { mayTour, startTour } from './tour';

type Term = keyof typeof helpWords.value.terms;

/** Which words stand on a screen, and where the manual tells of it: the page, and its heading. */
const SCREENS: Record<Topic, { terms: Term[]; manual: [string, string] }> = {
  signIn: { terms: ['run', 'stop'], manual: ['console', 'from-signing-in-to-the-result'] },
  setup: {
    terms: ['cell', 'payload', 'payloadBox', 'plan', 'control'],
    manual: ['console', 'from-signing-in-to-the-result'],
  },
  plan: {
    terms: ['plan', 'release', 'start', 'clearance', 'startConfiguration', 'secondOpinion', 'protectedZone'],
    manual: ['plans', ''],
  },
  running: { terms: ['hold', 'resume', 'stop', 'abort', 'guard', 'control'], manual: ['runs', ''] },
  result: {
    terms: ['payload', 'interval', 'determined', 'accept', 'recording'],
    manual: ['console', 'from-signing-in-to-the-result'],
  },
  ended: { terms: ['stop', 'abort', 'clear', 'recording'], manual: ['runs', ''] },
  orders: { terms: ['order', 'run', 'release', 'stop'], manual: ['console', 'orders-and-alarms'] },
  gap: { terms: ['gap', 'effect', 'twin', 'closure', 'tie', 'recording'], manual: ['gap', ''] },
  trials: { terms: ['blindTrial', 'effect', 'gap'], manual: ['console', 'diagnosis'] },
  history: { terms: ['run', 'interval', 'determined', 'accept'], manual: ['console', 'history'] },
  cells: {
    terms: ['cell', 'protectedZone', 'obstacle', 'clearance', 'home'],
    manual: ['console', 'cells'],
  },
  alarms: { terms: ['alarm', 'acknowledge'], manual: ['alarms', ''] },
  control: { terms: ['control', 'handover', 'lease', 'hold'], manual: ['console', 'who-has-control'] },
  settings: { terms: [], manual: ['console', 'settings'] },
  admin: { terms: ['order', 'alarm'], manual: ['console', 'administration'] },
  manual: { terms: [], manual: ['glossary', ''] },
};

/** What this screen is for, what can be done on it, and what the words on it mean. */
export function HelpPanel() {
  const said = helpWords.value;
  const here = topic.value;
  const { terms, manual } = SCREENS[here];
  const { title, what, can } = said.screens[here];
  const heading = useRef<HTMLHeadingElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    heading.current?.focus();
    return () => (before instanceof HTMLElement ? before.focus() : undefined);
  }, []);
  return (
    <aside
      class="help-panel"
      aria-label={words.value.help.open}
      onKeyDown={({ key }) => {
        if (key === 'Escape') shut();
      }}
    >
      <div class="help-head">
        <h2 tabIndex={-1} ref={heading}>
          {title}
        </h2>
        <Press act={shut}>{words.value.close}</Press>
      </div>
      <p>{what}</p>
      <h3>{said.can}</h3>
      <ul>
        {can.map((each) => (
          <li key={each}>{each}</li>
        ))}
      </ul>
      {terms.length > 0 && <Terms terms={terms} />}
      <div class="row">
        {session.value && here !== 'manual' && (
          <a class="download" href={to('manual', ...manual.filter(Boolean))} onClick={shut}>
            {said.manual}
          </a>
        )}
        {session.value && (
          <Press disabled={!mayTour.value} act={startTour}>
            {words.value.help.take}
          </Press>
        )}
      </div>
      {session.value && !mayTour.value && <p class="hint">{said.noTour}</p>}
    </aside>
  );
}

function Terms({ terms }: { terms: Term[] }) {
  const said = helpWords.value;
  return (
    <>
      <h3>{said.words}</h3>
      <dl>
        {terms.map((term) => (
          <div key={term}>
            <dt>{said.terms[term][0]}</dt>
            <dd>{said.terms[term][1]}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}

function shut(): void {
  helpOpen.value = false;
}
