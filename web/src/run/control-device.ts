import { kept } from '../ui/kept';

/** As many letters as the service takes. */
export const LONGEST = 40;

/** What others call this screen; kept by the browser. */
export const device = kept<string>('device', usual(), (text): text is string => text.length <= LONGEST);

/** A name until somebody gives it a better one: what it is, in words of every language, and a number that tells it from others. */
function usual(): string {
  const touch = navigator.maxTouchPoints > 0;
  const small = Math.min(screen.width, screen.height) < 600;
  const kind = touch ? (small ? 'Smartphone' : 'Tablet') : 'PC';
  return `${kind} ${Math.floor(10 + 90 * Math.random())}`;
}
