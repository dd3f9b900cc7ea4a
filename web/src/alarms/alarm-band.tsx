import { may } from '../session/session';
import { Press } from '../ui/press';
import { route, runInRoute, to } from '../ui/route';
import { Told } from '../ui/told';
import { words } from '../words';
import { acknowledge, unseen } from './alarms';

/** The newest alarm that needs somebody now, on every page but those that say it themselves. It goes when it is acknowledged or over. */
export function AlarmBand() {
  const said = words.value.alarms;
  const alarm = unseen.value.find(({ severity }) => severity === 'high');
  if (alarm === undefined || route.value[0] === 'alarms' || (alarm.run && alarm.run === runInRoute.value))
    return null;
  return (
    <div class="notice alarm-band" role="alert">
      <span aria-hidden="true">▲▲</span>
      <Told message={alarm.message} />
      <span class="answers">
        <a class="press" href={to('alarms')}>
          {said.all}
        </a>
        {may('operator', 'engineer', 'admin') && (
          <Press act={() => acknowledge(alarm.id)}>{said.acknowledge}</Press>
        )}
      </span>
    </div>
  );
}
