import './look/tokens.css';
import './look/frame.css';
import './look/parts.css';
import './look/pages.css';
import './look/view.css';
import './look/gap.css';
import './look/history.css';
import './look/cells.css';
import './look/link.css';
import './look/control.css';
import './look/orders.css';
import './look/print.css';
import { wordsLoaded } from './words';

await wordsLoaded;
await import('./start');
