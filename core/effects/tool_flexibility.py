"""The tool between sensor and payload is flexible: it gives way and rings."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.oscillator import oscillate, spectral_peaks
from core.effects.scene import Scene
from core.effects.window_search import columns_of_payload_and_offsets, weights
from core.payload.inertia import spatial_inertia
from core.payload.rotations import cross
from core.words.message import Message

MODES = 2
SHAPE = (
    *((f"{axis}_per_sqrtkg", "1/sqrt(kg)", 5.0, 0.5) for axis in "xyz"),
    *((f"about_{axis}_per_msqrtkg", "1/(m sqrt(kg))", 50.0, 5.0) for axis in "xyz"),
)
"""Name, unit, bound and plausible size of the six numbers of a mode shape."""

DAMPING = 0.05
"""Of the modes that are looked for."""
ROWS = 4000
"""The search looks at no more rows than about this many."""
PAIRS = [(i, j) for i in range(6) for j in range(i, 6)]


class ToolFlexibility(Effect):
    """The payload moves against the sensor in two modes, twists `xi eta`: `eta'' + 2 zeta w eta' + w^2 eta = -xi^T w_rigid`.

    Mode shapes xi are normalised by mass (Ewins, Modal testing, 2000): `xi^T M xi` is the share of the payload that a mode moves, M its
    spatial inertia. The mode adds the inertial wrench `M xi eta''`, and its displaced first moment s the torque `s x (a - g)`: the tool
    sags as well as it rings.
    """

    id = "tool_flexibility"
    title = Message.of("effect-tool-flexibility-title")
    stage = "payload"
    only_adds = True
    needs_motion = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Two frequencies, Hz, one damping ratio, and two mode shapes (6 each), normalised by mass, sensor frame."""
        highest = min(60.0, 0.45 / scene.period)
        lowest = min(4.0, 0.2 * highest)
        middle = min(20.0, 0.5 * highest)
        return (
            *(Parameter(f"mode_{k + 1}_frequency_hz", "Hz", middle, lowest, highest, 10.0) for k in range(MODES)),
            Parameter("damping_ratio", "1", 0.05, 0.002, 1.0, 0.1),
            *(Parameter(f"mode_{k + 1}_{name}", unit, 0.0, -most, most, size) for k in range(MODES) for name, unit, most, size in SHAPE),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus, for each mode, the inertial wrench `M xi eta''` and the torque `s x (a - g)` of its displaced first moment."""
        M, b = spatial_inertia(scene.phi), scene.motion.a - scene.motion.g
        for k, shape in enumerate(_shapes(theta)):
            force = -(scene.nominal @ shape)[:, None]
            y, _, dds = oscillate(force, scene.period, theta[k], theta[MODES], scene.past(f"mode {k}"))
            w = w + _answer(M @ shape, b, y, dds) / (2.0 * np.pi * theta[k]) ** 2
        return w

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Where the residual's spectrum has peaks, and the frequencies of a grid that explain most of it; with the shapes that do."""
        frequency = self.parameters(scene)[0]
        search = _Search(scene, residual)
        peaks = [search(f) for f in spectral_peaks(residual, scene.period, frequency.lower, frequency.upper, 2)]
        grid = [search(float(f)) for f in np.geomspace(1.5 * frequency.lower, frequency.upper, 6)[:-1]]
        grid.sort(key=lambda explained: -explained[0])
        starts = [np.concatenate(([f, min(1.1 * f, frequency.upper), DAMPING], shapes)) for _, f, shapes in (*peaks, *grid[:2])]
        if len(peaks) == MODES:
            starts.append(np.concatenate(([f for _, f, _ in peaks], [DAMPING], *(shapes[:6] for *_, shapes in peaks))))
        return starts

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises a stiffer tool or smoother motion: frequency, Hz, of the mode that moves the larger share, and damping, %."""
        M = spatial_inertia(scene.phi)
        k = int(np.argmax([shape @ M @ shape for shape in _shapes(theta)]))
        return Message.of("advice-tool-flexibility", frequency_hz=theta[k], damping_ratio=theta[MODES])


def _shapes(theta: Array) -> Array:
    """(MODES, 6)."""
    return theta[MODES + 1 :].reshape(MODES, 6)


def _answer(moment: Array, b: Array, y: Array, dds: Array) -> Array:
    """(N, 6), wrench of a mode that moves by y (N, 1) with `moment` (6,) per rate, in the field b (N, 3)."""
    w = dds * moment
    w[:, 3:] += y * cross(moment[:3], b)
    return w


class _Search:
    """Modes of one frequency are linear in `B = sum xi xi^T`: fitted to what rings, by least squares.

    Payload, offsets and the sag, which modes of all frequencies have alike, are fitted along with it.

    Args:
        scene: the nominal run.
        residual: (N, 6), in standard deviations of the noise.
    """

    def __init__(self, scene: Scene, residual: Array) -> None:
        self.scene = scene
        self.rows = slice(0, None, max(1, len(scene) // ROWS))
        self.weights = weights(scene)
        self.unit = np.array([size for *_, size in SHAPE])
        self.moments = spatial_inertia(scene.phi) * self.unit
        self.force = -scene.nominal * self.unit
        sag = self.columns(self.force, np.zeros_like(self.force))
        known = np.concatenate([columns_of_payload_and_offsets(scene, self.rows).reshape(-1, 16), sag], axis=1)
        self.known, _ = np.linalg.qr(known / np.maximum(np.linalg.norm(known, axis=0), 1e-12))
        self.residual = self.remove_known(residual[self.rows].reshape(-1, 1))[:, 0]

    def remove_known(self, x: Array) -> Array:
        """What payload, offsets and sag leave of columns."""
        return np.asarray(x - self.known @ (self.known.T @ x))

    def columns(self, y: Array, dds: Array) -> Array:
        """Wrench of each element of B, in the rows and weights of the search, for answers (N, 6) of an oscillator to each force."""
        b, y, dds = (self.scene.motion.a - self.scene.motion.g)[self.rows], y[self.rows], dds[self.rows]
        elements = []
        for i, j in PAIRS:
            element = _answer(self.moments[:, i], b, y[:, [j]], dds[:, [j]])
            if i != j:
                element = element + _answer(self.moments[:, j], b, y[:, [i]], dds[:, [i]])
            elements.append(element * self.weights)
        return np.stack(elements, axis=2).reshape(-1, len(PAIRS))

    def __call__(self, frequency_hz: float) -> tuple[float, float, Array]:
        """Sum of squares explained, the frequency, and shapes of the largest modes, one behind the other."""
        y, _, dds = oscillate(self.force, self.scene.period, frequency_hz, DAMPING)
        A = self.remove_known(self.columns(y, dds)) / (2.0 * np.pi * frequency_hz) ** 2
        N, right = A.T @ A, A.T @ self.residual
        found = np.linalg.solve(N + np.eye(len(N)) + 1e-6 * np.diag(np.diag(N)), right)
        B = np.zeros((6, 6))
        for (i, j), value in zip(PAIRS, found, strict=True):
            B[i, j] = B[j, i] = value
        size, direction = np.linalg.eigh(B)
        shapes = self.unit[:, None] * direction[:, -MODES:] * np.sqrt(np.maximum(size[-MODES:], 1e-3))
        return float(right @ found), frequency_hz, shapes.T[::-1].ravel()
