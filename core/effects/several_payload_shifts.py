"""The payload, or a part of it, slips several times: a clamp that gives way again and again."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Parameter
from core.effects.payload_shift import PayloadShift
from core.effects.scene import Scene
from core.effects.window_search import best_steps
from core.payload.inertia import regressor
from core.words.message import Message

SHIFTS = 3
SIGN = 0.25
"""Share of the residual's square that the best two have to explain, or there is no sign of several."""
START_KG_M = 0.005


class SeveralPayloadShifts(PayloadShift):
    """The first moment moves by d_k from t_k on, at once, three times; two in the smaller shape. Each as `PayloadShift` has one."""

    wider_shape = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Time and change of the first moment of each, the first one's by their own names."""
        one = super().parameters(scene)[:4]
        later = (Parameter(f"jump_{k}_{p.name}", p.unit, p.absent, p.lower, p.upper, p.scale) for k in range(2, SHIFTS + 1) for p in one)
        return (*one, *later)

    def smaller_shape(self, scene: Scene) -> int:
        """Two."""
        return 8

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus the wrenches of all shifts."""
        for at_s, *moment in theta.reshape(SHIFTS, 4):
            if any(moment):
                w = super().wrench(scene, w, np.array([at_s, *moment, 0.0]))
        return w

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """The three times, and the two, at which jumps of the first moment explain most of the residual; none where two explain little."""
        columns = regressor(scene.motion)[:, :, 1:4]
        two, three = best_steps(scene, residual, columns, SHIFTS)
        if two.share < SIGN:
            return []
        absent = [p.absent for p in self.parameters(scene)[:4]]
        shifts = [np.column_stack((steps.times, START_KG_M * steps.directions)) for steps in (three, two)]
        return [shifts[0].ravel(), np.vstack((shifts[1], absent)).ravel()]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises clamping more firmly: from when to when, s, and the largest change of the first moment, kg mm."""
        shifts = [shift for shift in theta.reshape(SHIFTS, 4) if shift[1:].any()]
        times, sizes = [float(shift[0]) for shift in shifts], [float(np.linalg.norm(shift[1:])) for shift in shifts]
        if len(shifts) < 2:
            return super().advice(scene, theta[:5])
        return Message.of("advice-payload-shift-several", first_s=min(times), last_s=max(times), first_moment_kg_m=max(sizes))
