"""Mounting, kinematics, payload and environment: each effect against physics written here, and found again by a plain fit.

The physics: the true pose of the sensor as a function of time, differentiated numerically; the payload as point masses with Newton's law.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mass_on_slides import wrench_of_slides
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.cell import load_cell
from core.effects.base_tilt import BaseTilt
from core.effects.cable_drag import CableDrag
from core.effects.effect import Effect
from core.effects.external_contact import ExternalContact
from core.effects.gear_ripple import GearRipple
from core.effects.joint_backlash import JointBacklash
from core.effects.joint_elasticity import JointElasticity
from core.effects.joint_offset import JointOffset
from core.effects.oscillator import oscillate
from core.effects.payload_loose import PayloadLoose
from core.effects.payload_mass_change import PayloadMassChange
from core.effects.payload_shift import PayloadShift
from core.effects.rigid_body import rotation
from core.effects.scene import Scene
from core.effects.sensor_rotation import SensorRotation
from core.effects.sensor_translation import SensorTranslation
from core.effects.tool_flexibility import ToolFlexibility
from core.inertia import InertialParameters, Motion, regressor
from core.rigid_wrench import wrench
from core.robot import RobotModel

Array = np.ndarray
Path3 = Callable[[Array], Array]

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
G = np.array([0.0, 0.0, -9.81])
SIGMA = np.array([0.055, 0.048, 0.073, 0.0028, 0.003, 0.003])
T = np.arange(1500) / 62.5
POINTS = np.array([[0.05, 0.01, 0.09], [-0.06, 0.03, 0.05], [0.01, -0.05, 0.12], [0.0, 0.04, 0.16]])
MASSES = np.array([0.8, 0.5, 0.6, 0.4])
E0 = np.zeros(3)


@lru_cache
def robot() -> RobotModel:
    return RobotModel.of_cell(CELL)


def believed(t: Array) -> Array:
    """(N, 7), joints: sums of slow sines."""
    rng = np.random.default_rng(3)
    amplitude, frequency, phase = rng.uniform(0.2, 0.6, (3, 7)), rng.uniform(0.05, 0.35, (3, 7)), rng.uniform(0, 6, (3, 7))
    home = np.array([0.2, 0.5, -0.3, 1.2, 0.4, -0.8, 0.3])
    return home + sum(amplitude[i] * np.sin(2 * np.pi * frequency[i] * t[:, None] + phase[i]) for i in range(3))


@dataclass(frozen=True)
class Truth:
    """True motion of the sensor frame."""

    R: Array
    p: Array
    v: Array
    motion: Motion

    def wrench(self, points: Array = POINTS, masses: Array = MASSES, g: Array = G) -> Array:
        """(N, 6), Newton's law for point masses (K, 3), sensor axes."""
        w = np.zeros((len(self.R), 6))
        for r, m in zip(points, masses, strict=True):
            f = m * at_point(self.motion, r, self.R.transpose(0, 2, 1) @ g)
            w += np.hstack([f, np.cross(r, f)])
        return w


def at_point(motion: Motion, r: Array, g: Array) -> Array:
    """Specific force at r, sensor axes."""
    return motion.a - g + np.cross(motion.alpha, r) + np.cross(motion.omega, np.cross(motion.omega, r))


def truth(path: Path3 = believed, turn: Array = E0, shift: Array = E0, h: float = 1e-3) -> Truth:
    """Differentiates the pose of a sensor that is mounted turned and shifted."""

    def pose(t: Array) -> tuple[Array, Array]:
        poses = robot().sensor_poses(path(t))
        return poses.rotation @ Rotation.from_rotvec(turn).as_matrix(), poses.position + poses.rotation @ shift

    (R0, p0), (R1, p1), (R2, p2) = pose(T - h), pose(T), pose(T + h)
    Rt = R1.transpose(0, 2, 1)
    W, A = Rt @ ((R2 - R0) / (2 * h)), Rt @ ((R2 - 2 * R1 + R0) / h**2)

    def axial(M: Array) -> Array:
        return 0.5 * np.stack([M[:, 2, 1] - M[:, 1, 2], M[:, 0, 2] - M[:, 2, 0], M[:, 1, 0] - M[:, 0, 1]], axis=1)

    a = np.einsum("nij,ni->nj", R1, (p2 - 2 * p1 + p0) / h**2)
    return Truth(R1, p1, (p2 - p0) / (2 * h), Motion(Rt @ G, a, axial(W), axial(A)))


