import type { Message } from '../words/catalogue';
import { quote } from '../words/messages';

/** A part of the motion, such as `transfer x+`, in the words that the engine's messages have for it. */
export function partMessage(part: string): Message {
  const [kind, axis = ''] = part.split(' ');
  const parameters = { axis };
  switch (kind) {
    case 'transfer':
      return { code: 'planning-part-transfer', parameters };
    case 'rotation':
      return { code: 'planning-part-rotation', parameters };
    case 'wave':
      return { code: 'planning-part-wave', parameters };
    case 'home':
      return { code: 'planning-part-home' };
    case 'start':
      return { code: 'planning-part-start' };
    default:
      return quote(part);
  }
}
