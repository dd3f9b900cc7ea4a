"""The tool between sensor and payload is flexible: it gives way and rings."""

from __future__ import annotations

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.oscillator import oscillate, oscillate_in_field, spectral_peaks
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
LEAST_SQUARE = 1e-3
"""Of a mode's size, in plausible ones, at the start of a fit."""
PEAKS = 3
"""Of the residual's spectrum whose frequencies are tried."""
FIRSTS = 3
"""Frequencies from which fits start: each for both modes, and the first beside the others."""
ROWS = 4000
"""The search looks at no more rows than about this many."""
PAIRS = [(i, j) for i in range(6) for j in range(i, 6)]


class ToolFlexibility(Effect):
    """The payload moves against the sensor in two modes, twists `xi eta`: `eta'' + 2 zeta w eta' + (w^2 + k) eta = -xi^T w_rigid`.

    Mode shapes xi are normalised by mass (Ewins, Modal testing, 2000): `xi^T M xi` is the share of the payload that a mode moves, M its
    spatial inertia. The mode adds the inertial wrench `M xi eta''`, and its displaced first moment s the torque `s x (a - g)`: the tool
    sags as well as it rings. One that nods stands on its hinge or hangs from it, and gravity makes it softer or stiffer, by
    `k = (a - g) . (omega x s')`, omega the angular part of xi and s' the first moment that it displaces per eta: what turns by eta lifts
    by `omega x s' eta^2 / 2`.
    """

    id = "tool_flexibility"
    title = Message.of("effect-tool-flexibility-title")
    stage = "payload"
    only_adds = True
    needs_motion = True
    followed = 2

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
            moved = M @ shape
            field = b @ np.cross(shape[3:], moved[:3])
            y, _, dds = oscillate_in_field(-(scene.nominal @ shape), field, scene.period, theta[k], theta[MODES], scene.past(f"mode {k}"))
            w = w + _answer(moved, b, y[:, None], dds[:, None])
        return w

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Where the residual's spectrum has peaks, and the frequencies of a grid that explain most of it; with the shapes that do."""
        frequency = self.parameters(scene)[0]
        search = _Search(scene, residual)
        grid = np.geomspace(1.5 * frequency.lower, frequency.upper, 6)[:-1]
        tried = [*spectral_peaks(residual, scene.period, frequency.lower, frequency.upper, PEAKS), *map(float, grid)]
        first, *others = sorted(map(search, tried), key=lambda explained: -explained[0])[:FIRSTS]
        starts = [np.concatenate(([f, min(1.1 * f, frequency.upper), DAMPING], shapes)) for _, f, shapes in (first, *others)]
        starts += [np.concatenate(([first[1], f, DAMPING], first[2][:6], shapes[:6])) for _, f, shapes in others]
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
        known = columns_of_payload_and_offsets(scene, self.rows).reshape(-1, 16)
        self.known = _span(known)
        self.known_and_sag = _span(np.concatenate([known, sag], axis=1))
        self.residual = residual[self.rows].ravel()

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
        columns = self.columns(y, dds) / (2.0 * np.pi * frequency_hz) ** 2
        A, r = _remove(self.known_and_sag, columns), _remove(self.known_and_sag, self.residual)
        N, right = A.T @ A, A.T @ r
        found = np.linalg.solve(N + np.eye(len(N)) + 1e-6 * np.diag(np.diag(N)), right)
        B = np.zeros((6, 6))
        for (i, j), value in zip(PAIRS, found, strict=True):
            B[i, j] = B[j, i] = value
        size, direction = np.linalg.eigh(B)
        direction, square = direction[:, -MODES:], np.maximum(size[-MODES:], 0.0)
        each = _remove(self.known, columns @ np.array([direction[i] * direction[j] for i, j in PAIRS]))
        # modes are never less than nothing, and these sag, too: of both as much as explains most, and of the payload no more than all
        change = each @ square
        square = square * np.clip(change @ self.residual / max(float(change @ change), 1e-12), 0.0, 1.0)
        directions = self.unit[:, None] * direction
        moved = np.einsum("ik,ij,jk->k", directions, spatial_inertia(self.scene.phi), directions)
        square = np.minimum(square, 1.0 / np.maximum(moved, 1e-12))
        change = each @ square
        explained = float(change @ (2.0 * self.residual - change))
        return explained, frequency_hz, (directions * np.sqrt(np.maximum(square, LEAST_SQUARE))).T[::-1].ravel()


def _span(columns: Array) -> Array:
    """An orthonormal basis of what columns span."""
    return np.asarray(np.linalg.qr(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-12))[0])


def _remove(basis: Array, x: Array) -> Array:
    """What is left of columns without what the basis spans."""
    return np.asarray(x - basis @ (basis.T @ x))
