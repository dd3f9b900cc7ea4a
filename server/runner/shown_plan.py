"""A plan made ready to be shown and released: what a release is bound to, and what a person looks at."""

from __future__ import annotations

from hashlib import sha256

import numpy as np

from core.cell.cell import Box, Cell
from core.planning.plan import Plan, plan_summary
from core.robot.trajectory import JointTrajectory
from server.runner.plan_schemas import PathPart, RunPlan
from server.runner.release_hash import release_sha256
from server.runner.shown_throws import throws_of

SHOWN_PERIOD_S = 0.05


def build_run_plan(cell: Cell, payload_box: Box, plan: Plan) -> RunPlan:
    """Everything about a plan that its release needs."""
    digest = plan_digest(plan)
    return RunPlan(
        sha256=release_sha256(digest, cell, payload_box),
        plan_digest=digest,
        summary=plan_summary(cell, plan),
        paths=[_path(leg.axis, leg.transfer.trajectory) for leg in plan.legs] + [_path("home", plan.home.trajectory)],
        throws=list(throws_of(cell, payload_box, plan)),
    )


def plan_digest(plan: Plan) -> str:
    """SHA-256 of every set point and of all times of a plan, hexadecimal."""
    digest = sha256(repr((plan.timing, [(leg.axis, leg.about) for leg in plan.legs])).encode())
    for leg in plan.legs:
        digest.update(leg.transfer.trajectory.q.tobytes())
        if leg.profile is not None:
            digest.update(leg.profile.angle.tobytes())
            digest.update(leg.profile.rate.tobytes())
        if leg.wave is not None:
            digest.update(leg.wave.q.tobytes())
    digest.update(plan.home.trajectory.q.tobytes())
    return digest.hexdigest()


def _path(toward: str, trajectory: JointTrajectory) -> PathPart:
    every = max(1, round(SHOWN_PERIOD_S / trajectory.period))
    rows = np.unique(np.append(np.arange(0, len(trajectory), every), len(trajectory) - 1))
    return PathPart(toward=toward, period_s=every * trajectory.period, q_rad=np.round(trajectory.q[rows], 5).tolist())
