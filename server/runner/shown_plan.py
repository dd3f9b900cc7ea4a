"""A plan made ready to be shown and released: what a release is bound to, and what a person looks at."""

from __future__ import annotations

import numpy as np

from core.cell.cell import Box, Cell
from core.planning.plan import Plan, plan_digest, plan_summary
from core.second_opinion.opinion import JointPath
from server.runner.plan_schemas import PathPart, RunPlan
from server.runner.release_hash import release_sha256
from server.runner.shown_throws import throws_of

SHOWN_PERIOD_S = {"transfer": 0.05, "home": 0.05}
"""Of joint positions that are looked at, by the kind of motion."""
TURN_PERIOD_S = 0.1
"""The same of rotations and waves, which are slow and long."""


def build_run_plan(cell: Cell, payload_box: Box, plan: Plan) -> RunPlan:
    """Everything about a plan that its release needs."""
    digest = plan_digest(plan)
    return RunPlan(
        sha256=release_sha256(digest, cell, payload_box),
        plan_digest=digest,
        summary=plan_summary(cell, plan),
        paths=[_path(path, plan.home.trajectory.period) for path in plan.commanded],
        throws=list(throws_of(cell, payload_box, plan)),
    )


def _path(path: JointPath, period: float) -> PathPart:
    kind, _, toward = path.name.partition(" ")
    every = max(1, round(SHOWN_PERIOD_S.get(kind, TURN_PERIOD_S) / period))
    rows = np.unique(np.append(np.arange(0, len(path.q), every), len(path.q) - 1))
    return PathPart(part=path.name, toward=toward or kind, period_s=every * period, q_rad=np.round(path.q[rows], 5).tolist())
