"""A cell's twin: what has been added to its nominal simulation, each effect as it was fitted to a recording.

The nominal twin has no entries. `twin_file` keeps it beside the cell.
"""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import AwareDatetime, BaseModel, ConfigDict, Field

from core.array import Array
from core.cell.cell import Cell
from core.effects.composition import Composition, Term
from core.effects.effect import Effect
from core.effects.library import library
from core.effects.scene import Scene
from core.payload.inertia import Motion
from core.words.message import Message

Number = Annotated[float, Field(strict=True)]
NotNegative = Annotated[float, Field(strict=True, ge=0)]

LONGEST_RUN_S = 86_400.0
"""What happens once happens within a day."""


class TwinPart(BaseModel):
    """Frozen; unknown keys, NaN and infinity are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Fitted(TwinPart):
    """A parameter's value with its standard uncertainty."""

    value: Number
    std: NotNegative
    unit: str


class Entry(TwinPart):
    """One effect and where it comes from.

    Args:
        effect: its identifier.
        parameters: by name, in the effect's order.
        covariance: of the parameters, in that order.
        recording: name of the recording that it was fitted to; `sha256`: of that recording's files.
        added: when.
        gap_before, gap_after: root mean square of (measured - simulated) over noise, on motions that the fit did not see.
    """

    effect: str
    parameters: dict[str, Fitted]
    covariance: tuple[tuple[Number, ...], ...]
    recording: str
    sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    added: AwareDatetime
    gap_before: NotNegative
    gap_after: NotNegative

    @property
    def model(self) -> Effect:
        """The effect itself.

        Raises:
            KeyError: the library does not have it; a twin that was read from its file has none such.
        """
        return effect_of(self.effect)

    def theta(self, scene: Scene) -> Array:
        """(n,), values of the parameters that the effect has in this scene; absent where the fit had no such parameter."""
        return np.array([self.parameters[p.name].value if p.name in self.parameters else p.absent for p in self.model.parameters(scene)])

    @property
    def directions(self) -> list[dict[str, float]]:
        """Independent departures of the parameters, one standard deviation each; `covariance` is the sum of their outer products."""
        size, axes = np.linalg.eigh(np.array(self.covariance))
        known = size > 1e-6 * max(float(size.max(initial=0.0)), math.ulp(0.0))
        return [dict(zip(self.parameters, np.sqrt(s) * axis, strict=True)) for s, axis in zip(size[known], axes.T[known], strict=True)]

    def move_parameters(self, by: dict[str, float]) -> Entry:
        """The same effect with other values."""
        values = {name: p.model_copy(update={"value": p.value + by.get(name, 0.0)}) for name, p in self.parameters.items()}
        return self.model_copy(update={"parameters": values})


class Twin(TwinPart):
    """What the cell's simulation has beyond the nominal one."""

    format: Literal["twin/1"] = "twin/1"
    effects: tuple[Entry, ...] = ()

    @property
    def ids(self) -> tuple[str, ...]:
        """Identifiers of the effects."""
        return tuple(entry.effect for entry in self.effects)

    def without(self, identifier: str) -> Twin:
        """The twin without one effect."""
        return Twin(effects=tuple(entry for entry in self.effects if entry.effect != identifier))

    def with_entry(self, entry: Entry) -> Twin:
        """The twin with an effect, in the place of an older entry of the same identifier."""
        return Twin(effects=(*self.without(entry.effect).effects, entry))

    def lacking(self, scene: Scene) -> tuple[Message, ...]:
        """Effects that cannot be evaluated in this scene, with the reasons."""
        reasons = {entry.effect: entry.model.explain_lack(scene) for entry in self.effects}
        return tuple(Message.of("twin-lacking", effect=name, reason=reason) for name, reason in reasons.items() if reason is not None)

    def in_scene(self, scene: Scene) -> tuple[Entry, ...]:
        """The effects that can be evaluated in this scene."""
        return tuple(entry for entry in self.effects if entry.model.explain_lack(scene) is None)

    def compose_effects(self, scene: Scene) -> Composition:
        """The effects that can be evaluated in this scene, ready to act."""
        return Composition(self.terms(scene))

    def terms(self, scene: Scene) -> tuple[Term, ...]:
        """The effects that can be evaluated in this scene, with their parameters."""
        return tuple(Term(entry.model, entry.theta(scene)) for entry in self.in_scene(scene))


NOMINAL = Twin()


def effect_of(identifier: str) -> Effect:
    """The library's effect of this identifier; KeyError where there is none."""
    return {effect.id: effect for effect in library()}[identifier]


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
