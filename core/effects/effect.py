"""What an effect is: something that the nominal twin leaves out, as a model that can be added to the simulation and fitted to a recording.

The folder is the registry: every module of `core.effects` with an `Effect` class in it is in the `library()`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import ClassVar, Literal

import numpy as np

from core.array import Array
from core.effects.scene import Scene
from core.effects.sides import Side
from core.recording.recording import Recording
from core.words.message import Message

Stage = Literal["sensor", "timing", "mounting", "kinematics", "payload", "environment", "actuation"]
STAGES: tuple[Stage, ...] = ("mounting", "kinematics", "actuation", "payload", "environment", "timing", "sensor")
"""From the robot to the reading: the order in which effects act on the wrench."""
STAGE_NAMES: dict[Stage, Message] = {
    "mounting": Message.of("effect-stage-mounting"),
    "kinematics": Message.of("effect-stage-kinematics"),
    "actuation": Message.of("effect-stage-actuation"),
    "payload": Message.of("effect-stage-payload"),
    "environment": Message.of("effect-stage-environment"),
    "timing": Message.of("effect-stage-timing"),
    "sensor": Message.of("effect-stage-sensor"),
}


@dataclass(frozen=True)
class Parameter:
    """One parameter of an effect.

    Args:
        name: with its unit, for example `delay_s`.
        unit: for people.
        absent: the value at which the effect is not there.
        lower, upper: bounds of the fit.
        scale: plausible size; the standard deviation of the prior around `absent`.
        shown: whether it says anything to people; what merely follows the course of a run does not, and the wrench is linear in it.
    """

    name: str
    unit: str
    absent: float
    lower: float
    upper: float
    scale: float
    shown: bool = True


class Effect(ABC):
    """One unmodelled effect. Stateless; everything it knows of the run stands in the `Scene`."""

    id: ClassVar[str]
    """Identifier that reports use."""
    title: ClassVar[Message]
    """As in "the gap is explained by <title>"."""
    stage: ClassVar[Stage]
    wider_shape: ClassVar[bool] = False
    """Whether this is a richer shape of an effect that the library has under the same identifier: fitted beside it, never in a twin."""
    starts_from_most: ClassVar[bool] = False
    """Whether it spoils the payload's first estimate so much that a fit has to start from the rows which it leaves alone."""
    followed: ClassVar[int] = 1
    """How many of its starting values a fit follows to the end: more than the best one where steps and kinks make many valleys."""
    only_adds: ClassVar[bool] = False
    """Whether what it adds to the wrench does not depend on that wrench, so that noise in it passes as it is."""
    moves_payload: ClassVar[bool] = False
    """Whether what the payload asks for comes out of it so changed that its share in each row has to be worked out behind the effect."""
    jumps: ClassVar[bool] = False
    """Whether the least change of the load can make it jump."""
    needs_motion: ClassVar[bool] = False
    """Whether what it does depends on the way from one pose to the next."""
    stands_alone: ClassVar[bool] = False
    """Whether it is sought by itself only: beside another its many parameters would take up whatever that leaves."""
    last_resort: ClassVar[bool] = False
    """Whether it is sought only where all else, also together, leaves much."""

    beside: ClassVar[type[Effect] | None] = None
    """The shape that `starts_beside` starts from, where it is not the plain one."""

    @abstractmethod
    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The parameters; their number may depend on the number of joints."""

    def smaller_shape(self, scene: Scene) -> int | None:
        """How many of the parameters, from the first on, make up the shape in which the effect most often occurs; the others stay absent
        in it. None where all of them belong together."""
        del scene
        return None

    @abstractmethod
    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """The sensor's reading with the effect.

        Args:
            scene: the nominal run, causal: row k depends on rows up to k only. Of a run that comes in blocks, what an operator needs of
                earlier rows stands in its `scene.past(name)`, so blocks of any sizes give the wrench of the whole.
            w: (N, 6), what the nominal twin predicts, N and N m; offsets are not in it.
            theta: parameters, in the order of `parameters`. At their `absent` values the result equals `w`.
        """

    def explain_lack(self, scene: Scene) -> Message | None:
        """Why the model cannot be evaluated in this scene (no joints, no positions), None where it can."""
        del scene
        return None

    def explain_absence(self, scene: Scene) -> Message | None:
        """Why this recording cannot show the effect (the sensor stays still, no load changes its side ...), None where it can."""
        return self.explain_lack(scene)

    def explain_tie_to_run(self, scene: Scene) -> Message | None:
        """Why parameters found in this run have no meaning in another, or the effect cannot be simulated sample by sample; else None. A
        richer shape is of its run: a twin keeps the plain one."""
        del scene
        return Message.of("effect-shape-of-run") if self.wider_shape else None

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Parameters from which a fit may start, most promising first; a few where the likelihood has several hills (times, frequencies).

        Args:
            residual: (N, 6), measured minus predicted, in standard deviations of the noise.

        Returns:
            None at all where a richer shape sees no sign of itself in the residual, and is not to be fitted.
        """
        del residual
        return [np.array([p.absent + 0.3 * p.scale for p in self.parameters(scene)])]

    def starts_beside(self, scene: Scene, residual: Array, plain: Array) -> list[Array]:
        """The same of a richer shape, where the plain one (or the one that it names) with the parameters `plain` has left the residual;
        none where that shows no sign of it."""
        del scene, residual, plain
        return []

    @abstractmethod
    def advice(self, scene: Scene, theta: Array) -> Message:
        """What a person should do about it, one sentence in the imperative with its figures."""


