"""Random cells: valid, but demanding. An arm of `cells/` among boxes and protected zones, with a random payload.

The same number gives the same cell on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.array import Array
from core.cell.cell import Box, Cell, Obstacle, Payload, Pose, Zone
from core.cell.folder import contradictions_of, load_cell
from core.errors import BadCell, refuse
from core.payload.inertia import InertialParameters
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel

CELLS = Path(__file__).parent.parent / "cells"
ARMS = ("lwr4_bench", "ur5e_line")
ROOM_AT_HOME_M = 0.02
BOX_MARGIN_M = 0.01
_TRIES = 1000


@dataclass(frozen=True)
class RandomCell:
    """A cell, and the box round the payload that `cell.payloads["random"]` describes, in the sensor frame."""

    seed: int
    cell: Cell
    payload_box: Box


def random_cell(seed: int) -> RandomCell:
    """The random cell of that number: even numbers have seven axes, odd numbers six."""
    rng = np.random.default_rng([seed, 2718])
    arm = load_cell(CELLS / ARMS[seed % 2])
    payload = _payload(rng, arm)
    box = Box(size_m=_numbers(np.array(payload.box.size_m) + 2 * BOX_MARGIN_M), pose=payload.box.pose)
    home = np.array(arm.robot.home_rad)
    home[0] += rng.uniform(-1.0, 1.0)
    robot = arm.robot.model_copy(update={"home_rad": tuple(home.tolist())})
    base = {"name": f"random_{seed}", "robot": robot, "payload_box": box, "payloads": {"random": payload}}
    cell = arm.model_copy(update={**base, "obstacles": (_mounting(arm),), "zones": ()})
    for k in range(int(rng.integers(3, 9)) - 1):
        cell = _with(cell, "obstacles", lambda k=k: Obstacle(name=f"box_{k}", shape=_obstacle(rng, arm)))
    for k in range(int(rng.integers(1, 4))):
        cell = _with(cell, "zones", lambda k=k: Zone(name=f"zone_{k}", shape=_zone(rng, arm)))
    return RandomCell(seed, Cell.model_validate(cell.model_dump() | {"folder": arm.folder}), box)


def _with(cell: Cell, key: str, draw: object) -> Cell:
    """The cell with one more thing where home remains free with some room."""
    for _ in range(_TRIES):
        larger = cell.model_copy(update={key: (*getattr(cell, key), draw())})  # type: ignore[operator]  # mypy infers no type of lambdas with defaults
        try:
            refuse(contradictions_of(Cell.model_validate(larger.model_dump() | {"folder": cell.folder})))
            robot = RobotModel.of_cell(larger)
            collision = CollisionModel(larger, robot, larger.payload_box)
        except BadCell:
            continue
        if collision.obstacle_distance(np.array(larger.robot.home_rad)).margin_m > ROOM_AT_HOME_M:
            return larger
    raise RuntimeError(f"no place for one more of {key} in {cell.name}")


def _mounting(arm: Cell) -> Obstacle:
    """What the robot stands on."""
    x, y, z = arm.robot.base.xyz_m
    return Obstacle(name="mounting", shape=Box(size_m=(0.6, 0.6, 0.1), pose=Pose(xyz_m=(x, y, z - 0.05))))


def _obstacle(rng: np.random.Generator, arm: Cell) -> Box:
    """Tables, pillars, walls and small things within reach."""
    kind = rng.integers(4)
    bearing, distance = rng.uniform(-np.pi, np.pi), rng.uniform(0.2, 0.8)
    sizes: list[Array | list[float]] = [
        rng.uniform(0.3, 1.0, 3) * [1, 1, 0.5],
        [*rng.uniform(0.08, 0.2, 2), rng.uniform(0.8, 2.0)],
        [0.08, rng.uniform(0.6, 1.5), rng.uniform(0.4, 1.5)],
        rng.uniform(0.08, 0.35, 3),
    ]
    size = np.array(sizes[kind])
    height = [rng.uniform(-0.6, 0.0), 0.3, rng.uniform(0.0, 0.9), rng.uniform(0.0, 1.2)][kind]
    return _box(arm, bearing, distance + 0.5 * size[0], height, size)


def _zone(rng: np.random.Generator, arm: Cell) -> Box:
    """Where people are: high and wide, at some distance."""
    size = np.array([rng.uniform(0.4, 1.0), rng.uniform(0.6, 2.5), rng.uniform(1.8, 2.6)])
    return _box(arm, rng.uniform(-np.pi, np.pi), rng.uniform(0.4, 0.9) + 0.5 * size[0], 0.5 * size[2] + arm.floor_z_m, size)


def _box(arm: Cell, bearing: float, distance: float, height: float, size: Array) -> Box:
    """A box facing the base."""
    place = arm.robot.base.translation + np.array([distance * np.cos(bearing), distance * np.sin(bearing), height])
    return Box(size_m=_numbers(size), pose=Pose(xyz_m=_numbers(place), rpy_rad=(0.0, 0.0, float(bearing))))


def _payload(rng: np.random.Generator, arm: Cell) -> Payload:
    """A cuboid of 0.3 to 6 kg with an uneven density, within what the sensor can carry."""
    for _ in range(_TRIES):
        mass = float(np.exp(rng.uniform(np.log(0.3), np.log(6.0))))
        size = rng.uniform(0.05, 0.2, 3)
        shift = np.array([*rng.uniform(-0.03, 0.03, 2), rng.uniform(0.0, 0.03)])
        centre = np.array([0.0, 0.0, 0.5 * size[2]]) + shift
        com = centre + 0.2 * size * rng.uniform(-1.0, 1.0, 3)
        inertia_com = mass / 12.0 * np.diag(size @ size - size**2) * rng.uniform(0.6, 0.9)
        phi = InertialParameters.from_com(mass, com, inertia_com).phi
        if mass * 9.81 * np.linalg.norm(com) > 0.7 * min(arm.sensor.range[3:]):
            continue
        return Payload(
            title="random",
            mass_kg=mass,
            first_moment_kg_m=_numbers(phi[1:4]),
            inertia_kg_m2=tuple(float(x) for x in phi[4:]),  # type: ignore[arg-type]  # six of ten
            box=Box(size_m=_numbers(size), pose=Pose(xyz_m=_numbers(centre))),
            source="random",
        )
    raise RuntimeError(f"no payload that the sensor of {arm.name} can carry")


def _numbers(values: Array) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
