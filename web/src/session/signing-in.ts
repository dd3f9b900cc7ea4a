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

/** Signs in with a password that somebody else knows as well, and puts one's own in its place. */
export async function signInFirst(name: string, given: string, chosen: string): Promise<void> {
  await signIn(name, given);
  await ask('PUT /api/session/password', { body: { password: given, new_password: chosen } });
}

export async function signOut(): Promise<void> {
  await giveControlBack();
  await ask('DELETE /api/session');
  session.value = null;
}
