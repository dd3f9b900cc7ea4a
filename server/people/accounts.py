"""People and machines: accounts with passwords, the browsers they are signed in with, and keys for machines.

What opens a door is never stored: passwords as argon2id, tokens and keys as SHA-256 (they are random, so a fast hash is enough).
"""

from __future__ import annotations

import hashlib
import secrets
from datetime import datetime, timedelta

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerifyMismatchError
from sqlalchemy import ForeignKey, String, delete, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from server.http.errors import Conflict, NotFound, Unprocessable
from server.people.roles import MACHINE_ROLES, Role, name_roles
from server.store.store import Table

KEY_PREFIX = 12  # characters of a key that are stored and shown, "heft_" among them
SESSION_ID = 16  # characters of a token's hash that name its session

hasher = PasswordHasher()
_NOBODY = "$argon2id$v=19$m=65536,t=3,p=4$AAAAAAAAAAAAAAAAAAAAAA$AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"


class Account(Table):
    """Somebody who signs in."""

    __tablename__ = "accounts"

    name: Mapped[str] = mapped_column(String(64), primary_key=True)
    password_hash: Mapped[str] = mapped_column(String(256))
    roles_text: Mapped[str] = mapped_column("roles", String(128))
    disabled: Mapped[bool] = mapped_column(default=False)
    created_at: Mapped[datetime]

    @property
    def roles(self) -> frozenset[Role]:
        """What the account may be."""
        return frozenset(Role(word) for word in self.roles_text.split())


class SignIn(Table):
    """A browser that somebody is signed in with."""

    __tablename__ = "sessions"

    token_hash: Mapped[str] = mapped_column(String(64), primary_key=True)
    account: Mapped[str] = mapped_column(ForeignKey("accounts.name", ondelete="CASCADE"), index=True)
    csrf_token: Mapped[str] = mapped_column(String(64))
    address: Mapped[str] = mapped_column(String(64))
    browser: Mapped[str | None] = mapped_column(String(200))
    """As it names itself; None where it does not."""
    created_at: Mapped[datetime]
    used_at: Mapped[datetime]

    @property
    def id(self) -> str:
        """What names the session where it is listed and ended; it opens nothing."""
        return self.token_hash[:SESSION_ID]


class ApiKey(Table):
    """What a machine shows instead of a password."""

    __tablename__ = "api_keys"

    prefix: Mapped[str] = mapped_column(String(16), primary_key=True)
    name: Mapped[str] = mapped_column(String(64), unique=True)
    key_hash: Mapped[str] = mapped_column(String(64), unique=True)
    role: Mapped[str] = mapped_column(String(16))
    created_by: Mapped[str] = mapped_column(String(80))
    created_at: Mapped[datetime]
    expires_at: Mapped[datetime | None]
    used_at: Mapped[datetime | None]


def sha256(secret: str) -> str:
    """Hex digest under which a token or a key is kept."""
    return hashlib.sha256(secret.encode()).hexdigest()


def add_account(db: Session, name: str, password_hash: str, roles: frozenset[Role], now: datetime) -> Account:
    """Adds somebody, with a password that is `hashed` already.

    Raises:
        Conflict: the name is taken.
    """
    if db.get(Account, name) is not None:
        raise Conflict("people-account-exists", account=name)
    account = Account(name=name, password_hash=password_hash, roles_text=" ".join(sorted(roles)), disabled=False, created_at=now)
    db.add(account)
    return account


