import type { Role } from '../api';
import { adminWords } from './admin-words';

export const ROLES: Role[] = ['operator', 'engineer', 'admin', 'viewer', 'mes'];

/** Roles in the order in which they are always told. */
export function namesOf(roles: Role[]): string {
  return ROLES.filter((role) => roles.includes(role))
    .map((role) => adminWords.value.roleNames[role])
    .join(', ');
}

/** Several roles, each with what it may do. */
export function RoleChoice({ chosen, choose }: { chosen: Role[]; choose: (roles: Role[]) => void }) {
  const said = adminWords.value;
  const toggled = (role: Role) =>
    choose(chosen.includes(role) ? chosen.filter((each) => each !== role) : [...chosen, role]);
  return (
    <fieldset class="choice">
      <legend>{said.people.roles}</legend>
      <div class="options">
        {ROLES.map((role) => (
          <label class="option" key={role}>
            <input type="checkbox" checked={chosen.includes(role)} onChange={() => toggled(role)} />
            <span>
              <b>{said.roleNames[role]}</b>
              <small>{said.roleNotes[role]}</small>
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
