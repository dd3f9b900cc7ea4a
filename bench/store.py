"""Whether runs come through while their database is locked for 10 s or away for 60 s, in each phase, and what it knows of them afterwards.

Whole services, the simulated robot in real time: `python -m bench.store --times 20`. A lock stops nothing; a database that is away puts the
run on hold, and a person resumes it once it is back. SQLite that is away is SQLite locked for as long; with `--postgresql` the server is
stopped and started again. Afterwards the database has every event that the websocket told, in its place, and the audit log holds.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import httpx2
import numpy as np
from sqlalchemy import create_engine
from sqlalchemy.pool import NullPool

from bench.stops import PHASES, STANDING, Watcher, recover
from server.people import audit
from server.runs import ledger as run_ledger
from server.store.store import Store, Table
from tests.server.postgresql import Cluster, binaries, cluster
from tests.server.real_service import Console, RealService, real_service, wait_for

LOCKED_S, AWAY_S = 10.0, 60.0
HOLD_S = 4.0
"""Of each pose: the robot moves for some 55 s."""
PART = (0.02, 0.25)
"""Of the robot time, at which it begins: so early that the run is not over before the database is missed, which takes 30 s."""
RUN_S = 300.0
"""A run takes no longer, whatever happens to it."""
CAUGHT_UP_S = 30.0
"""For what happened meanwhile to be written, after the run."""
TAP_S = 0.5


@dataclass(frozen=True)
class Weathered:
    """A run whose database was locked or away.

    Args:
        flaws: what is not as it should be; none where all is well.
        held_after_s: from the beginning until the run was on hold; None where it never was.
    """

    flaws: tuple[str, ...]
    held_after_s: float | None
    taps: int

    def __str__(self) -> str:
        held = "never held" if self.held_after_s is None else f"held after {self.held_after_s:.1f} s, taps {self.taps}"
        return f"{held}; {'; '.join(self.flaws) or 'complete, every event is there'}"


@dataclass(frozen=True)
class Database:
    """Of one service.

    Args:
        server: of PostgreSQL; None for SQLite.
    """

    url: str
    server: Cluster | None

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Somebody else has it for themselves."""
        engine = create_engine(self.url, isolation_level="AUTOCOMMIT", poolclass=NullPool)
        with engine.connect() as other:
            if self.server is None:
                other.exec_driver_sql("BEGIN EXCLUSIVE")
            else:
                other.exec_driver_sql("BEGIN")
                other.exec_driver_sql(f"LOCK TABLE {', '.join(Table.metadata.tables)} IN ACCESS EXCLUSIVE MODE")
            try:
                yield
            finally:
                other.exec_driver_sql("ROLLBACK")

    @contextmanager
    def away(self) -> Iterator[None]:
        """It does not answer."""
        if self.server is None:
            with self.locked():
                yield
        else:
            self.server.stop()
            try:
                yield
            finally:
                self.server.start()


@dataclass(frozen=True)
class Outage:
    """What happens to the database, for how long, and whether a run is held by it."""

    name: str
    seconds: float
    holds: bool

    def of(self, database: Database) -> AbstractContextManager[None]:
        """As long as it is open."""
        return database.away() if self.holds else database.locked()


OUTAGES = (Outage("locked", LOCKED_S, holds=False), Outage("away", AWAY_S, holds=True))


def series(outages: list[Outage], postgresql: bool, folder: Path, seeds: list[int]) -> dict[tuple[str, str], list[Weathered]]:
    """Outages in every phase, once for each seed, of one service's database."""
    found: dict[tuple[str, str], list[Weathered]] = {}
    with ExitStack() as stack:
        server = stack.enter_context(cluster()) if postgresql else None
        service = stack.enter_context(real_service(folder, database_url=server.empty() if server else None))
        database = Database(service.store_url, server)
        for outage in outages:
            for phase in PHASES:
                for seed in seeds:
                    each = weathered(service, database, outage, phase, seed)
                    found.setdefault((outage.name, phase), []).append(each)
                    print(f"{time.strftime('%H:%M:%S')} {outage.name:6} {phase:9} seed {seed}: {each}", flush=True)
    return found


def weathered(service: RealService, database: Database, outage: Outage, phase: str, seed: int) -> Weathered:
    """One run, and what is wrong with what became of it."""
    console = Console(service)
    run = console.order(seed=seed, hold_s=HOLD_S)
    console.wait(run, "Idle", seconds=RUN_S)
    watcher = Watcher(console, run)
    console.take_control()
    assert console.release(run).status_code == 200
    part = np.random.default_rng((seed, PHASES.index(phase))).uniform(*PART)
    there = f"{phase} after {part:.0%} of the robot time"
    wait_for(lambda: (watcher.phase == phase and watcher.progress >= part) or watcher.state in STANDING, there, seconds=RUN_S)
    if watcher.state in STANDING:
        flaw = f"was {watcher.state} before anything happened: {reason_of([message['event'] for message in watcher.told])}"
        recover(service, run)
        return Weathered((flaw,), None, 0)
    begun_s = time.monotonic()
    held_after_s: list[float] = []
    with outage.of(database):
        while time.monotonic() < begun_s + outage.seconds:
            if watcher.state == "Held" and not held_after_s:
                held_after_s.append(time.monotonic() - begun_s)
            time.sleep(0.02)
    taps = resumed(console, watcher, run)
    flaws = flaws_of(watcher, outage) + differences(database.url, watcher, run)
    console.leave()
    if watcher.state != "Complete":
        recover(service, run)
    return Weathered(tuple(flaws), held_after_s[0] if held_after_s else None, taps)


