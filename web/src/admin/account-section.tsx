import { session } from '../session/session';
import { adminWords } from './admin-words';
import { OwnPassword } from './own-password';
import { OwnSessions } from './own-sessions';
import { namesOf } from './roles';

/** What everybody may do with their own account. */
export function AccountSection() {
  const said = adminWords.value.account;
  const own = session.value;
  return (
    <>
      <p>{own && said.who(own.name, namesOf(own.roles))}</p>
      <div class="halves">
        <OwnPassword />
        <OwnSessions />
      </div>
    </>
  );
}
