import type { Message } from '../words/catalogue';
import { MessageText } from './message-text';

interface Props {
  message: Message;
  /** A sentence of this screen that says more, where there is one. */
  said?: string | null;
}

/** What went wrong, or why a run or a job came to nothing. */
export function Told({ message, said = null }: Props) {
  return <p class="told">{said ?? <MessageText message={message} />}</p>;
}
