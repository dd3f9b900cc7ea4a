import type { Message } from '../words/catalogue';
import { isEnglish, say } from '../words/messages';

/** A message of the engine or the service in the chosen language; marked as English where there are no other words for it. */
export function MessageText({ message }: { message: Message }) {
  return <span lang={isEnglish(message) ? 'en' : undefined}>{say(message)}</span>;
}
