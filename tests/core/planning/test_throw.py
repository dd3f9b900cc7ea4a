from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.cell.cell import Box, Capsule, Cell, Cylinder, Pose, Sphere, Zone
from core.cell.folder import load_cell
from core.planning.throw import PAD_M, ThrowCheck, loads_of
from core.robot.decoupling import decoupling_profile
from core.robot.trajectory import AngularProfile

CELL = load_cell(Path(__file__).parents[3] / "cells" / "lwr4_bench")
BOX = CELL.payloads["steel_block"].box
X = np.array([1.0, 0.0, 0.0])
PROFILE = decoupling_profile(BOX, cartesian_speed=0.25, period=0.002, excursion=0.3)


def cell_with(*shapes: object) -> Cell:
    return CELL.model_copy(update={"zones": tuple(Zone(name=f"zone{k}", shape=shape) for k, shape in enumerate(shapes))})


def distance(shape: Sphere | Capsule | Cylinder, points: np.ndarray) -> np.ndarray:
    """Of points (N, 3) from the surface, negative inside."""
    local = (points - shape.pose.translation) @ shape.pose.rotation
    if isinstance(shape, Cylinder):
        over = np.column_stack([np.linalg.norm(local[:, :2], axis=1) - shape.radius_m, np.abs(local[:, 2]) - shape.length_m / 2])
        return np.linalg.norm(np.maximum(over, 0.0), axis=1) + np.minimum(over.max(axis=1), 0.0)
    if isinstance(shape, Capsule):
        local[:, 2] -= np.clip(local[:, 2], -shape.length_m / 2, shape.length_m / 2)
    return np.linalg.norm(local, axis=1) - shape.radius_m


def brute_force(cell: Cell, box: Box, axis: np.ndarray, profile: AngularProfile | None, R: np.ndarray, p: np.ndarray) -> float:
    """Least distance of any flight, from many releases and a fine grid of times."""
    moments = [(0.0, 0.0)] if profile is None else list(zip(profile.angle[::40], profile.rate[::40], strict=True))
    centre = box.pose.translation
    ball = np.linalg.norm(box.corners[0] - centre)
    least = np.inf
    for angle, rate in moments:
        for k, point in enumerate([centre, *box.corners]):
            arm = R @ Rotation.from_rotvec(angle * axis).apply(point)
            velocity = np.cross(rate * (R @ axis), arm)
            t = np.arange(0.0, 2.0, 0.004)[:, None]
            flight = p + arm + velocity * t + 0.5 * cell.gravity * t**2
            flight = flight[(flight[:, 2] >= cell.floor_z_m) | (t[:, 0] == 0.0)]
            for zone in cell.zones:
                least = min(least, float(distance(zone.shape, flight).min()) - (ball if k == 0 else 0.0))
    return least


@settings(max_examples=15)
@given(st.integers(0, 2**32 - 1), st.booleans())
def test_the_nearest_flight_is_the_one_that_brute_force_finds(seed, held):
    rng = np.random.default_rng(seed)
    shapes = [
        Sphere(kind="sphere", radius_m=0.2, pose=Pose(xyz_m=tuple(rng.uniform(-0.7, 0.7, 3).tolist()))),
        Capsule(
            kind="capsule",
            radius_m=0.1,
            length_m=0.4,
            pose=Pose(xyz_m=tuple(rng.uniform(-0.7, 0.7, 3).tolist()), rpy_rad=(0.5, 0.3, 0.0)),
        ),
        Cylinder(
            kind="cylinder",
            radius_m=0.12,
            length_m=0.3,
            pose=Pose(xyz_m=tuple(rng.uniform(-0.7, 0.7, 3).tolist()), rpy_rad=(0.2, 1.0, 0.0)),
        ),
    ]
    cell, profile = cell_with(*shapes), None if held else PROFILE
    R, p = Rotation.random(rng=rng).as_matrix(), rng.uniform(-0.3, 0.6, 3)
    throw = ThrowCheck(cell).nearest(loads_of(BOX, X, profile), R, p)
    expected = brute_force(cell, BOX, X, profile, R, p) - PAD_M
    assert expected - 0.012 <= throw.distance_m <= max(1.12 * expected, expected) + 0.012


@given(st.integers(0, 2**32 - 1))
def test_a_load_that_falls_into_a_box_is_found(seed):
    rng = np.random.default_rng(seed)
    zone = Box(size_m=(0.4, 0.4, 0.4), pose=Pose(xyz_m=(0.0, 0.0, -0.5), rpy_rad=(0.0, 0.0, 0.3)))
    cell = cell_with(zone)
    R = Rotation.random(rng=rng).as_matrix()
    over, beside = np.array([0.0, 0.0, rng.uniform(0.2, 0.8)]), np.array([0.9, 0.0, rng.uniform(0.2, 0.8)])
    loads = loads_of(BOX, X, PROFILE)
    assert ThrowCheck(cell).nearest(loads, R, over).distance_m < 0.0
    assert ThrowCheck(cell).nearest(loads, R, beside).distance_m > 0.0


def test_a_load_is_thrown_to_the_side_to_which_it_moves():
    """The box in front of the axis moves to +y or -y only: of two walls at the same distance the one on that side is nearer."""
    box = Box(size_m=(0.02, 0.02, 0.02), pose=Pose(xyz_m=(0.0, 0.0, 0.2)))
    rate = np.full(50, 1.2)
    profile = AngularProfile(0.001, np.zeros(50), rate)
    wall = [Box(size_m=(2.0, 0.1, 3.0), pose=Pose(xyz_m=(0.0, y, 0.0))) for y in (0.4, -0.4)]
    R = np.column_stack(([0, 0, 1.0], [0, 1.0, 0], [-1.0, 0, 0]))  # sensor x up, sensor z, and with it the box, along world -x
    check = ThrowCheck(cell_with(*wall))
    assert check.nearest(loads_of(box, X, profile), R, np.zeros(3)).zone == "zone1"
    backwards = AngularProfile(0.001, np.zeros(50), -rate)
    assert check.nearest(loads_of(box, X, backwards), R, np.zeros(3)).zone == "zone0"
    held = check.nearest(loads_of(box, X, None), R, np.zeros(3))
    thrown = check.nearest(loads_of(box, X, profile), R, np.zeros(3))
    fall = np.sqrt(2 * 0.75 / 9.81)
    assert held.distance_m - thrown.distance_m == pytest.approx(0.24 * fall, rel=0.15)
    assert thrown.speed_m_s == pytest.approx(1.2 * np.hypot(0.21, 0.01), rel=1e-6)


def test_a_load_stops_falling_at_the_floor():
    below = Box(size_m=(4.0, 4.0, 0.2), pose=Pose(xyz_m=(0.0, 0.0, -2.0)))
    throw = ThrowCheck(cell_with(below)).nearest(loads_of(BOX, X, PROFILE), np.eye(3), np.zeros(3))
    assert throw.distance_m > 0.8
    deeper = cell_with(below).model_copy(update={"floor_z_m": -3.0})
    assert ThrowCheck(deeper).nearest(loads_of(BOX, X, PROFILE), np.eye(3), np.zeros(3)).distance_m < 0.0


def test_without_zones_there_is_no_throw():
    assert ThrowCheck(cell_with()).nearest(loads_of(BOX, X, PROFILE), np.eye(3), np.zeros(3)) is None
