"""Joints and tools on springs, against their equations of motion solved here by an adaptive integrator."""

from __future__ import annotations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.optimize import fsolve

from core.effects.deflection import LINEAR, Spring, deflection
from core.effects.memory import Memory
from core.effects.scene import Scene
from core.effects.tool_flexibility import ToolFlexibility
from core.payload.inertia import InertialParameters
from tests.core.effects.mass_on_slides import wrench_of_slides
from tests.core.effects.synthetic_scene import scene

Array = np.ndarray
T = np.arange(800) / 200.0
INERTIA = np.array([[2.0, 0.4], [0.4, 0.5]])
STIFFNESS = np.array([2500.0, 4000.0])
LOAD = np.column_stack([30.0 * np.sin(2.0 * T) + 8.0 * np.tanh(20 * (T - 1.5)), 12.0 * np.cos(3.0 * T) - 4.0 * np.tanh(30 * (T - 2.0))])
ZETA = 0.08


HARD = Spring(loaded=1.6, wind_up=2e-3)
"""2.6 times as stiff where they have given way by more than 2 mrad."""


def swing(spring: Spring = LINEAR) -> tuple[np.ndarray, np.ndarray]:
    """Deflection (N, 2), rad, of springs that may harden, and its second derivative, rad/s2."""
    load = CubicSpline(T, LOAD)
    damping = 2 * ZETA * np.sqrt(STIFFNESS * np.diag(INERTIA))

    def hold(e: np.ndarray) -> np.ndarray:
        return np.asarray(STIFFNESS * (e + spring.loaded * (e - spring.wind_up * np.tanh(e / spring.wind_up))))

    def rate(t: float, state: np.ndarray) -> np.ndarray:
        e, de = state[:2], state[2:]
        return np.concatenate([de, np.linalg.solve(INERTIA, -load(t) - hold(e) - damping * de)])

    rest = fsolve(lambda e: hold(e) + LOAD[0], -LOAD[0] / STIFFNESS, xtol=1e-12)
    stiff = STIFFNESS * (1.0 + spring.loaded * np.tanh(rest / spring.wind_up) ** 2)
    y = solve_ivp(rate, (0, T[-1]), [*rest, *(-load(0.0, 1) / stiff)], t_eval=T, rtol=1e-9, atol=1e-12).y.T
    return y[:, :2], np.array([rate(t, row)[2:] for t, row in zip(T, y, strict=True)])


def test_coupled_joints_swing_as_their_equation_of_motion_says() -> None:
    e, dde = deflection(np.broadcast_to(INERTIA, (len(T), 2, 2)), LOAD, 1 / STIFFNESS, ZETA, 0.005)
    true, acceleration = swing()
    ringing = true + LOAD / STIFFNESS
    assert np.abs(ringing).max() > 1e-3, "nothing swings"
    assert np.sqrt(np.mean((e - true) ** 2)) < 0.05 * np.sqrt(np.mean(ringing**2))
    assert np.sqrt(np.mean((dde - acceleration) ** 2)) < 0.15 * np.sqrt(np.mean(acceleration**2))


LOSS = Spring(turned=1.5, bend=1e-3)
"""Dahl's friction beside each spring: 2.5 times as stiff after a turn back, over 1 mrad."""


def swing_and_lose() -> np.ndarray:
    """(N, 2), rad; with a state more for each joint, `ds = (1 - sign(de) s) de / b`."""
    load, (stiffer, bend) = CubicSpline(T, LOAD), LOSS[:2]
    damping = 2 * ZETA * np.sqrt(STIFFNESS * np.diag(INERTIA))

    def rate(t: float, state: np.ndarray) -> np.ndarray:
        e, de, s = state[:2], state[2:4], state[4:]
        pull = -load(t) - STIFFNESS * (e + stiffer * bend * s) - damping * de
        return np.concatenate([de, np.linalg.solve(INERTIA, pull), (1.0 - np.sign(de) * s) * de / bend])

    start = np.concatenate([-LOAD[0] / STIFFNESS, -load(0.0, 1) / STIFFNESS, [0.0, 0.0]])
    return solve_ivp(rate, (0, T[-1]), start, t_eval=T, rtol=1e-8, atol=1e-11, max_step=2e-3).y.T[:, :2]


def test_springs_that_lose_swing_as_their_equation_of_motion_with_dahl_s_friction_says() -> None:
    e, _ = deflection(np.broadcast_to(INERTIA, (len(T), 2, 2)), LOAD, 1 / STIFFNESS, ZETA, 0.005, spring=LOSS)
    true, without = swing_and_lose(), swing()[0]
    lost = np.sqrt(np.mean((true - without) ** 2))
    assert lost > 5e-4, "nothing is lost"
    assert np.sqrt(np.mean((e - true) ** 2)) < 0.05 * lost


def test_springs_that_harden_swing_as_their_equation_of_motion_says() -> None:
    e, _ = deflection(np.broadcast_to(INERTIA, (len(T), 2, 2)), LOAD, 1 / STIFFNESS, ZETA, 0.005, spring=HARD)
    true, without = swing(HARD)[0], swing()[0]
    harder = np.sqrt(np.mean((true - without) ** 2))
    assert harder > 5e-4, "nothing hardens"
    assert np.sqrt(np.mean((e - true) ** 2)) < 0.05 * harder


