"""Guessing passwords gets slow: failures are counted in the store, per account at an address, per address, and per account.

The count of an account alone only slows down, at most by a minute: nobody can lock an operator out of the cell from elsewhere.
"""

from __future__ import annotations

from dataclasses import dataclass
from datetime import datetime, timedelta

from sqlalchemy import String, delete
from sqlalchemy.orm import Mapped, Session, mapped_column

from server.http.errors import TooMany
from server.store.store import Table

FORGET = timedelta(hours=1)  # after the last failure


class LoginFailures(Table):
    """How often a sign-in failed of late."""

    __tablename__ = "login_failures"

    key: Mapped[str] = mapped_column(String(160), primary_key=True)
    count: Mapped[int]
    last_at: Mapped[datetime]
    blocked_until: Mapped[datetime]


@dataclass(frozen=True)
class Limit:
    """So many failures are free; each one more doubles the wait, up to the longest."""

    free: int
    longest: timedelta

    def wait(self, failures: int) -> timedelta:
        """How long nobody is let in after so many failures."""
        excess = failures - self.free
        return timedelta(0) if excess < 0 else min(self.longest, timedelta(seconds=2.0 ** min(excess, 20)))


LIMITS = {"pair": Limit(4, timedelta(minutes=15)), "address": Limit(20, timedelta(minutes=15)), "account": Limit(50, timedelta(minutes=1))}


def _keys(account: str, address: str) -> dict[str, str]:
    return {"pair": f"pair:{account}@{address}", "address": f"address:{address}", "account": f"account:{account}"}


def check_limit(db: Session, account: str, address: str, now: datetime) -> None:
    """Raises TooMany while one of the three counts blocks."""
    for key in _keys(account, address).values():
        row = db.get(LoginFailures, key)
        if row is not None and row.blocked_until > now:
            seconds = (row.blocked_until - now).total_seconds()
            raise TooMany("people-sign-in-blocked", retry_after_s=seconds)


def count_failure(db: Session, account: str, address: str, now: datetime) -> None:
    """Counts one failure."""
    db.execute(delete(LoginFailures).where(LoginFailures.last_at < now - FORGET))
    for name, key in _keys(account, address).items():
        row = db.get(LoginFailures, key)
        count = 1 if row is None else row.count + 1
        db.merge(LoginFailures(key=key, count=count, last_at=now, blocked_until=now + LIMITS[name].wait(count)))


def forget_failures(db: Session, account: str, address: str) -> None:
    """Forgets the failures of this account at this address; those of the address stay."""
    keys = _keys(account, address)
    db.execute(delete(LoginFailures).where(LoginFailures.key == keys["pair"]))
