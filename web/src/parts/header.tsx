import { cell } from '../stores/cells';
import { connected } from '../stores/connection';
import { control, holder, mine } from '../stores/control';
import { following } from '../stores/live';
import { current } from '../stores/run';
import { session } from '../stores/session';
import { words } from '../words';
import { StateMark } from './state-mark';

/** Where this is, who moves the robot, what it does, whether the line is up: on every page. */
export function Header() {
  const said = words.value.header;
  const up = connected.value && following.value;
  return (
    <header class="header">
      <div class="where">
        <small>{said.cell}</small>
        <b>{cell.value?.name ?? '–'}</b>
        <small class="not-safety">{words.value.notSafety}</small>
      </div>
      <div class="doing" role="status">
        <small>{up ? (current.value?.state ?? said.state) : said.lastKnown}</small>
        {current.value ? (
          <StateMark state={current.value.state} />
        ) : (
          <b>{up ? said.robotStands : words.value.unknown}</b>
        )}
      </div>
      <div class={mine.value ? 'who who-mine' : 'who'}>
        <small>{said.control}</small>
        <b>{up ? whoHasControl() : words.value.unknown}</b>
      </div>
      <div class={up ? 'line' : 'line line-lost'} role="status">
        <small>{said.line}</small>
        <b>
          <span aria-hidden="true">{up ? '●' : '✕'}</span> {up ? said.connected : said.lost}
        </b>
      </div>
    </header>
  );
}

function whoHasControl(): string {
  const said = words.value.header;
  if (mine.value) return said.you;
  if (control.value === null || holder.value === null) return said.nobody;
  return holder.value === session.value?.name ? said.elsewhere : said.other(holder.value);
}