@lru_cache
def scene() -> Scene:
    nominal = truth()
    q, h = believed(T), 1e-5
    return Scene(
        t=T,
        phase=np.full(len(T), "transfer"),
        motion=nominal.motion,
        rotation=nominal.R,
        position=nominal.p,
        gravity=G,
        phi=sum(InertialParameters.from_com(m, r, np.zeros((3, 3))).phi for r, m in zip(POINTS, MASSES, strict=True)),
        q=q,
        dq=(believed(T + h) - believed(T - h)) / (2 * h),
        jacobian=np.stack([robot().sensor_jacobian(row) for row in q]),
        torque=load(T),
    )


def load(t: Array, lag: float = 0.0) -> Array:
    """(N, 7), joint torques that the scene states; they change sides slowly. Behind a lag, s: `1 / (1 + lag s)` of a sine that goes on."""
    omega = 0.35 * (1 + 0.1 * np.arange(7))
    size = np.array([30.0, 60.0, 20.0, 40.0, 10.0, 12.0, 4.0]) / np.hypot(1, omega * lag)
    return size * np.sin(omega * t[:, None] + np.arange(7) - np.arctan(omega * lag))


def brisk_load(t: Array) -> Array:
    """(N, 7), joint torques that jump from side to side within a tenth of a second, so that soft joints swing."""
    jumps = np.tanh(6 * np.sin(0.9 * t[:, None] * (1 + 0.1 * np.arange(7)) + 2 * np.arange(7)))
    return 0.25 * load(t) + np.array([4.0, 8.0, 3.0, 6.0, 2.0, 2.0, 1.0]) * jumps


@lru_cache
def brisk_scene() -> Scene:
    """A heavy arm that is loaded briskly."""
    return replace(scene(), torque=brisk_load(T), link_inertia=np.broadcast_to(ARM, (len(T), 7, 7)))


def change(effect: Effect, theta: Array, run: Scene | None = None) -> Array:
    run = scene() if run is None else run
    return effect.wrench(run, run.nominal, np.asarray(theta, dtype=float)) - run.nominal


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
SOFT, ARM, SWING = 4 * COMPLIANCE, np.diag([1.0, 4.0, 2.0, 3.0, 1.0, 0.6, 0.3]), 0.08
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


def swung() -> Array:
    """Joints on springs behind motors whose motion is known, with the inertia of arm and point masses; the first joint is rigid."""
    J, soft = scene().jacobian, np.flatnonzero(SOFT)
    M = ARM + sum(
        m * np.einsum("nij,nik->njk", P, P) for m, P in zip(MASSES, (J[:, :3] - crossing(r) @ J[:, 3:] for r in POINTS), strict=True)
    )
    inertia, stiffness = CubicSpline(T, M[:, soft][:, :, soft]), 1 / SOFT[soft]

    def pull(t: float) -> Array:
        return brisk_load(np.array([t]))[0, soft]

    def rate(t: float, state: Array) -> Array:
        e, de = state.reshape(2, -1)
        damping = 2 * SWING * np.sqrt(stiffness * np.diag(inertia(t)))
        return np.append(de, np.linalg.solve(inertia(t), -pull(t) - stiffness * e - damping * de))

    follows = -np.append(pull(0.0), (pull(1e-4) - pull(-1e-4)) / 2e-4) / np.tile(stiffness, 2)
    deflection = solve_ivp(rate, (T[0], T[-1]), follows, method="DOP853", dense_output=True, rtol=1e-8, atol=1e-11).sol

    def true_joints(t: Array) -> Array:
        q = believed(t)
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
        np.append(PLAY, [1.0, LAG]),
        lambda: truth(lambda t: believed(t) - PLAY * np.tanh(load(t, LAG))).wrench(),
        tolerance=0.25,  # the fastest contact changes sides within five rows
        fit_tolerance=np.array([*[0.2] * 8, 0.05]),
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
        np.array([STIFFNESS, *pull(), RUB, *HOOK, *[0.0] * 6]),
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
each = pytest.mark.parametrize("case", PLANTED, ids=[case.id for case in PLANTED])


