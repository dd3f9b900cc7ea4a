"""Causes that no effect describes, in numpy."""

from __future__ import annotations

import numpy as np

from bench.calibration.mechanics import between, shape, unit
from bench.calibration.stage import PERIOD_S, Play


@shape("unknown")
def air_drag(p: Play) -> None:
    """A sail: a force against the speed, by its square."""
    v = np.gradient(p.place, PERIOD_S, axis=0) + np.einsum("nij,nj->ni", p.run.rotation, np.cross(p.run.omega, [0.0, 0.0, 0.25]))
    p.push(-between(p, 1.0, 8.0) * v * np.linalg.norm(v, axis=1)[:, None], np.array([0.0, 0.0, 0.25]))


@shape("unknown")
def compass(p: Play) -> None:
    """A magnetised part turns towards one direction of the room: torque, no force."""
    torque = np.cross(between(p, 0.008, 0.06) * unit(p.rng), p.to_sensor(unit(p.rng)))
    p.wrench = p.wrench + np.hstack((np.zeros_like(torque), torque))


@shape("unknown")
def bent_link(p: Play) -> None:
    """A link that bends with its angle: the joint reads right, the rest of the arm is turned by the square of it."""
    joint, other = p.rng.permutation(p.read.shape[1] - 1)[:2]
    q = p.run.q[:, joint] - p.run.q[:, joint].mean()
    p.read[:, other] += np.radians(between(p, 1.0, 4.0)) * (q / np.abs(q).max()) ** 2


@shape("unknown")
def press_next_door(p: Play) -> None:
    """Every few seconds a shock through the floor that rings at a few hertz."""
    t, cycle, hz = p.run.t - p.run.t[0], p.rng.uniform(2.0, 5.0), p.rng.uniform(2.0, 6.0)
    since = (t + p.rng.uniform(0, cycle)) % cycle
    ringing = between(p, 0.4, 2.0) * np.exp(-since / 0.35) * np.sin(2.0 * np.pi * hz * since)
    f = p.body.mass * p.to_sensor(np.outer(ringing, unit(p.rng)))
    p.wrench = p.wrench + np.hstack((f, np.cross(p.body.phi[1:4] / p.body.mass, f)))


@shape("unknown")
def draught(p: Play) -> None:
    """Wind in gusts, across the room, on a large payload."""
    t = p.run.t - p.run.t[0]
    gusts = sum(a * np.sin(2.0 * np.pi * f * t + b) for a, f, b in p.rng.uniform([0.3, 0.1, 0], [1.0, 0.8, 6.0], (5, 3)))
    p.push(np.outer(between(p, 1.0, 4.0) * (1.0 + gusts), unit(p.rng)), np.array([0.0, 0.02, 0.15]))


@shape("unknown")
def filling_hose(p: Play) -> None:
    """A hose on the payload fills and empties, as the height of the wrist goes: mass and place change together."""
    height = p.place[:, 2]
    fill = (height - height.min()) / np.ptp(height)
    f = between(p, 0.01, 0.1) * p.specific * (fill * (1.0 + fill))[:, None]
    p.wrench = p.wrench + np.hstack((f, np.cross([0.05, 0.0, 0.1], f)))


@shape("unknown")
def sticky_seal(p: Play) -> None:
    """A seal between flange and payload: a torque against the turning about z, more the more it is pressed."""
    pressed = np.abs(p.wrench[:, 2]) / np.abs(p.wrench[:, 2]).max()
    slow = np.tanh(p.run.omega[:, 2] / 0.05)
    p.wrench[:, 5] += -between(p, 0.01, 0.1) * slow * (0.3 + pressed)
