"""Runs of the virtual robot with faults on one short motion, and what the tests of the faults compare them with."""

import dataclasses
from functools import cache

import numpy as np

from core.payload.inertia import InertialParameters
from core.plant.faults import Setting
from core.plant.faults.fault import Machine
from core.plant.virtual_robot import VirtualRobot
from core.robot.model import RobotModel
from tests.core.plant.plant_oracle import CELLS, PinocchioArm, smooth_move

CELL = CELLS["lwr4_bench"]
PAYLOAD = CELL.payloads["steel_block"].parameters
HOME = np.array(CELL.robot.home_rad)
SETTING = Setting(CELL, PAYLOAD, seconds=1.4)
PERIOD = 0.001
SIGNAL = Machine(SETTING, None, None, slice(0, 7), PERIOD)
"""All that a fault of the signal path needs."""
AWAY = np.array([0.25, 0.2, -0.15, -0.3, 0.4, 0.5, 0.3])
ZERO = np.zeros(7)
SIX = np.array([10.0, -5.0, 20.0, 0.5, -0.3, 0.2])
EXACT = 1e-6
"""N and N m; two computations of the same wrench."""


@cache
def path():
    """0.2 s at rest, 0.5 s there, 0.2 s at rest, 0.4 s half-way back, 0.1 s at rest."""
    there, half = HOME + AWAY, HOME + 0.5 * AWAY
    still = [np.tile(q, (n, 1)) for q, n in ((HOME, 200), (there, 200), (half, 100))]
    return np.vstack((still[0], smooth_move(HOME, there, 0.5), still[1], smooth_move(there, half, 0.4), still[2]))


@dataclasses.dataclass(frozen=True)
class Run:
    t: np.ndarray
    q: np.ndarray
    dq: np.ndarray
    wrench: np.ndarray
    tau: np.ndarray
    true_q: np.ndarray
    true_dq: np.ndarray
    true_ddq: np.ndarray
    true_tau: np.ndarray
    true_wrench: np.ndarray


def run(*faults, along=None, cell=CELL, payload=PAYLOAD, seed=3):
    robot = VirtualRobot(cell, payload, np.random.default_rng(seed), faults=faults)
    along = path() if along is None else along
    rows = [(robot.step(q), robot.truth) for q in along]
    read = [np.array([getattr(s, name) for s, _ in rows]) for name in ("t", "q", "dq", "wrench", "tau")]
    true = [np.array([getattr(w, name) for _, w in rows]) for name in ("q", "dq", "ddq", "tau", "wrench")]
    return Run(*read, *true)


@cache
def clean():
    return run()


def still(q, seconds):
    return np.tile(q, (round(seconds * 1000), 1))


def rigid(run, phi=PAYLOAD.phi, gravity=CELL.gravity, offset=ZERO, every=9):
    """The wrench (6,) of Eq. (1) at every so many samples, from the true motion."""
    oracle = PinocchioArm.of(CELL, InertialParameters(phi), gravity)
    rows = range(0, len(run.t), every)
    return np.array([oracle.wrench(phi, run.true_q[k] + offset, run.true_dq[k], run.true_ddq[k]) for k in rows])


def sensor_pose(q):
    return RobotModel.of_cell(CELL).sensor_pose(q)


def through(hook, signal, start=0.0):
    """What a hook makes of a signal (N, 6)."""
    return np.array([hook(start + PERIOD * k, row) for k, row in enumerate(np.asarray(signal))])


def constant(seconds):
    return np.tile(SIX, (round(seconds / PERIOD), 1))


def sine(hz, seconds):
    return np.outer(np.sin(2 * np.pi * hz * PERIOD * np.arange(round(seconds / PERIOD))), SIX)


def triangle(height, quarter_s, quarters):
    turning = height * np.array([(0, 1, 0, -1)[k % 4] for k in range(quarters + 1)])
    return np.interp(np.arange(0, quarters * quarter_s, PERIOD), quarter_s * np.arange(quarters + 1), turning)


def felt_gravity(q):
    return sensor_pose(q).rotation.T @ CELL.gravity


def static(mass, first_moment, q=HOME):
    force = -mass * felt_gravity(q)
    return np.concatenate((force, np.cross(first_moment, -felt_gravity(q))))


def point(q, local):
    pose = sensor_pose(q)
    return pose.rotation @ local + pose.position