def rms(x: Array) -> float:
    return float(np.sqrt(np.mean((x / SIGMA) ** 2)))


@each
def test_the_effect_does_to_the_wrench_what_physics_does(case: Planted) -> None:
    rows, true = case.rows(), case.wrench() - truth().wrench()
    assert rms(true[rows]) > 0.3, "nothing was planted"
    assert rms((change(case.effect, case.theta, case.run()) - true)[rows]) < case.tolerance * rms(true[rows])


@lru_cache
def nuisance() -> Array:
    """(6 N, 16), orthonormal: what payload and offsets can take up, in standard deviations."""
    Z = np.concatenate([regressor(scene().motion), np.broadcast_to(np.eye(6), (len(T), 6, 6))], axis=2) / SIGMA[:, None]
    return np.linalg.qr(Z.reshape(-1, 16))[0]


def without_nuisance(y: Array) -> Array:
    return y - nuisance() @ (nuisance().T @ y)


@dataclass(frozen=True)
class Fit:
    theta: Array
    std: Array
    closure: float
    """Share of the power above the noise that is gone."""


def fitted(effect: Effect, measured: Array, noise: float, run: Scene | None = None) -> Fit:
    """Plain bounded least squares from each of the effect's starts, payload and offsets projected out, with the effect's prior."""
    run = scene() if run is None else run
    parameters = effect.parameters(run)
    absent, scale, lower, upper = np.array([[p.absent, p.scale, p.lower, p.upper] for p in parameters]).T
    residual = without_nuisance(((measured - run.nominal) / SIGMA).ravel())
    floor = noise**2 * (residual.size - 16)
    excess = residual @ residual - floor

    def cost(theta: Array) -> Array:
        return np.append(residual - without_nuisance((change(effect, theta, run) / SIGMA).ravel()), (theta - absent) / scale)

    fits = []
    for start in effect.starts(run, residual.reshape(-1, 6)):
        bounds = (lower - 1e-12, upper + 1e-12)
        fit = least_squares(cost, np.clip(start, lower, upper), bounds=bounds, x_scale=scale, max_nfev=30, ftol=1e-6, xtol=1e-6)
        closure = 1 - (2 * fit.cost - floor) / excess
        fits.append(Fit(fit.x, np.sqrt(np.diag(np.linalg.inv(fit.jac.T @ fit.jac))), closure))
        if closure > 0.97:
            break
    return max(fits, key=lambda fit: fit.closure)


@each
@pytest.mark.parametrize("noise", [0.0, 1.0])
def test_a_plain_fit_finds_what_was_planted(case: Planted, noise: float) -> None:
    measured = case.wrench() + noise * SIGMA * np.random.default_rng(1).normal(size=(len(T), 6)) + [3, -2, 1, 0.1, 0.2, -0.1]
    fit = fitted(case.effect, measured, noise, case.run())
    parameters = case.effect.parameters(case.run())
    scale = np.array([p.scale for p in parameters])
    assert fit.closure > 0.95
    assert (fit.std < 0.3 * scale).mean() >= 0.5, "nothing was learnt of half of the parameters"
    off = (np.abs(case.alike(fit.theta) - case.theta) - 4 * fit.std) / scale
    assert (off < case.fit_tolerance).all(), {p.name: x for p, x in zip(parameters, off, strict=True) if x > case.fit_tolerance}


def test_hard_contact_shifts_a_joint_by_all_of_its_play_while_it_is_pushed_to_one_side() -> None:
    """A second derivative from the rows before, twice four of them, sees a change of sides up to seven rows later."""
    pushed = (np.abs(load(T)) > 1.5).all(axis=1)
    settled = np.convolve(~pushed, np.ones(8))[: len(T)] == 0
    true = truth(lambda t: believed(t) - PLAY * np.sign(load(t))).wrench() - truth().wrench()
    found = change(JointBacklash(), np.append(PLAY, [0.1, 0.003]))
    assert settled.mean() > 0.4
    assert rms(true[settled]) > 0.5
    assert rms((found - true)[settled]) < 0.02 * rms(true[settled])


