"""A plan as a file of joint positions for one's own controller: what would be commanded, holds included, one period after the other."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.errors import BadInput
from core.files.whole_file import write_whole
from core.planning.commanded_path import compute_joint_paths
from core.planning.plan import Leg, Plan, motions_of
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

ROUNDING = 9
"""Decimals of a joint position, rad: finer than any encoder."""


@dataclass(frozen=True)
class PlannedMotion:
    """One motion, or a hold.

    Args:
        name: `transfer x+`, `hold x+`, `rotation x`, `home`.
        start_s: when its first set point is due, from the beginning of the plan.
        q: (N, n), rad, a row for each period. The first motion begins with where the robot stands; each of the others goes on from the last
            row of the one before it.
    """

    name: str
    start_s: float
    q: Array


@dataclass(frozen=True)
class SetPoints:
    """The set points of a whole plan.

    Args:
        joints: names, in the order of the columns of q.
        period_s: from one row to the next, also from one motion to the next.
    """

    cell: str
    joints: tuple[str, ...]
    period_s: float
    motions: tuple[PlannedMotion, ...]


def set_points_of(cell: Cell, robot: RobotModel, collision: CollisionModel, plan: Plan, *, period_s: float | None = None) -> SetPoints:
    """What would be commanded along a plan, rotations as the controller solves them.

    Args:
        period_s: a multiple of the plan's own period, that where absent. Every n-th set point is taken: a motion that is no multiple of it
            long ends with one shorter step, and nothing gets faster.

    Raises:
        BadInput: another period.
        PlanDisputed: a rotation stands still, or a trajectory does not start where the motion before it ends.
    """
    own = plan.home.trajectory.period
    every = multiple(period_s, own)
    first = plan.legs[0].transfer if plan.legs else plan.home
    here = first.trajectory.q[0]
    paths = iter(compute_joint_paths(cell, robot, collision, motions_of(plan.legs, plan.home), here))
    named: list[tuple[str, Array]] = []
    for leg in plan.legs:
        arrival = next(paths)
        named += [(arrival.name, arrival.q), _hold(leg, arrival.q[-1], plan.timing.hold_s / own)]
        moved = [next(paths) for motion in (leg.profile, leg.wave) if motion is not None]
        named += [(each.name, each.q) for each in moved]
        named += [_hold(leg, moved[-1].q[-1], plan.timing.settle_s / own)] if moved else []
    named += [(each.name, each.q) for each in paths]
    return SetPoints(cell.name, tuple(robot.description.joints), own * every, _in_time(named, every, own * every))


def multiple(period_s: float | None, own: float) -> int:
    """How many of the plan's periods one of the file's has; one where no other is asked for."""
    period_s = own if period_s is None else period_s
    every = round(period_s / own) if np.isfinite(period_s) else 0
    if not 1 <= every <= 100 or not np.isclose(every * own, period_s, rtol=1e-9):
        raise BadInput("--period", "planning-period-no-multiple", period_s=period_s, own_s=own, most_s=100 * own)
    return every


def _hold(leg: Leg, q: Array, periods: float) -> tuple[str, Array]:
    """Standing still at q (n,); its first row is where the motion before it ended."""
    return f"hold {leg.axis}", np.tile(q, (1 + round(periods), 1))


def _in_time(named: list[tuple[str, Array]], every: int, period_s: float) -> tuple[PlannedMotion, ...]:
    motions: list[PlannedMotion] = []
    rows = 0
    for name, q in named:
        taken = q[::every] if (len(q) - 1) % every == 0 else np.concatenate((q[::every], q[-1:]))
        taken = taken[1:] if motions else taken
        motions.append(PlannedMotion(name, rows * period_s, taken))
        rows += len(taken)
    return tuple(motions)


def check_set_points(file: Path | None, period_s: float | None, own: float) -> None:
    """Before anything long begins: whether the file can be written with that period, where a plan has its `own`.

    Raises:
        BadInput: it has another ending than `.csv` or `.json`, its folder does not exist, or the period is none that it can have.
    """
    multiple(period_s, own)
    if file is None:
        if period_s is not None:
            raise BadInput("--period", "planning-period-without-file", period_s=period_s)
        return
    if file.suffix not in (".csv", ".json"):
        raise BadInput("--trajectory", "planning-trajectory-file-ending", file=str(file))
    if not file.absolute().parent.is_dir():
        raise BadInput("--trajectory", "planning-trajectory-folder-missing", file=str(file))


def write_set_points(file: Path, found: SetPoints) -> None:
    """Writes CSV or JSON, as the file is called; it appears complete or not at all.

    CSV has the columns `time_s`, `motion` and `<joint>_rad`; JSON the same by motion.
    """
    write_whole(file, _csv(found) if file.suffix == ".csv" else _json(found))


def _csv(found: SetPoints) -> str:
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["time_s", "motion", *(f"{joint}_rad" for joint in found.joints)])
    for motion in found.motions:
        for k, q in enumerate(motion.q.round(ROUNDING).tolist()):
            rows.writerow([round(motion.start_s + k * found.period_s, 6), motion.name, *q])
    return text.getvalue()


def _json(found: SetPoints) -> str:
    motions = [
        {"name": motion.name, "start_s": round(motion.start_s, 6), "q_rad": motion.q.round(ROUNDING).tolist()} for motion in found.motions
    ]
    return json.dumps({"cell": found.cell, "joints": found.joints, "period_s": found.period_s, "motions": motions}) + "\n"
