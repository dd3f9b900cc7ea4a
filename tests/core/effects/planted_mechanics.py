"""Effects of mounting, kinematics, payload and environment as physics plants them, and the parameters that each should show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import fsolve
from scipy.spatial.transform import Rotation

from core.effects.base_tilt import BaseTilt
from core.effects.cable_drag import CableDrag
from core.effects.effect import Effect
from core.effects.external_contact import ExternalContact
from core.effects.gear_ripple import GearRipple
from core.effects.joint_backlash import AT_ONCE_S, JointBacklash
from core.effects.joint_elasticity import JointElasticity
from core.effects.joint_offset import JointOffset
from core.effects.payload_loose import PayloadLoose
from core.effects.payload_mass_change import PayloadMassChange
from core.effects.payload_shift import PayloadShift
from core.effects.scene import Scene
from core.effects.sensor_rotation import SensorRotation
from core.effects.sensor_translation import SensorTranslation
from core.effects.tool_flexibility import ToolFlexibility
from tests.core.effects.mass_on_slides import wrench_of_slides
from tests.core.effects.mechanical_truth import (
    ARM,
    MASSES,
    POINTS,
    Array,
    G,
    Path3,
    T,
    at_point,
    believed,
    brisk_load,
    brisk_scene,
    load,
    scene,
    truth,
)


@dataclass(frozen=True)
class Planted:
    """An effect as the physics of this file plants it, and the parameters that the effect should show."""

    effect: Effect
    theta: Array
    wrench: Callable[[], Array]
    rows: Callable[[], Array] = lambda: np.ones(len(T), bool)
    tolerance: float = 0.01
    """Of the change, r.m.s. over r.m.s."""
    fit_tolerance: float | Array = 0.05
    """Of each parameter, in its plausible size."""
    run: Callable[[], Scene] = scene
    alike: Callable[[Array], Array] = lambda theta: theta
    """Of all parameters that do the same to the wrench, the ones to compare."""
    name: str = ""

    @property
    def id(self) -> str:
        return f"{self.effect.id}-{self.name}".rstrip("-")


TURN, SHIFT, TILT = np.array([0.02, -0.03, 0.015]), np.array([0.003, -0.004, 0.002]), np.array([0.02, -0.012])
ZEROS = np.array([0.0, 0.012, -0.01, 0.015, 0.008, -0.01, 0.01])
COMPLIANCE = np.array([0.0, 2.0, 1.5, 2.5, 2.0, 1.0, 3.0]) * 1e-4
SOFT, SWING = 4 * COMPLIANCE, 0.08
SLIDES, RING_HZ, RING = np.array([[0.6, 0.8, 0.0], [0.0, 0.0, 1.0]]), np.array([4.5, 7.0]), 0.05
DISCS = np.array([[0.0, 6e-3, -4e-3, 5e-3, 8e-3, -5e-3, 4e-3], [0.0, -4e-3, 6e-3, 7e-3, -5e-3, 6e-3, 5e-3]])
PLAY, LAG = np.array([0.0, 12.0, 9.0, 15.0, 12.0, 18.0, 9.0]) * 1e-4, 0.04
RATIO, RIPPLE = 12.5, np.tile([4.0e-4, -3.0e-4], 7)
SLIP = np.array([0.012, -0.006, 0.01])
AT = 11.3
ADDED, PLACE = 0.2, np.array([0.04, -0.06, 0.1])
HZ, ZETA, ALONG, PART = 2.7, 0.06, np.array([0.6, 0.8, 0.0]), 3
ANCHOR, STIFFNESS, RUB, HOOK = np.array([0.3, -0.6, 1.4]), 6.0, 0.7, np.array([0.02, 0.03, 0.05])
PUSH, TOUCHED = np.array([3.0, -4.0, 6.0]), np.array([0.04, -0.03, 0.06])


def rippled(t: Array) -> Array:
    q = believed(t)
    return q + RIPPLE[0] * np.cos(2 * RATIO * q) + RIPPLE[1] * np.sin(2 * RATIO * q)


def slipped() -> Array:
    """The part in question sits at the centre of mass, which is the case that the effect assumes."""
    masses = np.append(MASSES, 0.0)
    com = MASSES @ POINTS / MASSES.sum()
    part = 0.5
    stays, goes = np.vstack([POINTS, com]), np.vstack([POINTS, com, com + SLIP / part])
    rigid = truth()
    return np.where(T[:, None] < AT, rigid.wrench(stays, masses), rigid.wrench(goes, np.array([*MASSES, -part, part])))


def loose() -> Array:
    """One point mass on a slide, as an ordinary differential equation in the rotating frame."""
    m, r, rigid = MASSES[PART], POINTS[PART], truth()
    n, still = rigid.motion, np.delete(np.arange(4), PART)
    b = CubicSpline(T, at_point(n, r, n.g))
    w = 2 * np.pi * HZ
    run = solve_ivp(
        lambda t, s: [s[1], -w * w * s[0] - 2 * ZETA * w * s[1] - ALONG @ b(t)],
        (T[0], T[-1]),
        [-ALONG @ b(T[0]) / w**2, 0.0],
        t_eval=T,
        rtol=1e-8,
        atol=1e-10,
    )
    u, du = run.y[:, :, None] * ALONG
    ddu = (-w * w * u - 2 * ZETA * w * du) - (b(T) @ ALONG)[:, None] * ALONG
    f = m * (at_point(n, r + u, n.g) + 2 * np.cross(n.omega, du) + ddu)
    return rigid.wrench(POINTS[still], MASSES[still]) + np.hstack([f, np.cross(r + u, f)])


def swung(loaded: float = 0.0, wind_up: float = 1.0, geared: Path3 = believed) -> Array:
    """Joints on springs behind motors whose motion is known, with the inertia of arm and point masses; the first joint is rigid. The
    springs are 1 + `loaded` times as stiff where they have given way by more than about `wind_up`, rad, and lie behind gears that would
    move stiff links as `geared` says."""
    J, soft = scene().jacobian, np.flatnonzero(SOFT)
    M = ARM + sum(
        m * np.einsum("nij,nik->njk", P, P) for m, P in zip(MASSES, (J[:, :3] - crossing(r) @ J[:, 3:] for r in POINTS), strict=True)
    )
    inertia, stiffness = CubicSpline(T, M[:, soft][:, :, soft]), 1 / SOFT[soft]
    ahead = [geared(T + h) - believed(T + h) for h in (-2e-4, 0.0, 2e-4)]
    asked = CubicSpline(T, np.einsum("nij,nj->ni", M[:, soft], (ahead[0] - 2 * ahead[1] + ahead[2]) / 4e-8))

    def pull(t: float) -> Array:
        return np.asarray(brisk_load(np.array([t]))[0, soft] + asked(t))

    def rate(t: float, state: Array) -> Array:
        e, de = state.reshape(2, -1)
        damping = 2 * SWING * np.sqrt(stiffness * np.diag(inertia(t)))
        return np.append(de, np.linalg.solve(inertia(t), -pull(t) - hold(e) - damping * de))

    def hold(e: Array) -> Array:
        return stiffness * (e + loaded * (e - wind_up * np.tanh(e / wind_up)))

    def rest(t: float) -> Array:
        return fsolve(lambda e: hold(e) + pull(t), -pull(t) / stiffness, xtol=1e-12)

    follows = np.append(rest(0.0), (rest(1e-4) - rest(-1e-4)) / 2e-4)
    deflection = solve_ivp(rate, (T[0], T[-1]), follows, method="DOP853", dense_output=True, rtol=1e-8, atol=1e-11).sol

    def true_joints(t: Array) -> Array:
        q = geared(t)
        q[:, soft] += deflection(t)[: len(soft)].T
        return q

    return truth(true_joints).wrench()


def crossing(r: Array) -> Array:
    """(3, 3), r x."""
    return -np.cross(np.eye(3), r).T


def ringing() -> Array:
    """The payload as a whole on two slides."""
    com = MASSES @ POINTS / MASSES.sum()
    return truth().wrench() + wrench_of_slides(T, truth().motion, MASSES.sum(), com, SLIDES, RING_HZ, RING)


def by_frequency(theta: Array) -> Array:
    """Modes have no order, and their shapes no sign: the lower one first, the largest translation positive."""
    shapes, order = theta[3:].reshape(2, 6), np.argsort(theta[:2])
    largest = np.take_along_axis(shapes, np.abs(shapes[:, :3]).argmax(axis=1)[:, None], axis=1)
    return np.array([*theta[:2][order], theta[2], *(shapes * np.sign(largest))[order].ravel()])


def pulled() -> Array:
    true = truth()
    p = true.p + true.R @ HOOK
    v = true.v + np.einsum("nij,nj->ni", true.R, np.cross(true.motion.omega, HOOK))
    F = STIFFNESS * (ANCHOR - p) - RUB * v / np.linalg.norm(v, axis=1, keepdims=True)
    f = np.einsum("nij,ni->nj", true.R, F)
    return true.wrench() - np.hstack([f, np.cross(HOOK, f)])


def pull() -> Array:
    true = truth()
    return STIFFNESS * (ANCHOR - true.p[0] - true.R[0] @ HOOK)


def touched(shape: Array) -> Array:
    true = truth()
    f = np.einsum("nij,i->nj", true.R, PUSH)
    push = np.hstack([f, np.cross(TOUCHED, f)])
    return true.wrench() - shape[:, None] * push


def inside() -> Array:
    return ((T >= 8.0) & (T <= 12.5)).astype(float)


def matrix_shares() -> list[float]:
    M = MASSES[PART] / MASSES.sum() * np.outer(ALONG, ALONG)
    return [M[0, 0], M[0, 1], M[0, 2], M[1, 1], M[1, 2], M[2, 2]]


PLANTED = [
    Planted(SensorRotation(), TURN, lambda: truth(turn=TURN).wrench()),
    Planted(SensorTranslation(), SHIFT, lambda: truth(shift=SHIFT).wrench()),
    Planted(BaseTilt(), TILT, lambda: truth().wrench(g=Rotation.from_rotvec([*TILT, 0.0]).apply(G))),
    Planted(
        JointOffset(),
        np.concatenate([ZEROS, *DISCS]),
        lambda: truth(lambda t: believed(t) + ZEROS + DISCS[0] * np.cos(believed(t)) + DISCS[1] * np.sin(believed(t))).wrench(),
        tolerance=0.02,
        fit_tolerance=0.05,
    ),
    Planted(
        JointElasticity(),
        np.array([*COMPLIANCE, 0.0, 0.1]),
        lambda: truth(lambda t: believed(t) - COMPLIANCE * load(t)).wrench(),
        tolerance=0.1,
        # loads this slow make nothing swing: inertia and damping are hardly seen here, but in the next case
        fit_tolerance=np.array([*[0.2] * 7, 2.5, 2.5]),
        name="quasi-static",
    ),
    Planted(
        JointElasticity(),
        np.array([*SOFT, 1.0, SWING]),
        swung,
        tolerance=0.15,  # swings of 3 to 8 Hz in rows at 62.5 Hz; a quasi-static arm is off by 0.68
        fit_tolerance=np.array([*[0.25] * 7, 0.1, 0.1]),
        run=brisk_scene,
        name="swinging",
    ),
    Planted(
        JointBacklash(),
        np.append(PLAY, [1.0, LAG, AT_ONCE_S]),
        lambda: truth(lambda t: believed(t) - PLAY * np.tanh(load(t, LAG))).wrench(),
        tolerance=0.25,  # the fastest contact changes sides within five rows
        # what comes late by the lag of the load comes late by that of the side as well
        fit_tolerance=np.array([*[0.2] * 8, 0.6, 0.4]),
    ),
    Planted(GearRipple(), np.tile([RATIO, *RIPPLE[:2]], 7), lambda: truth(rippled, h=2e-4).wrench(), tolerance=0.1, fit_tolerance=0.2),
    Planted(PayloadShift(), np.array([AT, *SLIP, 0.0]), slipped, rows=lambda: np.abs(T - AT) > 0.2, tolerance=0.03, fit_tolerance=0.1),
    Planted(
        PayloadMassChange(),
        np.array([AT, ADDED, *PLACE, 0.0]),
        lambda: truth().wrench() + (T[:, None] > AT) * truth().wrench(PLACE[None], np.array([ADDED])),
        rows=lambda: np.abs(T - AT) > 0.2,
    ),
    Planted(
        PayloadLoose(),
        np.array([HZ, ZETA, *matrix_shares(), 0.0, *(POINTS[PART] - MASSES @ POINTS / MASSES.sum()), *([0.0] * 6)]),
        loose,
        tolerance=0.06,
        fit_tolerance=0.2,
    ),
    Planted(
        ToolFlexibility(),
        np.array([*RING_HZ, RING, *np.hstack([SLIDES / np.sqrt(MASSES.sum()), np.zeros((2, 3))]).ravel()]),
        ringing,
        # of the second mode little more shows than how far it sags: shape and frequency make up for each other
        fit_tolerance=np.array([0.01, 0.1, 0.05, *[0.1] * 12]),
        alike=by_frequency,
    ),
    Planted(
        CableDrag(),
        np.array([STIFFNESS, *pull(), RUB, *HOOK, *[0.0] * 7]),
        pulled,
        tolerance=0.03,
        fit_tolerance=0.1,
    ),
    Planted(
        ExternalContact(),
        np.array([8.0, 4.5, 0.0, *PUSH, *TOUCHED]),
        lambda: touched(inside()),
        rows=lambda: (np.abs(T - 8.0) > 0.1) & (np.abs(T - 12.5) > 0.1),
        fit_tolerance=0.1,
    ),
]
