import { giveControlBack } from '../run/control';
import { ask } from '../ui/client';
import { session } from './session';

/** Takes up the session that the browser's cookie stands for. */
export async function resumeSession(): Promise<void> {
  session.value = await ask('GET /api/session');
}

export async function signIn(name: string, password: string): Promise<void> {
  session.value = await ask('POST /api/session', { body: { name, password } });
}

export async function signOut(): Promise<void> {
  await giveControlBack();
  await ask('DELETE /api/session');
  session.value = null;
}
