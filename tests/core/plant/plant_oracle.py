"""What the plant is compared with: Pinocchio on the same URDF, and the paper's Eq. (1) written out."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio as pin

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.payload.inertia import PINOCCHIO_ORDER, InertialParameters
from core.plant.mechanics import Drives
from core.robot.model import RobotModel

CELLS = {name: load_cell(Path(__file__).parents[3] / "cells" / name) for name in ("lwr4_bench", "ur5e_line")}
CARRIED = [(cell, payload) for cell in CELLS.values() for payload in cell.payloads]
NAMES = [f"{cell.name}-{payload}" for cell, payload in CARRIED]


@dataclass
class PinocchioArm:
    """The cell's arm with the payload welded to the sensor frame, in the world frame."""

    model: pin.Model
    data: pin.Data
    sensor: int

    @classmethod
    def of(cls, cell: Cell, payload: InertialParameters, gravity: np.ndarray) -> "PinocchioArm":
        robot = RobotModel.of_cell(cell)
        model = robot.model.copy()
        model.gravity.linear = gravity
        frame = model.frames[robot.sensor_frame_id]
        if payload.mass > 0:
            body = pin.Inertia.FromDynamicParameters(payload.phi[PINOCCHIO_ORDER])
            model.appendBodyToJoint(frame.parentJoint, body, frame.placement)
        return cls(model, model.createData(), robot.sensor_frame_id)

    def acceleration(self, drives: Drives, q: np.ndarray, dq: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """Forward dynamics with rotor inertia and viscous friction."""
        effort = np.array(self.model.upperEffortLimit)
        self.model.armature = drives.armature_s2 * effort
        return np.array(pin.aba(self.model, self.data, q, dq, tau - drives.damping_s * effort * dq))

    def wrench(self, phi: np.ndarray, q: np.ndarray, dq: np.ndarray, ddq: np.ndarray) -> np.ndarray:
        """Eq. (1) with Pinocchio's kinematics, without this project's regressor."""
        pin.forwardKinematics(self.model, self.data, q, dq, ddq)
        R = pin.updateFramePlacement(self.model, self.data, self.sensor).rotation
        local = pin.ReferenceFrame.LOCAL
        a = pin.getFrameClassicalAcceleration(self.model, self.data, self.sensor, local).linear
        alpha = pin.getFrameAcceleration(self.model, self.data, self.sensor, local).angular
        omega = pin.getFrameVelocity(self.model, self.data, self.sensor, local).angular
        b = a - R.T @ self.model.gravity.linear
        m, mc = phi[0], phi[1:4]
        xx, xy, xz, yy, yz, zz = phi[4:]
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        f = m * b + np.cross(alpha, mc) + np.cross(omega, np.cross(omega, mc))
        tau = inertia @ alpha + np.cross(omega, inertia @ omega) + np.cross(mc, b)
        return np.concatenate((f, tau))


def smooth_move(start: np.ndarray, end: np.ndarray, seconds: float, period: float = 0.001) -> np.ndarray:
    """(N, n) positions along a polynomial of fifth degree, at rest on both ends."""
    s = np.linspace(0.0, 1.0, round(seconds / period) + 1)[1:]
    return start + np.outer(s**3 * (10 - 15 * s + 6 * s**2), end - start)


def opposed_trapezoids(start: np.ndarray, joint: int, rate: float, acceleration: float = 4.8) -> np.ndarray:
    """(N, n) positions of the paper's test motion, made by one joint: there and back, then 1 s at rest."""
    ramp = np.linspace(0, rate, round(rate / acceleration / 0.001))
    there = np.concatenate((ramp, np.full(200, rate), ramp[::-1]))
    angle = 0.001 * np.cumsum(np.concatenate((there, -there, np.zeros(1000))))
    return start + np.outer(angle, np.eye(len(start))[joint])