def test_half_a_sine_of_contact_is_explained_by_a_tapered_window() -> None:
    shape = inside() * np.sin(np.pi * np.clip((T - 8.0) / 4.5, 0, 1))
    fit = fitted(ExternalContact(), touched(shape), 0.0)
    assert fit.closure > 0.98
    assert fit.theta[0] + 0.5 * fit.theta[1] == pytest.approx(10.25, abs=0.1)
    np.testing.assert_allclose(fit.theta[3:6], PUSH, rtol=0.1)


@pytest.mark.parametrize("along", [[0, 0, -1], [0, 1, 0], [-1, 0, 0], [0.8, 0, -0.6]])
def test_a_base_on_the_wall_tilts_about_the_axes_that_turn_gravity(along: list[float]) -> None:
    gravity = 9.81 * np.array(along)
    rigid = truth()
    wall = replace(scene(), gravity=gravity, motion=replace(scene().motion, g=rigid.R.transpose(0, 2, 1) @ gravity))
    parameters = BaseTilt().parameters(wall)
    vector = np.zeros(3)
    theta = np.array([0.01, -0.02])
    for parameter, value in zip(parameters, theta, strict=True):
        vector["xyz".index(parameter.name[len("about_")])] = value
    true = rigid.wrench(g=Rotation.from_rotvec(vector).apply(gravity)) - rigid.wrench(g=gravity)
    np.testing.assert_allclose(BaseTilt().wrench(wall, wall.nominal, theta) - wall.nominal, true, atol=1e-6)
    moved = [rms(BaseTilt().wrench(wall, wall.nominal, unit) - wall.nominal) for unit in 0.01 * np.eye(2)]
    assert min(moved) > 0.5


def test_without_joint_torques_the_payload_alone_bends_the_joints() -> None:
    bare, nominal = replace(scene(), torque=None), truth().wrench()
    stated = replace(scene(), torque=np.einsum("nij,ni->nj", np.stack([robot().sensor_jacobian(row) for row in believed(T)]), nominal))
    for effect, theta in ((JointElasticity(), np.array([*COMPLIANCE, 0.0, 0.1])), (JointBacklash(), np.append(PLAY, [0.5, 0.01]))):
        np.testing.assert_allclose(effect.wrench(bare, nominal, theta), effect.wrench(stated, nominal, theta), atol=1e-5)


def test_a_zero_of_the_first_joint_changes_nothing_where_that_joint_is_vertical() -> None:
    assert rms(change(JointOffset(), np.array([0.05, *[0.0] * 20]))) < 1e-3


@pytest.mark.parametrize(
    ("amplitude", "shown"),
    [
        # at one size, a joint near the tool moves the payload too little: its ripple drowns in the highest of some 200 peaks of noise
        (np.full(7, 1e-4), 6),
        (np.array([1.0, 1.0, 1.0, 1.0, 3.0, 3.0, 6.0]) * 1e-4, 7),
    ],
    ids=["alike", "larger near the tool"],
)
def test_the_gear_ratio_of_every_joint_whose_ripple_stands_out_is_in_the_start_of_the_fit(amplitude: Array, shown: int) -> None:
    slow = replace(scene(), dq=0.15 * scene().dq, t=T / 0.15)
    ratios = np.array([81.0, 81.0, 50.5, 100.0, 60.0, 50.5, 81.0])
    theta = np.column_stack([ratios, amplitude, -amplitude])
    planted = change(GearRipple(), theta.ravel(), slow)
    alone = [change(GearRipple(), np.where(np.arange(7)[:, None] == j, theta, 0.0).ravel(), slow) for j in range(7)]
    stands_out = np.array([rms(x) for x in alone]) * np.sqrt(planted.size) > 4.0  # standard deviations, which of 200 peaks none reaches
    assert stands_out.sum() == shown
    (start,) = GearRipple().starts(slow, planted / SIGMA + np.random.default_rng(4).normal(size=planted.shape))
    half_width = 0.5 * np.pi / np.ptp(slow.q, axis=0)  # of a peak over the angle that a joint sweeps
    off = np.abs(start[::3] - ratios)
    assert (off < half_width)[stands_out].all(), off
    assert off[np.argsort([-rms(x) for x in alone])[:4]].max() < 0.5


