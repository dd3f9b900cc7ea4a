"""A run on a base that is turned against gravity: an arm that is read anew from its URDF, and point masses on its sensor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from core.recording.recording import Recording
from tests.independent_arm import Arm
from tests.synthetic import GRAVITY, Run, payload, record, run_of, wrench_of

Array = np.ndarray
BODY = payload("steel_block", "ur5e_line")


@cache
def run() -> Run:
    return run_of("ur5e_line", 0, repetitions=1, period=0.008)


@cache
def arm() -> Arm:
    described = run().robot.description
    return Arm(described.urdf, Path(), described.base_frame, described.sensor_frame, np.eye(4))


def with_gravity_turned(by: Array) -> Recording:
    """By rotation vectors (N, 3) in base axes, small angles of second order; the run has axes of its own."""
    turned = by @ (run().rotation[0] @ arm().sensor_poses(run().q[:1])[0, :3, :3].T).T
    across = np.cross(turned, GRAVITY)
    g = GRAVITY + across + 0.5 * np.cross(turned, across)
    still = record(run(), BODY, np.random.default_rng(1))
    return replace(still, wrench=still.wrench + wrench_of(run(), BODY, g) - wrench_of(run(), BODY))