def resumed(console: Console, watcher: Watcher, run: str) -> int:
    """Resumes the run whenever it is held, until it is over; how many taps were taken."""
    taps, until = 0, time.monotonic() + RUN_S
    while watcher.thread.is_alive() and watcher.state != "Aborted" and time.monotonic() < until:
        if watcher.state == "Held" and console.command(run, "resume").status_code == httpx2.codes.OK:
            taps += 1
        watcher.thread.join(TAP_S)
    return taps


def flaws_of(watcher: Watcher, outage: Outage) -> list[str]:
    """What should not have happened to the run."""
    events = [message["event"] for message in watcher.told]
    states = [event["state"] for event in events if event["kind"] == "state_changed"]
    stops = [event for event in events if event["kind"] == "robot_stopped"]
    causes = [(stop.get("lateness") or {}).get("cause", stop["error"]) for stop in stops]
    expected = ["store"] if outage.holds else []
    flaws = [] if watcher.state == "Complete" else [f"lost: {watcher.state or 'never begun'}, {reason_of(events)}"]
    if causes != expected:
        flaws.append(f"stopped by {causes or 'nothing'}, expected {expected or 'nothing'}")
    if ("Held" in states) != outage.holds:
        flaws.append(f"went through {' '.join(states)}")
    return flaws


def reason_of(events: list[dict[str, Any]]) -> str:
    """The last that was given."""
    return next((event["reason"]["text"] for event in reversed(events) if event.get("reason")), "without a reason")


def differences(url: str, watcher: Watcher, run: str) -> list[str]:
    """Between what the database knows and what was told, and in its audit log."""
    store = Store(url)

    def kept() -> list[dict[str, Any]]:
        with store.read() as db:
            return [json.loads(text) for _, text in run_ledger.list_events(db, run, 0)]

    until = time.monotonic() + CAUGHT_UP_S
    while len(kept()) < len(watcher.told) and time.monotonic() < until:
        time.sleep(TAP_S)
    with store.read() as db:
        count, _, wrong = audit.verify_chain(audit.entries(db))
    found, numbers = kept(), range(1, len(watcher.told) + 1)
    store.close()
    flaws = [] if wrong is None else [f"audit log, after {count} entries: {wrong}"]
    if [message["sequence"] for message in found] != list(numbers):
        flaws.append(f"kept {len(found)} events, not without gaps, of {len(watcher.told)} that were told")
    if [message["sequence"] for message in watcher.told] != list(numbers):
        flaws.append(f"told {len(watcher.told)} events, not without gaps")
    if found != watcher.told:
        flaws.append("what is kept differs from what was told")
    return flaws


def say(outage: Outage, phase: str, found: list[Weathered]) -> None:
    """One line."""
    held = [each.held_after_s for each in found if each.held_after_s is not None]
    after = f"after {min(held):.1f} to {max(held):.1f} s" if held else "none"
    well = sum(not each.flaws for each in found)
    print(f"{outage.name:6} {outage.seconds:2.0f} s {phase:9} as wanted {well} of {len(found)}; held {len(held)}, {after}", flush=True)
    for each in found:
        for flaw in each.flaws:
            print(f"    {flaw}")


def main() -> None:
    """Prints one line for each run, then one for each outage and phase."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("outages", nargs="*", help=f"all, or some of {' '.join(outage.name for outage in OUTAGES)}")
    parser.add_argument("--times", type=int, default=3, help="of each outage in each phase")
    parser.add_argument("--at-once", type=int, default=1, help="services at the same time; more than there are cores make each other late")
    parser.add_argument("--postgresql", action="store_true", help="instead of SQLite; it has to be installed")
    given = parser.parse_args()
    if given.postgresql and binaries() is None:
        parser.error("PostgreSQL's initdb is not installed (Debian: apt-get install postgresql)")
    outages = [outage for outage in OUTAGES if outage.name in (given.outages or {each.name for each in OUTAGES})]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(given.at_once) as pool:
        seeds = [list(range(given.times))[k :: given.at_once] for k in range(min(given.at_once, given.times))]
        folders = [Path(folder) / str(k) for k in range(len(seeds))]
        found = list(pool.map(partial(series, outages, given.postgresql), folders, seeds))
    print()
    for outage in outages:
        for phase in PHASES:
            say(outage, phase, [each for part in found for each in part[outage.name, phase]])


if __name__ == "__main__":
    main()
