import { Bell } from '../alarms/bell';
import { cell } from '../cells/cells';
import { HelpButton } from '../help/help-button';
import { control, holder, mine } from '../run/control';
import { following } from '../run/live';
import { robots } from '../run/now';
import { current } from '../run/run';
import { runs } from '../run/runs';
import { session } from '../session/session';
import { words } from '../words';
import { lost } from './connection';
import { to } from './route';
import { StateMark } from './state-mark';
import { timeOfDay } from './units';

/** Where this is, what the robot does, who moves it, whether there is a connection: on every page. */
export function Header() {
  const said = words.value.header;
  const signedIn = session.value !== null;
  return (
    <header class="header">
      <div class="where">
        <small>{said.cell}</small>
        <b>{(signedIn && cell.value?.name) || '–'}</b>
        <small class="not-safety">{words.value.notSafety}</small>
      </div>
      <div
        class={signedIn ? 'doing' : 'doing doing-all'}
        role="status"
        data-run={signedIn ? current.value?.run : undefined}
      >
        {signedIn ? <Doing /> : <DoingAnywhere />}
      </div>
      {signedIn && (
        <a class={mine.value ? 'who who-mine' : 'who'} href={to('control')}>
          <small>{said.control}</small>
          <b>{lost.value ? words.value.unknown : whoHasControl()}</b>
          {!lost.value && <small>{sinceWhen()}</small>}
        </a>
      )}
      <Line />
      {signedIn && <Bell />}
      <HelpButton />
    </header>
  );
}

/** What the chosen cell's robot does. */
function Doing() {
  const said = words.value.header;
  const run = current.value;
  if (run !== null) {
    return (
      <>
        <small>{lost.value ? said.lastKnown : run.state}</small>
        <StateMark state={run.state} />
      </>
    );
  }
  return (
    <>
      <small>{said.state}</small>
      <b>{lost.value || runs.value === null ? words.value.unknown : said.robotStands}</b>
    </>
  );
}

/** Who is not signed in sees whether any robot is under way; more is not known of those that no run has. */
function DoingAnywhere() {
  const count = robots.value?.length ?? null;
  const { now, header, unknown } = words.value;
  return (
    <>
      <small>{header.state}</small>
      <b>{lost.value || count === null ? unknown : count === 0 ? now.none : now.runs(count)}</b>
    </>
  );
}

function Line() {
  const said = words.value.header;
  const up = !lost.value && following.value;
  return (
    <div class={up ? 'line' : 'line line-lost'} role="status">
      <small>{said.line}</small>
      <b>
        <span aria-hidden="true">{up ? '●' : '✕'}</span>{' '}
        {up ? said.online : lost.value ? said.offline : said.noLive}
      </b>
    </div>
  );
}

/** Since when, and on which screen where that is not this one. */
function sinceWhen(): string {
  const said = words.value.handover;
  const known = control.value;
  if (known?.since == null) return '';
  const since = said.sinceTime(timeOfDay(Date.parse(known.since)));
  return mine.value || !known.device ? since : `${known.device}, ${since}`;
}

function whoHasControl(): string {
  const said = words.value.header;
  if (mine.value) return said.you;
  if (control.value === null) return words.value.unknown;
  if (holder.value === null) return said.nobody;
  return holder.value === session.value?.name ? said.elsewhere : said.other(holder.value);
}
