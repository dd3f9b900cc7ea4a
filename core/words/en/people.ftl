# The words for roles, for other messages.
people-role = { $role }

people-account-unknown = account: there is none called "{ $account }". List what there is and ask again.
people-account-exists = account "{ $account }" exists already; choose another name or change that one
people-last-admin = account "{ $account }" is the last admin who can sign in; make another one first
people-session-unknown = session: you have none called "{ $session }". List what there is and ask again.
people-key-unknown = key: there is none called "{ $key }". List what there is and ask again.
people-key-exists = key "{ $key }" exists already; revoke it or choose another name
people-role-not-for-machines = role: found { people-role }, expected one of { $roles }: a machine neither releases motion nor makes accounts

# Signing in.
people-key-refused = key: unknown, expired or revoked; ask whoever keeps the accounts for a new one
people-session-over = session: ended or expired; sign in again
people-sign-in-refused = name or password: not right; try again or ask whoever keeps the accounts
people-sign-in-blocked = sign-in: too many failures of late; try again in { FIXED($retry_after_s, digits: 0) } s
people-password-wrong = password: not the one until now
people-key-without-password = password: a key has none; only an account changes its password
people-not-signed-in = { $endpoint }: sign in with POST /api/session, or send a key as `Authorization: Bearer`

# Who may do what, and from where.
people-endpoint-closed = { $endpoint }: not in the table of authority, so nobody may call it
people-role-lacking = { $endpoint }: { PERSON($who) } is { $roles }; it takes one of { $needed }
people-without-role = { $endpoint }: { PERSON($who) } has no role; it takes one of { $needed }
people-origin-foreign = origin: "{ $origin }" is no page of this service; set HEFT_ORIGINS if it is to be one
people-origin-missing = origin: a browser's websocket has to say which page it belongs to
people-csrf-token-wrong = { $header }: not the session's; GET /api/session tells it

# The audit log.
people-audit-log = audit log
people-audit-unbroken = audit log: { $entries } entries, unbroken; the last hash is { $hash }
people-audit-entry-missing =
    .found = entry { $number } is missing; the next is { $next_number }
    .expected = an unbroken chain; restore the database from a backup and find out who had access to it
people-audit-entry-unlinked =
    .found = entry { $number } does not follow entry { $last_number }: the hash of the one before it differs
    .expected = an unbroken chain; restore the database from a backup and find out who had access to it
people-audit-entry-changed =
    .found = entry { $number } ({ $action }) was changed: its hash does not fit what it says
    .expected = an unbroken chain; restore the database from a backup and find out who had access to it
people-audit-hash-missing =
    .found = { $entries } entries, none with the hash { $hash }
    .expected = that entry; the log's end was cut off or replaced
