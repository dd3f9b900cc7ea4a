"""What a trial plants: cell, payload and faults, drawn by seed and sealed before anything runs."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from typing import Any

import numpy as np
from pydantic import BaseModel, ConfigDict

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.events import drive
from core.planning.plan import Plan
from core.planning.search import plan_stops
from core.planning.stops import PROCEDURE
from core.plant.faults import FAULTS, Background, Fault, Setting, variants
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
        background: the small imperfections that are always there.
        faults: what is planted besides.
    """

    cell: Cell
    plan: Plan
    sealed: Sealed
    background: Background
    faults: tuple[Fault, ...]


def draw(seed: int) -> DrawnTrial:
    """Draws cell, payload and faults of one trial."""
    rng = np.random.default_rng([seed, 20])
    name = CELLS[int(rng.integers(len(CELLS)))]
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
        cell=name,
        payload=payload,
        kind=kind,
        ids=tuple(str(identifier) for identifier in ids),
        variants=tuple(fault.variant for fault in faults),
        size=size,
        truth=json.dumps([fault.truth for fault in faults]),
    )
    return DrawnTrial(cell, plans[payload], sealed, Background.draw(rng, 1.0, setting), tuple(faults))


@cache
def plan_each_payload(name: str) -> tuple[Cell, dict[str, Plan]]:
    """A cell with one plan for each of its payloads; the trials of a process, and the processes it forks, share them."""
    cell = load_cell(find_cell(name))
    robot = RobotModel.of_cell(cell)
    home = np.array(cell.robot.home_rad)
    plans = {
        payload: drive(plan_stops(cell, robot, CollisionModel(cell, robot, known.box), known.box, PROCEDURE.stops, start=home))
        for payload, known in cell.payloads.items()
    }
    return cell, plans
