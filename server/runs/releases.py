"""The release: an operator at the cell lets exactly that plan begin that they were shown."""

from __future__ import annotations

import asyncio
import hmac
import secrets
import shutil
import time
from collections.abc import Callable
from datetime import datetime
from hashlib import sha256
from pathlib import Path
from typing import Annotated

from core.sessions.leased import Renewal
from server.http.dependencies import depend_on
from server.http.errors import Conflict, NoRoom
from server.people import audit
from server.people.audit import Detail
from server.runner.plan_schemas import RunPlan
from server.runner.release_hash import release_sha256
from server.runs import ledger as run_ledger
from server.runs.conductor import Conductor
from server.runs.lease import ControlRegistry
from server.runs.order import slow_down
from server.runs.packml import Command, IllegalCommandError, State
from server.runs.schemas import RunOrder

OFFER_S = 60.0
SPARE_BYTES, BYTES_A_SECOND = 50_000_000, 1_000_000
"""What has to be free on the disk before a release; measured: a run of 60 s leaves 28 MB."""


class Offers:
    """Says when a plan was shown, so that a release is never older than what its giver saw. A new service knows none of the old ones.

    Args:
        length_s: how long an offer is good.
        clock: monotonic, s.
    """

    def __init__(self, length_s: float = OFFER_S, clock: Callable[[], float] = time.monotonic) -> None:
        self.length_s = length_s
        self._clock = clock
        self._secret = secrets.token_bytes(32)

    def make(self, run: str, plan_sha256: str) -> str:
        """For a plan that is shown now."""
        shown_s = f"{self._clock():.3f}"
        return f"{shown_s}.{self._sign(run, plan_sha256, shown_s)}"

    def check(self, run: str, plan_sha256: str, offer: str) -> None:
        """It was made for this plan, and not too long ago.

        Raises:
            Conflict: look at the plan again.
        """
        shown_s, _, signature = offer.rpartition(".")
        if not hmac.compare_digest(signature.encode(), self._sign(run, plan_sha256, shown_s).encode()):
            raise Conflict("runs-offer-foreign")
        age = self._clock() - float(shown_s)
        if age > self.length_s:
            raise Conflict("runs-offer-old", age_s=age, limit_s=self.length_s)

    def _sign(self, run: str, plan_sha256: str, shown_s: str) -> str:
        return hmac.new(self._secret, f"{run} {plan_sha256} {shown_s}".encode(), sha256).hexdigest()


class Releases:
    """Checks everything that a release is bound to, then lets the run begin."""

    def __init__(self, conductor: Conductor, control: ControlRegistry, offers: Offers, now: Callable[[], datetime]) -> None:
        self._conductor, self._control, self._offers, self._now = conductor, control, offers, now

    async def release(self, run: str, who: str, plan_sha256: str, offer: str, sent: Renewal) -> None:
        """Lets the plan begin.

        Raises:
            NotFound: no such run.
            Conflict: the run is in no state to begin; the plan is not the one that waits; the cell, a zone or a limit has changed since;
                the offer is too old; whoever asks is not in control.
            NoRoom: the disk is too full.
            StoreUnavailable: the database cannot be written.
        """
        active = self._conductor.of_run(run)
        row = await asyncio.to_thread(self._conductor.row_of, run)
        if active is None or row.plan is None or row.state != State.IDLE:
            raise run_ledger.refusal(row, "release")
        cell = await asyncio.to_thread(self._conductor.read_current_cell, row.cell)
        waiting = RunPlan.model_validate_json(row.plan)
        slowed = slow_down(cell, RunOrder.model_validate_json(row.order))
        now_sha256 = release_sha256(waiting.plan_digest, slowed, active.payload_box)
        if plan_sha256 != waiting.sha256 or now_sha256 != waiting.sha256:
            raise Conflict("runs-plan-void", plan=plan_sha256[:12])
        self._offers.check(run, plan_sha256, offer)
        check_room(active.folder, waiting.summary.robot_s)
        self._control.command(row.cell, who, sent)
        detail: Detail = {"run": run, "plan_sha256": plan_sha256, "fence": sent.fence}
        try:
            await active.release(plan_sha256, who, audit.make_deed(who, "run.release", detail, now=self._now()))
        except IllegalCommandError:
            raise run_ledger.refusal(row, Command.START) from None


def check_room(folder: Path, robot_s: float) -> None:
    """A run leaves samples, a recording and a report behind, some 0.5 MB for each second that the robot moves.

    Raises:
        NoRoom: the disk has too little room for that.
    """
    free, needed = shutil.disk_usage(folder).free, SPARE_BYTES + robot_s * BYTES_A_SECOND
    if free < needed:
        raise NoRoom("runs-disk-too-full", free_mb=free / 1e6, needed_mb=needed / 1e6)


ReleasesDep = Annotated[Releases, depend_on("releases")]
OffersDep = Annotated[Offers, depend_on("offers")]
