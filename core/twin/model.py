"""A twin's effects in a scene, where they act."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.effects.composition import Composition, Term
from core.effects.library import find_effect
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.twin.twin import Entry, Twin
from core.words.message import Message

LONGEST_RUN_S = 86_400.0
"""What happens once happens within a day."""


def find_theta(entry: Entry, scene: Scene) -> Array:
    """(n,), values of the parameters that the effect has in this scene; absent where the fit had no such parameter."""
    known = entry.parameters
    return np.array([known[p.name].value if p.name in known else p.absent for p in find_effect(entry.effect).parameters(scene)])


def explain_lacks(twin: Twin, scene: Scene) -> dict[str, Message]:
    """Why effects cannot be evaluated in this scene, by their identifiers; those that can be are not there."""
    reasons = {name: find_effect(name).explain_lack(scene) for name in twin.ids}
    return {name: reason for name, reason in reasons.items() if reason is not None}


def find_terms(twin: Twin, scene: Scene) -> tuple[Term, ...]:
    """The effects that can be evaluated in this scene, with their parameters."""
    lacking = explain_lacks(twin, scene)
    return tuple(Term(find_effect(entry.effect), find_theta(entry, scene)) for entry in twin.effects if entry.effect not in lacking)


def compose_effects(twin: Twin, scene: Scene) -> Composition:
    """The effects that can be evaluated in this scene, ready to act."""
    return Composition(find_terms(twin, scene))


def make_home_scene(cell: Cell) -> Scene:
    """The cell's robot at home for a day, with all that a scene can know: the scene that is asked what an effect's parameters may be."""
    n = len(cell.robot.home_rad)
    gravity = cell.gravity_in_base
    return Scene(
        t=np.array([0.0, LONGEST_RUN_S]),
        phase=np.array(["hold:free"] * 2),
        motion=Motion.still(np.stack([gravity] * 2)),
        rotation=np.stack([np.eye(3)] * 2),
        position=np.zeros((2, 3)),
        gravity=gravity,
        phi=np.zeros(10),
        q=np.stack([np.array(cell.robot.home_rad)] * 2),
        dq=np.zeros((2, n)),
        jacobian=np.zeros((2, 6, n)),
        temperature=np.zeros(2),
        range=np.array(cell.sensor.range),
        resolution=np.array(cell.sensor.resolution),
        step=1e-3,
    )
