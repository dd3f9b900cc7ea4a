import { useEffect } from 'preact/hooks';
import type { AlarmPublic } from '../api';
import { may } from '../session/session';
import { until } from '../ui/connection';
import { MessageText } from '../ui/message-text';
import { nameOf } from '../ui/names';
import { Press } from '../ui/press';
import { to } from '../ui/route';
import type { Screen } from '../ui/screen';
import { moment } from '../ui/units';
import { words } from '../words';
import { acknowledge, mayHaveEarlier, openAlarms, pastAlarms, readEarlier, readPast } from './alarms';
import { SeverityMark } from './severity-mark';

/** What needs a person, with what to do; below it what there was. */
function Alarms() {
  const said = words.value.alarms;
  const open = openAlarms.value;
  const ids = open?.map(({ id }) => id).join(' ');
  useEffect(() => (ids === undefined ? undefined : until(readPast)), [ids]);
  return (
    <div class="page alarms">
      <h1>{said.title}</h1>
      <section>
        <h2>{said.open}</h2>
        {open?.length === 0 && <p class="empty">{said.none}</p>}
        <ul class="alarm-list">
          {open?.map((alarm) => (
            <Open key={alarm.id} alarm={alarm} />
          ))}
        </ul>
      </section>
      <section>
        <h2>{said.past}</h2>
        {pastAlarms.value?.length === 0 && <p class="empty">{said.noPast}</p>}
        <ul class="alarm-list">
          {pastAlarms.value?.map((alarm) => (
            <Past key={alarm.id} alarm={alarm} />
          ))}
        </ul>
        {mayHaveEarlier.value && <Press act={readEarlier}>{said.earlier}</Press>}
      </section>
    </div>
  );
}

function Open({ alarm }: { alarm: AlarmPublic }) {
  const said = words.value.alarms;
  return (
    <li class="tile alarm" data-kind={alarm.kind}>
      <div class="alarm-head">
        <SeverityMark severity={alarm.severity} />
        <b>{alarm.cell ?? said.service}</b>
        <small>
          {alarm.cleared_at === null
            ? said.since(moment(alarm.raised_at))
            : said.over(moment(alarm.cleared_at))}
        </small>
      </div>
      <p class="alarm-what">
        <MessageText message={alarm.message} />
      </p>
      <p>
        <small>{said.todo}:</small> <MessageText message={alarm.advice} />
      </p>
      <p class="alarm-answers">
        {alarm.run && (
          <a class="press" href={to('runs', alarm.run)}>
            {said.toRun}
          </a>
        )}
        {alarm.acknowledged_by === null && may('operator', 'engineer', 'admin') && (
          <Press act={() => acknowledge(alarm.id)}>{said.acknowledge}</Press>
        )}
        <small>{acknowledgement(alarm)}</small>
      </p>
    </li>
  );
}

function Past({ alarm }: { alarm: AlarmPublic }) {
  const said = words.value.alarms;
  return (
    <li class="alarm alarm-past">
      <b>
        {said.severities[alarm.severity]} · {alarm.cell ?? said.service}
      </b>
      <MessageText message={alarm.message} />
      <small>
        {said.fromTo(moment(alarm.raised_at), moment(alarm.cleared_at ?? alarm.raised_at))}.{' '}
        {acknowledgement(alarm)}
      </small>
    </li>
  );
}

function acknowledgement({ acknowledged_by, acknowledged_at }: AlarmPublic): string {
  const said = words.value.alarms;
  if (acknowledged_by === null || acknowledged_at === null) return said.notAcknowledged;
  return said.acknowledged(nameOf(acknowledged_by), moment(acknowledged_at));
}

export const alarmsScreen: Screen = { Page: Alarms, next: () => words.value.alarms.next };
