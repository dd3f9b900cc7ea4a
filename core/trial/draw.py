"""What a trial plants: cell, payload and faults, drawn by seed and sealed before anything runs."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import BaseModel, ConfigDict

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.errors import BadCell
from core.events import drive
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.plant.faults import FAULTS, Background, Fault, Setting, variants
from core.plant.faults.arm_imperfections import draw_arm_imperfections
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from core.words.message import Message

CELLS = ("lwr4_bench", "ur5e_line")
KINDS = {"none": 0.2, "single": 0.55, "double": 0.1, "unknown": 0.15}
"""How often each kind of trial is drawn."""
SMALLEST, LARGEST = 0.3, 3.0
"""Sizes are drawn between these, in plausible sizes of the fault, evenly in their logarithm."""
IDS = sorted({fault.id for fault in FAULTS} - {"unknown"})


class Sealed(BaseModel):
    """What was planted. Its hash is published before the diagnosis, the rest after it."""

    model_config = ConfigDict(frozen=True)

    seed: int
    cell: str
    payload: str
    kind: str
    ids: tuple[str, ...]
    variants: tuple[str, ...]
    size: float
    truth: str

    @property
    def hash(self) -> str:
        """SHA-256 of everything that is sealed."""
        return sha256(self.model_dump_json().encode()).hexdigest()

    @property
    def planted(self) -> tuple[tuple[str, str, dict[str, Any]], ...]:
        """Identifier, variant and parameters of each fault."""
        return tuple(zip(self.ids, self.variants, json.loads(self.truth), strict=True))

    @property
    def in_words(self) -> Message:
        """The faults in one line."""
        faults = [f"{name} ({variant})" for name, variant in zip(self.ids, self.variants, strict=True)]
        return Message.of("trial-planted", faults=faults) if faults else Message.of("trial-planted-nothing")


@dataclass(frozen=True)
class DrawnTrial:
    """A trial before it runs.

    Args:
        background: the small imperfections that are always there, those of the arm among them.
        faults: what is planted besides.
    """

    cell: Cell
    plan: Plan
    sealed: Sealed
    background: tuple[Fault, ...]
    faults: tuple[Fault, ...]


def draw(seed: int, cells: Sequence[str] = CELLS) -> DrawnTrial:
    """Draws cell, payload and faults of one trial.

    Args:
        cells: names or folders, to draw from; each has to know a payload.

    Raises:
        BadInput: one of them cannot be used, or knows no payload.
        Refused: the procedure cannot be planned there.
    """
    rng = np.random.default_rng([seed, 20])
    name = cells[int(rng.integers(len(cells)))]
    cell, plans = plan_each_payload(name)
    payload = sorted(plans)[int(rng.integers(len(plans)))]
    setting = Setting(cell, cell.payloads[payload].parameters, plans[payload].robot_s)
    kind = str(rng.choice(list(KINDS), p=list(KINDS.values())))
    size = float(np.exp(rng.uniform(np.log(SMALLEST), np.log(LARGEST))))
    ids = {"none": (), "unknown": ("unknown",)}.get(kind, tuple(rng.choice(IDS, 2 if kind == "double" else 1, replace=False)))
    faults = []
    for identifier in ids:
        kinds = variants(str(identifier))
        faults.append(kinds[int(rng.integers(len(kinds)))].draw(rng, size, setting))
    sealed = Sealed(
        seed=seed,
        cell=cell.name,
        payload=payload,
        kind=kind,
        ids=tuple(str(identifier) for identifier in ids),
        variants=tuple(fault.variant for fault in faults),
        size=size,
        truth=json.dumps([fault.truth for fault in faults]),
    )
    background = (Background.draw(rng, 1.0, setting), *draw_arm_imperfections(setting))
    return DrawnTrial(cell, plans[payload], sealed, background, tuple(faults))


def plan_each_payload(name: str) -> tuple[Cell, dict[str, Plan]]:
    """A cell with one plan for each of its payloads; the trials of a process, and the processes it forks, share them.

    Args:
        name: or folder.

    Raises:
        BadInput: the cell cannot be used, or knows no payload.
        Refused: the procedure cannot be planned there.
    """
    return _plan_each_payload(find_cell(name))


@cache
def _plan_each_payload(folder: Path) -> tuple[Cell, dict[str, Plan]]:
    cell = load_cell(folder)
    if not cell.payloads:
        raise BadCell(cell.locate("payloads"), "trial-no-payload")
    robot = RobotModel.of_cell(cell)
    home = np.array(cell.robot.home_rad)
    plans = {
        payload: drive(plan_stops(cell, robot, CollisionModel(cell, robot, known.box), known.box, PROCEDURE.stops, start=home))
        for payload, known in cell.payloads.items()
    }
    return cell, plans