@pytest.mark.parametrize("damping", [0.02, 0.999999, 1.0, 1.4])
def test_an_oscillator_follows_its_differential_equation_whatever_its_damping(damping: float) -> None:
    t = np.arange(200) * 0.02
    u = np.column_stack([np.sin(3 * t), np.cos(5 * t) + t])
    w = 2 * np.pi * 4.0
    ramp = CubicSpline(t, u)  # close to straight between samples
    run = solve_ivp(
        lambda x, s: np.append(s[2:], w * w * (ramp(x) - s[:2]) - 2 * damping * w * s[2:]),
        (0, t[-1]),
        [*u[0], 0, 0],
        t_eval=t,
        rtol=1e-9,
        atol=1e-9,
    )
    y, rate, acceleration = oscillate(u, 0.02, 4.0, damping)
    np.testing.assert_allclose(y, run.y[:2].T, atol=5e-3)
    np.testing.assert_allclose(rate, run.y[2:].T, atol=0.05)
    np.testing.assert_allclose(acceleration, w * w * (u - y) - 2 * damping * w * rate, atol=1e-9)


@pytest.mark.parametrize("effect", [case.effect for case in PLANTED if case.effect.stage == "kinematics"], ids=lambda effect: effect.id)
def test_a_recording_of_poses_says_why_it_shows_nothing_of_the_joints(effect: Effect) -> None:
    poses = replace(scene(), q=None, dq=None, jacobian=None, torque=None)
    assert effect.missing(poses) == "the recording has no joint positions"
    assert effect.missing(scene()) is None


def test_what_cannot_show_is_said() -> None:
    still = replace(scene(), motion=Motion.still(scene().motion.g))
    assert SensorTranslation().missing(still) is not None
    assert CableDrag().missing(replace(scene(), position=None)) is not None
    assert CableDrag().missing(replace(scene(), position=np.ones((len(T), 3)))) is not None
    assert JointBacklash().missing(replace(scene(), torque=np.full((len(T), 7), 5.0))) is not None
    assert all(case.effect.missing(scene()) is None for case in PLANTED)


@each
def test_the_advice_names_what_to_do_with_numbers(case: Planted) -> None:
    advice = case.effect.advice(scene(), case.theta)
    assert advice[0].isupper()
    assert advice.endswith(".")
    assert any(c.isdigit() for c in advice)
    assert "nan" not in advice


def test_advice_is_given_in_everyday_units() -> None:
    assert "-1.15 deg about x" in BaseTilt().advice(scene(), TILT)  # the base stands turned against gravity's turn
    assert "+3.0, -4.0 and +2.0 mm" in SensorTranslation().advice(scene(), SHIFT)
    assert "gained 200 g" in PayloadMassChange().advice(scene(), np.array([AT, ADDED, *PLACE, 0.0]))
    assert "7.8 N from 8.0 to 12.5 s" in ExternalContact().advice(scene(), np.array([8.0, 4.5, 0.0, *PUSH, *TOUCHED]))


@settings(max_examples=30)
@given(st.lists(st.floats(-0.3, 0.3), min_size=3, max_size=3))
def test_rotation_vectors_turn_as_scipy_turns_them(vector: list[float]) -> None:
    np.testing.assert_allclose(rotation(np.array(vector)), Rotation.from_rotvec(vector).as_matrix(), atol=1e-14)


@settings(max_examples=20)
@given(st.lists(st.floats(-2.0, 2.0), min_size=10, max_size=10))
def test_the_compiled_wrench_is_the_regressors(phi: list[float]) -> None:
    np.testing.assert_allclose(wrench(scene().motion, np.array(phi)), regressor(scene().motion) @ np.array(phi), atol=1e-9)


def test_the_starts_of_steps_and_windows_are_within_a_few_samples_of_the_truth() -> None:
    noise = np.random.default_rng(6).normal(size=(len(T), 6))

    def first_start(effect: Effect, measured: Array) -> Array:
        residual = without_nuisance(((measured - scene().nominal) / SIGMA + noise).ravel())
        return effect.starts(scene(), residual.reshape(-1, 6))[0]

    gained = truth().wrench() + (T[:, None] > AT) * truth().wrench(PLACE[None], np.array([ADDED]))
    assert first_start(PayloadMassChange(), gained)[0] == pytest.approx(AT, abs=0.05)
    assert first_start(PayloadShift(), slipped())[0] == pytest.approx(AT, abs=0.05)
    np.testing.assert_allclose(first_start(ExternalContact(), touched(inside()))[:2], [8.0, 4.5], atol=0.1)
