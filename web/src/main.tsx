import './look/tokens.css';
import './look/frame.css';
import './look/parts.css';
import './look/pages.css';
import './look/gap.css';
import './look/history.css';
import './look/cells.css';
import './look/link.css';
import './look/print.css';
import { render } from 'preact';
import { App } from './app';
import { onReturn } from './stores/connection';
import { followRobots } from './stores/now';
import { session } from './stores/session';
import { resumeSession } from './stores/signing-in';

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
