"""The uncertainty budget of the ten parameters in the sense of the GUM (JCGM 100:2008): what this recording adds, and what else may be off.

Type A is the repeatability: what another recording of the same payload with the same robot and sensor would scatter by. Type B is what
stays the same from recording to recording: gains and cross-talk of the sensor, gravity, zeros of the joints, mounting. The sources know
nothing of each other, so that their variances add.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.words.message import Message

REPEATABILITY: Final = "repeatability"
ASSUMED = {
    "sensor_gain": Message.of("estimation-assumed-gain"),
    "sensor_crosstalk": Message.of("estimation-assumed-crosstalk"),
    "gravity": Message.of("estimation-assumed-gravity"),
    "joint_zeros": Message.of("estimation-assumed-zeros"),
    "sensor_mount": Message.of("estimation-assumed-mount"),
    "torque_gain": Message.of("torques-assumed-gain"),
    "arm_model": Message.of("torques-assumed-arm"),
}
"""What is said of a source whose size nobody has stated."""
TITLES = {
    REPEATABILITY: Message.of("estimation-source-repeatability"),
    "sensor_gain": Message.of("estimation-source-sensor-gain"),
    "sensor_crosstalk": Message.of("estimation-source-sensor-crosstalk"),
    "joint_zeros": Message.of("estimation-source-joint-zeros"),
    "sensor_mount": Message.of("estimation-source-sensor-mount"),
    "gravity": Message.of("estimation-source-gravity"),
    "torque_gain": Message.of("torques-source-gain"),
    "arm_model": Message.of("torques-source-arm"),
    "twin": Message.of("estimation-source-twin"),
}
"""What each part of a budget is called."""
MATTERS = 0.1
"""Share of a parameter's variance from which an assumed source is worth a sentence."""


@dataclass(frozen=True)
class Source:
    """One cause of uncertainty that stays the same from recording to recording.

    Args:
        name: `sensor_gain`, `sensor_crosstalk`, `joint_zeros`, `sensor_mount`, `gravity`, `torque_gain`, `arm_model`, or `twin`.
        stated: whether the cell or the recording states its size; assumed otherwise.
        directions: (10, n), change of the parameters for one standard deviation of each of its independent causes.
    """

    name: str
    stated: bool
    directions: Array

    @property
    def std(self) -> Array:
        """(10,), its standard uncertainty in each parameter."""
        return np.asarray(np.sqrt((self.directions**2).sum(axis=1)))


@dataclass(frozen=True)
class Budget:
    """Where the uncertainty of an estimate comes from.

    Args:
        repeatability: (10, 10), covariance by this recording alone (type A).
        sources: the rest (type B).
    """

    repeatability: Array
    sources: tuple[Source, ...] = ()

    @property
    def covariance(self) -> Array:
        """(10, 10), all together."""
        return np.asarray(sum((source.directions @ source.directions.T for source in self.sources), start=self.repeatability.copy()))

    @property
    def parts(self) -> dict[str, Array]:
        """Name of each part, the repeatability first -> its standard uncertainties (10,)."""
        first = np.sqrt(np.maximum(np.diag(self.repeatability), 0.0))
        return {REPEATABILITY: first, **{source.name: source.std for source in self.sources}}

    @property
    def largest(self) -> tuple[str, ...]:
        """Of each parameter, the part that contributes most."""
        names, sizes = list(self.parts), np.array(list(self.parts.values()))
        return tuple(names[int(k)] for k in np.argmax(sizes, axis=0))

    def assumptions(self, known: NDArray[np.bool_]) -> tuple[Message, ...]:
        """What nobody has stated and yet matters to a parameter that is known (10,), most important first."""
        total = np.diag(self.covariance)
        shares = {source.name: float(np.max((source.std**2 / total)[known], initial=0.0)) for source in self.sources if not source.stated}
        names = sorted((name for name, share in shares.items() if share > MATTERS), key=lambda name: -shares[name])
        return tuple(ASSUMED[name] for name in names)
