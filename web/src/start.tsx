import { render } from 'preact';
import { App } from './app';
import { followRobots } from './run/now';
import { session } from './session/session';
import { resumeSession } from './session/signing-in';
import { onReturn } from './ui/connection';

const place = document.getElementById('console');
if (place === null) throw new Error('index.html has no element "console"');

followRobots();
onReturn(async () => {
  if (session.value === null) await resumeSession();
});
render(<App />, place);
resumeSession().catch(() => {
  session.value ??= null;
});