@dataclass(frozen=True)
class Finding:
    """What a symptom found in a recording.

    Args:
        theta, std: values of the parameters and their uncertainty.
        sigma: how many standard deviations it stands above what chance gives.
        material: whether it matters by the effect's own measure (its docstring says which).
        times_expected: how many times what is stated or tolerated it is, by that measure; None where nothing is.
        message: what was seen, with its numbers.
    """

    theta: Array
    std: Array
    sigma: float
    material: bool
    times_expected: float | None
    message: Message


class Symptom(ABC):
    """An effect that does not change the wrench which the twin predicts, and is read off the recording directly: it explains no gap
    and stands beside the verdict. Stateless."""

    id: ClassVar[str]
    title: ClassVar[Message]
    stage: ClassVar[Stage]
    side: ClassVar[Side]
    explains: ClassVar[tuple[str, ...]] = ()
    """Symptoms that come along with this one, and are not named beside it; one that matters is, where this one does not,"""
    explains_when_small: ClassVar[bool] = False
    """unless this is set."""
    resembled_by: ClassVar[tuple[str, ...]] = ()
    """Effects whose trace in the recording looks like this symptom: beside them it is not named."""

    @abstractmethod
    def parameters(self, recording: Recording) -> tuple[Parameter, ...]:
        """The parameters; their number may depend on the number of joints."""

    @abstractmethod
    def observe(self, recording: Recording, view: View) -> Finding | None:
        """What the recording shows of it; None where the recording cannot show it or shows nothing."""

    @abstractmethod
    def advice(self, finding: Finding) -> Message:
        """What a person should do about it, one sentence in the imperative."""


@dataclass(frozen=True)
class View:
    """What has been worked out of a recording before symptoms are read off.

    Args:
        holds: rows of each motionless phase.
        noise_std: (6,), of one sample in the motionless phases, trends taken out.
        phi, phi_std: (10,), payload estimate; NaN where not determined.
        left: (K, 6), what the best explanation leaves of the wrench, windowed, N and N m; no rows where nothing was fitted.
        expected: (K, 6), what it predicts.
        left_t: (K,), times of these rows, s.
    """

    holds: tuple[slice, ...]
    noise_std: Array
    phi: Array
    phi_std: Array
    left: Array = field(default_factory=lambda: np.zeros((0, 6)))
    expected: Array = field(default_factory=lambda: np.zeros((0, 6)))
    left_t: Array = field(default_factory=lambda: np.zeros(0))
