"""One channel shows in another: a calibration matrix that does not fit the sensor."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.channels import SUFFIXES, say_load
from core.effects.effect import Effect, Parameter
from core.effects.scene import Scene
from core.payload.channels import CHANNELS, UNITS
from core.words.message import Message

PLAUSIBLE = 0.02
"""Share of a channel's full scale that another at full scale brings into it."""
ARM = 0.05
"""m, torque over force at full scale where the range is unknown."""
ROW, COLUMN = np.nonzero(~np.eye(6, dtype=bool))


class SensorCrosstalk(Effect):
    """`W = w + C (w cos a + |w| sin a)`, C with 30 entries off the diagonal; torques from forces in N m/N, forces from torques in N/(N m).

    The angle says which loads come through: 0 both directions with their signs (a calibration matrix), 45 deg pull only, -45 deg push only,
    90 deg both with the same sign (a joint that gapes).
    """

    id = "sensor_crosstalk"
    title = Message.of("effect-sensor-crosstalk-title")
    stage = "sensor"

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """The 30 entries of C off its diagonal, row by row, units of row per column, then the angle a, rad."""
        full = np.repeat([1.0, ARM], 3) if scene.range is None else scene.range
        entries = (self._entry(i, j, PLAUSIBLE * float(full[i] / full[j])) for i, j in zip(ROW.tolist(), COLUMN.tolist(), strict=True))
        return (*entries, Parameter("rectification_rad", "rad", 0.0, -np.pi, np.pi, 1.0))

    def _entry(self, i: int, j: int, scale: float) -> Parameter:
        name = f"{CHANNELS[i]}_from_{CHANNELS[j]}_{SUFFIXES[i]}_per_{SUFFIXES[j]}"
        return Parameter(
            name, "1" if UNITS[i] == UNITS[j] else f"{UNITS[i]}/({UNITS[j]})".replace("(N)", "N"), 0.0, -20 * scale, 20 * scale, scale
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w + C (w cos a + |w| sin a)`."""
        C = np.zeros((6, 6))
        C[ROW, COLUMN] = theta[:30]
        through = w * np.cos(theta[30]) + np.abs(w) * np.sin(theta[30])
        return np.asarray(w + through @ C.T)

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """No entries, with angles of -45 and 45 deg."""
        return [np.append(np.zeros(30), angle) for angle in (-0.25 * np.pi, 0.25 * np.pi)]  # the entries are linear: one step finds them

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a new calibration matrix, with the entry that is largest against its plausible size."""
        largest = int(np.abs(theta[:30] / [p.scale for p in self.parameters(scene)[:30]]).argmax())
        i, j = ROW[largest], COLUMN[largest]
        load, shown = say_load(1.0, j), say_load(theta[largest], i)
        return Message.of("advice-sensor-crosstalk", load=load, of_channel=CHANNELS[j], shown=shown, in_channel=CHANNELS[i])
