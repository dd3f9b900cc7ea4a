"""What was asked for, completed by what the cell knows: all that a control process has to be told."""

from __future__ import annotations

from pathlib import Path

from core.cell import Cell
from core.plan_settings import Timing
from server.run_ledger import motion_of
from server.run_schemas import Motion, RestOfRun, RunOrder
from server.run_tables import RunRow
from server.runner.messages import Continuation, Order


def order_of(row: RunRow, cell: Cell, folder: Path) -> Order:
    """What the control process is told."""
    asked = RunOrder.model_validate_json(row.order)
    motion = motion_of(row)
    payload = asked.payload or next(iter(cell.payloads))  # orders of older services may name none
    return Order(
        run=row.id,
        cell=cell,
        payload=payload,
        payload_box=asked.payload_box or cell.payloads[payload].box,
        timing=Timing(hold_s=asked.hold_s, settle_s=asked.settle_s, robot_s=asked.robot_s, inertia_std=asked.inertia_std),
        planner=asked.planner,
        seed=asked.seed,
        mass_guess_kg=asked.mass_guess_kg,
        pace=asked.pace,
        folder=folder,
        continues=None if motion is None else _continuation(motion),
    )


def _continuation(motion: Motion) -> Continuation:
    if isinstance(motion, RestOfRun):
        return Continuation(motion.recording, motion.stops, motion.done)
    return Continuation(motion.recording, motion.stops)
