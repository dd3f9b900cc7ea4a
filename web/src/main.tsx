import './look/tokens.css';
import './look/frame.css';
import './look/parts.css';
import './look/pages.css';
import './look/gap.css';
import './look/history.css';
import './look/cells.css';
import './look/print.css';
import { render } from 'preact';
import { App } from './app';
import { session } from './stores/session';
import { resumeSession } from './stores/signing-in';

const place = document.getElementById('console');
if (place === null) throw new Error('index.html has no element "console"');

resumeSession()
  .catch(() => {
    session.value ??= null;
  })
  .finally(() => render(<App />, place));
