import { computed, signal } from '@preact/signals';
import type { Role, SessionPublic } from '../api';

/** Who is signed in: null is nobody, undefined not known yet. */
export const session = signal<SessionPublic | null | undefined>(undefined);
export const csrfToken = computed(() => session.value?.csrf_token ?? null);

/** Whether the account has one of these roles. */
export function may(...roles: Role[]): boolean {
  return roles.some((role) => session.value?.roles.includes(role));
}