def test_without_inertia_joints_give_quasi_statically() -> None:
    e, _ = deflection(np.zeros((len(T), 2, 2)), LOAD, np.array([4e-4, 0.0]), ZETA, 0.005)
    np.testing.assert_allclose(e, -LOAD * [4e-4, 0.0], atol=2e-5)


def test_a_tool_on_a_slide_sags_and_rings_like_a_mass_on_a_spring() -> None:
    run = scene(rate=200.0, seconds=8.0)
    axis, frequency, zeta = np.array([0.6, 0.0, 0.8]), 9.0, 0.04
    m, c = run.phi[0], run.phi[1:4] / run.phi[0]
    true = wrench_of_slides(run.t, run.motion, m, c, axis[None], np.array([frequency]), zeta)
    theta = np.array([frequency, 20.0, zeta, *(axis / np.sqrt(m)), *[0.0] * 9])
    change = ToolFlexibility().wrench(run, run.nominal, theta) - run.nominal
    assert np.abs(true[:, :3]).max() > 0.1
    assert np.sqrt(np.mean((change - true) ** 2, axis=0)).max() < 0.02 * np.sqrt(np.mean(true**2))


def test_gravity_makes_a_tool_that_nods_softer_where_it_stands_on_its_hinge_and_stiffer_where_it_hangs() -> None:
    run = scene(rate=200.0, seconds=12.0)
    m, pivot, lever, axis = 1.3, np.array([0.01, 0.0, 0.02]), np.array([0.0, 0.0, 0.15]), np.array([0.0, 1.0, 0.0])
    run = run.with_phi(InertialParameters.from_com(m, pivot + lever, np.zeros((3, 3))).phi)
    frequency, zeta, J = 4.0, 0.02, m * 0.15**2
    true = _wrench_of_nodding_mass(run, m, pivot, lever, axis, frequency, zeta)
    shape = np.concatenate((np.cross(pivot, axis), axis)) / np.sqrt(J)
    theta = np.array([frequency, 20.0, zeta, *shape, *[0.0] * 6])
    change = ToolFlexibility().wrench(run, run.nominal, theta) - run.nominal
    held = run.phase == "hold:free"  # elsewhere it is whirled about as well, which slow modes leave out
    error, size = (np.sqrt(np.mean(x[held] ** 2, axis=0)) for x in (change - true, true))
    assert size[0] > 0.01, "nothing rings"
    assert error[0] < 0.1 * size[0]  # without gravity's part as large as what rings
    assert error[4] < 0.03 * size[4]


def _wrench_of_nodding_mass(run: Scene, m: float, pivot: Array, lever: Array, axis: Array, frequency: float, zeta: float) -> Array:
    """(N, 6), what a point mass on a sprung hinge asks more of the sensor than a rigid one: Newton's law, solved as a large angle's."""
    motion = [CubicSpline(run.t, x) for x in (run.motion.a - run.motion.g, run.motion.omega, run.motion.alpha)]
    w, J = 2.0 * np.pi * frequency, m * float(lever @ lever)

    def turn(angle: float) -> Array:
        return np.asarray(np.cos(angle) * lever + np.sin(angle) * np.cross(axis, lever))

    def field(t: float, at: Array) -> Array:
        b, omega, alpha = (each(t) for each in motion)
        return np.asarray(b + np.cross(alpha, at) + np.cross(omega, np.cross(omega, at)))

    def bend(t: float, angle: float, rate: float) -> float:
        arm = turn(angle)
        return float(-(w**2) * angle - 2.0 * zeta * w * rate - m / J * axis @ np.cross(arm, field(t, pivot + arm)))

    still = fsolve(lambda angle: bend(run.t[0], float(angle[0]), 0.0), 0.0, xtol=1e-12)[0]
    y = solve_ivp(lambda t, s: [s[1], bend(t, *s)], (run.t[0], run.t[-1]), [still, 0.0], t_eval=run.t, rtol=1e-9, atol=1e-11).y.T
    added = np.zeros((len(run), 6))
    for k, (t, (angle, rate)) in enumerate(zip(run.t, y, strict=True)):
        arm, rigid = turn(angle), m * field(t, pivot + lever)
        velocity = rate * np.cross(axis, arm)
        acceleration = bend(t, angle, rate) * np.cross(axis, arm) + rate * np.cross(axis, velocity)
        force = m * (field(t, pivot + arm) + 2.0 * np.cross(motion[1](t), velocity) + acceleration)
        added[k] = np.concatenate((force - rigid, np.cross(pivot + arm, force) - np.cross(pivot + lever, rigid)))
    return added


def test_deflection_goes_on_where_the_last_block_ended() -> None:
    inertia, memory = np.broadcast_to(INERTIA, (len(T), 2, 2)), Memory()
    whole, _ = deflection(inertia, LOAD, 1 / STIFFNESS, ZETA, 0.005, spring=LOSS)
    parts = [
        deflection(inertia[k : k + 37], LOAD[k : k + 37], 1 / STIFFNESS, ZETA, 0.005, memory["x"], spring=LOSS)[0]
        for k in range(0, len(T), 37)
    ]
    np.testing.assert_allclose(np.concatenate(parts), whole, atol=1e-12)