def update_account(
    db: Session,
    name: str,
    *,
    password_hash: str | None = None,
    roles: frozenset[Role] | None = None,
    disabled: bool | None = None,
    staying: str | None = None,
) -> Account:
    """Changes what is given and signs the account out everywhere.

    Args:
        staying: hash of the token of the one session that does not end.

    Raises:
        NotFound: there is no such account.
        Conflict: no admin would be left who can sign in.
    """
    account = db.get(Account, name)
    if account is None:
        raise NotFound("people-account-unknown", account=name)
    was_admin = Role.admin in account.roles and not account.disabled
    account.password_hash = password_hash or account.password_hash
    account.roles_text = account.roles_text if roles is None else " ".join(sorted(roles))
    account.disabled = account.disabled if disabled is None else disabled
    if was_admin and not any(Role.admin in each.roles and not each.disabled for each in db.scalars(select(Account))):
        raise Conflict("people-last-admin", account=name)
    end_sessions(db, name, staying)
    return account


def hash_password(password: str) -> str:
    """The password as argon2id."""
    return hasher.hash(password)


def password_is_right(account: Account | None, password: str) -> bool:
    """Takes as long for an account that does not exist."""
    try:
        right = hasher.verify(_NOBODY if account is None else account.password_hash, password)
    except (VerifyMismatchError, InvalidHashError):
        return False
    return right and account is not None and not account.disabled


def open_session(db: Session, account: Account, address: str, now: datetime, browser: str | None = None) -> tuple[str, SignIn]:
    """Signs a browser in; the token goes into its cookie and nowhere else."""
    token = secrets.token_urlsafe(32)
    row = SignIn(
        token_hash=sha256(token),
        account=account.name,
        csrf_token=secrets.token_urlsafe(24),
        address=address,
        browser=None if browser is None else browser[:200],
        created_at=now,
        used_at=now,
    )
    db.add(row)
    return token, row


def list_sessions(db: Session, created_after: datetime, used_after: datetime) -> list[SignIn]:
    """The browsers that anybody is signed in with, the one used last first."""
    lasting = (SignIn.created_at > created_after) & (SignIn.used_at > used_after)
    return list(db.scalars(select(SignIn).where(lasting).order_by(SignIn.used_at.desc(), SignIn.token_hash)))


def end_session(db: Session, account: str, session: str) -> None:
    """Signs out one browser of somebody's.

    Raises:
        NotFound: they have no such session.
    """
    row = next((each for each in db.scalars(select(SignIn).where(SignIn.account == account)) if each.id == session), None)
    if row is None:
        raise NotFound("people-session-unknown", session=session[:80])
    db.delete(row)


def end_sessions(db: Session, account: str, staying: str | None = None) -> None:
    """Signs somebody out everywhere, but for the session whose token has the hash `staying`."""
    db.execute(delete(SignIn).where(SignIn.account == account, SignIn.token_hash != (staying or "")))


def sweep_sessions(db: Session, created_before: datetime, used_before: datetime) -> None:
    """Forgets what has expired."""
    db.execute(delete(SignIn).where((SignIn.created_at < created_before) | (SignIn.used_at < used_before)))


def add_key(db: Session, name: str, role: Role, created_by: str, now: datetime, days: float | None) -> tuple[str, ApiKey]:
    """Makes a machine's key; it is shown once.

    Raises:
        Conflict: the name is taken.
        Unprocessable: the role is not one that a machine may have.
    """
    if role not in MACHINE_ROLES:
        raise Unprocessable("people-role-not-for-machines", role=role.value, roles=name_roles(MACHINE_ROLES))
    if db.scalar(select(ApiKey).where(ApiKey.name == name)) is not None:
        raise Conflict("people-key-exists", key=name)
    key = f"heft_{secrets.token_urlsafe(32)}"
    row = ApiKey(
        prefix=key[:KEY_PREFIX],
        name=name,
        key_hash=sha256(key),
        role=role.value,
        created_by=created_by,
        created_at=now,
        expires_at=None if days is None else now + timedelta(days=days),
    )
    db.add(row)
    return key, row


def delete_key(db: Session, name: str) -> None:
    """Makes a key worthless.

    Raises:
        NotFound: there is no such key.
    """
    row = db.scalar(select(ApiKey).where(ApiKey.name == name))
    if row is None:
        raise NotFound("people-key-unknown", key=name)
    db.delete(row)
