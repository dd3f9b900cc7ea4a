import type { ComponentProps } from 'preact';
import type { Role } from '../api';
import { may } from '../session/session';
import { words } from '../words';
import { Press } from './press';

interface Props extends ComponentProps<typeof Press> {
  /** Who may press it. */
  roles: Role[];
}

/** A button that only some may press; before others it stands disabled, and says who may. */
export function Reserved({ roles, disabled = false, ...press }: Props) {
  const said = words.value.gap;
  const allowed = may(...roles);
  return (
    <span class="reserved">
      <Press {...press} disabled={disabled || !allowed} />
      {!allowed && (
        <small>{said.only(roles.map((role) => words.value.roles[role]).join(` ${said.or} `))}</small>
      )}
    </span>
  );
}
