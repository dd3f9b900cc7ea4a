"""The blind check: faults planted in the virtual robot, sealed, diagnosed, and only then compared with the truth.

The faults (`core.plant.faults`) share no code with the effects that are fitted. Small imperfections are always on, so that "none" is never
perfectly none; half of the faults have another shape than the models, and some are of a kind that the library does not have.
"""

from __future__ import annotations

import json
from collections.abc import Generator
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict

from core.cell import Cell, find_cell, load_cell
from core.collision import CollisionModel
from core.errors import Stopped
from core.events import Event
from core.gap.answer import Diagnosis
from core.gap.diagnosis import diagnose
from core.plan import Plan, plan_procedure
from core.plant.faults import FAULTS, Background, Fault, Setting, variants
from core.plant.mechanics import Drives
from core.procedure import carry_out
from core.robot import RobotModel
from core.sessions.simulated import SimulatedSession

Answer = TypeVar("Answer")

CELLS = ("lwr4_bench", "ur5e_line")
KINDS = {"none": 0.2, "single": 0.55, "double": 0.1, "unknown": 0.15}
"""How often each kind of trial is drawn."""
SMALLEST, LARGEST = 0.3, 3.0
"""Sizes are drawn between these, in plausible sizes of the fault, evenly in their logarithm."""
SMOOTH = Drives(damping_s=0.0, friction=0.0)
"""Friction is one of the faults: where it is not planted, there is none."""
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


class Outcome(BaseModel):
    """One trial: the truth and what the diagnosis said of it."""

    model_config = ConfigDict(frozen=True)

    sealed: Sealed
    stopped: str | None
    verdict: str
    first: str | None
    first_probability: float
    true_probability: float
    tied: tuple[str, ...]
    gap_before: float
    gap_after: float
    closure: float
    true_closure: float | None
    payload_error_before: float
    payload_error_after: float
    seconds: float

    @property
    def right(self) -> bool:
        """Whether the answer is right: the first name, a declared tie that holds it, or the right kind of silence."""
        if self.sealed.kind == "none":
            return self.verdict == "no_gap"
        if self.sealed.kind == "unknown":
            return self.verdict in ("unknown", "no_gap")
        named = self.verdict in ("explained", "ambiguous")
        return named and (self.first in self.sealed.ids or bool(set(self.tied) & set(self.sealed.ids)))


@dataclass(frozen=True)
class Drawn:
    """A trial before it runs."""

    cell: Cell
    plan: Plan
    sealed: Sealed
    faults: tuple[Fault, ...]


def draw(seed: int) -> Drawn:
    """Draws cell, payload and faults of one trial."""
    rng = np.random.default_rng([seed, 20])
    name = CELLS[int(rng.integers(len(CELLS)))]
    cell, plans = planned(name)
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
    return Drawn(cell, plans[payload], sealed, (Background.draw(rng, 1.0, setting), *faults))


@cache
def planned(name: str) -> tuple[Cell, dict[str, Plan]]:
    """A cell with one plan for each of its payloads; the trials of a process share them."""
    cell = load_cell(find_cell(name))
    robot = RobotModel.of_cell(cell)
    home = np.array(cell.robot.home_rad)
    plans = {
        payload: returned(plan_procedure(cell, robot, CollisionModel(cell, robot, known.box), known.box, start=home))
        for payload, known in cell.payloads.items()
    }
    return cell, plans


def returned(run: Generator[Event, None, Answer]) -> Answer:
    """What a generator of events returns in the end."""
    while True:
        try:
            next(run)
        except StopIteration as end:
            answer: Answer = end.value
            return answer


def run_trial(drawn: Drawn) -> Outcome:
    """Runs the procedure with the faults, diagnoses without them, and opens the seal."""
    cell, sealed = drawn.cell, drawn.sealed
    carried = cell.payloads[sealed.payload]
    session = SimulatedSession(cell, carried.parameters, seed=sealed.seed, faults=drawn.faults, drives=SMOOTH)
    try:
        recording = returned(carry_out(cell, session, carried.box, drawn.plan, payload=sealed.payload)).recording
    except Stopped as error:
        return _judged(sealed, None, carried.parameters.phi, str(error))
    return _judged(sealed, diagnose(recording), carried.parameters.phi, None)


def _judged(sealed: Sealed, diagnosis: Diagnosis | None, phi: NDArray[np.float64], stopped: str | None) -> Outcome:
    first = diagnosis.effects[0] if diagnosis and diagnosis.effects else None
    true = [effect for effect in diagnosis.effects if effect.id in sealed.ids] if diagnosis else []
    ties = diagnosis.indistinguishable if diagnosis else []
    gap = diagnosis.gap if diagnosis else None
    payload = diagnosis.payload if diagnosis else None
    return Outcome(
        sealed=sealed,
        stopped=stopped,
        verdict=diagnosis.verdict if diagnosis else "stopped",
        first=first.id if first else None,
        first_probability=first.probability if first else 0.0,
        true_probability=max((effect.probability for effect in true), default=0.0),
        tied=tuple(sorted({name for tie in ties for name in tie.ids})),
        gap_before=gap.before if gap else 0.0,
        gap_after=gap.after if gap else 0.0,
        closure=first.closure if first else 0.0,
        true_closure=max((effect.closure for effect in true), default=None),
        payload_error_before=_mass_error(payload.before.phi, phi) if payload else 0.0,
        payload_error_after=_mass_error(payload.after.phi, phi) if payload else 0.0,
        seconds=diagnosis.seconds if diagnosis else 0.0,
    )


def _mass_error(found: list[float], phi: NDArray[np.float64]) -> float:
    """Share of the mass."""
    return abs(found[0] / float(phi[0]) - 1.0)
