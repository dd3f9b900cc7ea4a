"""A part of the payload is loose: it gives way under gravity and swings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.effects.effect import Effect, Parameter
from core.effects.hanging import GRAVITY, hang
from core.effects.oscillator import oscillate, spectral_peaks
from core.effects.rigid_body import centre_of_mass
from core.effects.scene import Scene
from core.effects.vectors import add_force, find_specific_force, load_of_moment, turn, turn_back
from core.payload.inertia import symmetric
from core.payload.rotations import cross
from core.words.message import Message

SHARES = ("xx", "xy", "xz", "yy", "yz", "zz")


class PayloadLoose(Effect):
    """A part at r is sprung, `u'' + 2 zeta w u' + w^2 u = -b` in sensor axes, b the specific force `a - g` at r; another one hangs from r
    and swings in all directions, as often under gravity.

    What is sprung is given by a symmetric matrix of shares of the payload's mass, `s = m S u` (kg m): `S = share e e^T` for a part on a
    slide along e, `share 1` for one that is free in all directions. Its first moment s adds
    `f = s'' + 2 omega x s' + alpha x s + omega x (omega x s)` and `tau = r x f + s x b`. What the moving frame does to the swing itself
    is left out there, as is `s x s''`. Both may swing already when the recording begins.
    """

    id = "payload_loose"
    title = Message.of("effect-payload-loose-title")
    stage = "payload"
    only_adds = True
    needs_motion = True

    def parameters(self, scene: Scene) -> tuple[Parameter, ...]:
        """Frequency, Hz, damping ratio, six shares that are sprung, the share that hangs, place (3), m, from the centre of mass, and
        displacement and rate at the start (3 each), m/s2."""
        return (
            Parameter("frequency_hz", "Hz", 3.0, 0.5, min(10.0, 0.4 / scene.period), 2.0),
            Parameter("damping_ratio", "1", 0.05, 0.003, 1.5, 0.15),
            *(Parameter(f"moving_{axes}_share", "1", 0.0, -1.0, 1.0, 0.15) for axes in SHARES),
            Parameter("hanging_share", "1", 0.0, -1.0, 1.0, 0.15),
            *(Parameter(f"place_{axis}_m", "m", 0.0, -0.3, 0.3, 0.05) for axis in "xyz"),
            *(Parameter(f"start_{axis}_m_per_s2", "m/s2", 0.0, -20.0, 20.0, 2.0) for axis in "xyz"),
            *(Parameter(f"start_rate_{axis}_m_per_s2", "m/s2", 0.0, -20.0, 20.0, 2.0) for axis in "xyz"),
        )

    def wrench(self, scene: Scene, w: Array, theta: Array) -> Array:
        """`w` plus force and moment about the sensor origin of the sprung and of the hanging part, sensor axes."""
        part = _Part(theta)
        m = scene.motion
        r = centre_of_mass(scene) + part.place
        b = find_specific_force(m, r)
        f, tau = (
            sprung + hanging
            for sprung, hanging in zip(_compute_sprung_load(scene, part, b), _compute_hanging_load(scene, part, b), strict=True)
        )
        return np.asarray(add_force(w, f, r, tau))

    def starts(self, scene: Scene, residual: Array) -> list[Array]:
        """Sprung or hanging where the residual's spectrum has peaks, and sprung over the plausible range."""
        upper = self.parameters(scene)[0].upper
        peaks = spectral_peaks(residual, scene.period, 0.8, upper, 2)
        grid = [f for f in (1.0, 2.0, 4.0) if f < upper]
        kinds = {"sprung": 0.05 * np.array([1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0]), "hanging": 0.05 * np.eye(7)[6]}
        tried = [*((f, kind) for f in peaks for kind in kinds), *((f, "sprung") for f in grid)]
        return [np.array([f, 0.05, *kinds[kind], *[0.0] * 9]) for f, kind in tried]

    def advice(self, scene: Scene, theta: Array) -> Message:
        """Advises fastening the loose part: share of the mass, %, sag or length, mm, and frequency, Hz."""
        part = _Part(theta)
        sag_m = GRAVITY / part.angular_frequency**2
        sprung, hanging = float(np.abs(np.linalg.eigvalsh(part.shares)).max()), abs(part.hanging_share)
        if hanging > sprung:
            return Message.of("advice-payload-loose-hanging", mass_share=hanging, sag_m=sag_m, frequency_hz=part.frequency_hz)
        return Message.of("advice-payload-loose", mass_share=sprung, sag_m=sag_m, frequency_hz=part.frequency_hz)


def add_moved(scene: Scene, w: Array, moved: Array) -> Array:
    """`w` (N, 6), N and N m, with a first moment that has moved by `moved` (N, 3), kg m, sensor axes, so slowly that its own motion adds
    nothing."""
    m, still = scene.motion, np.zeros_like(moved)
    f, tau = load_of_moment(m.omega, m.alpha, m.a - m.g, moved, still, still)
    return np.asarray(add_force(w, f, np.zeros(3), tau))


def _compute_sprung_load(scene: Scene, part: _Part, b: Array) -> tuple[Array, Array]:
    """Force and torque about its place, (N, 3) each, that the sprung part adds; b (N, 3) is the specific force there."""
    start = np.stack([part.start, part.angular_frequency * part.start_rate])
    swing = oscillate(b, scene.period, part.frequency_hz, part.damping, scene.past("sprung"), start)
    s, ds, dds = (-scene.phi[0] / part.angular_frequency**2 * y @ part.shares for y in swing)
    f, tau = load_of_moment(scene.motion.omega, scene.motion.alpha, b, s, ds, dds)
    return f, tau


def _compute_hanging_load(scene: Scene, part: _Part, b: Array) -> tuple[Array, Array]:
    """The same of the hanging part."""
    R, m = scene.rotation, part.hanging_share * scene.phi[0]
    b_base, omega = turn(R, b), turn(R, scene.motion.omega)
    start = np.stack([-b_base[0] - R[0] @ part.start, -part.angular_frequency / GRAVITY * (R[0] @ part.start_rate)])
    x, ddx = hang(b_base, omega, scene.period, part.frequency_hz, part.damping, start, scene.past("hanging"))
    f = m * turn_back(R, ddx)
    return f, cross(turn_back(R, x), m * b + f)


@dataclass(frozen=True)
class _Part:
    """The parameters by name."""

    theta: Array

    @property
    def frequency_hz(self) -> float:
        return float(self.theta[0])

    @property
    def angular_frequency(self) -> float:
        """rad/s."""
        return 2.0 * float(np.pi) * self.frequency_hz

    @property
    def damping(self) -> float:
        return float(self.theta[1])

    @property
    def shares(self) -> Array:
        """(3, 3)."""
        return symmetric(self.theta[2:8])

    @property
    def hanging_share(self) -> float:
        return float(self.theta[8])

    @property
    def place(self) -> Array:
        """(3,), m, from the centre of mass."""
        return self.theta[9:12]

    @property
    def start(self) -> Array:
        """(3,), displacement when the recording begins, as the specific force that would hold it, m/s2."""
        return self.theta[12:15]

    @property
    def start_rate(self) -> Array:
        """(3,), its rate over the angular frequency, m/s2."""
        return self.theta[15:18]
