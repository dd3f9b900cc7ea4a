"""What is wrong with a cell whose every value is right by itself: one that does not go with another."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from core.cell.cell import Cell, Payload, Sensor
    from core.payload.inertia import InertialParameters

BASE_IN_ZONE = 0.001  # m; a robot may stand at the border of a zone
BASE_IN_OBSTACLE = 0.05  # m; or be sunk into the table that carries it
GRAVITY_TILT_DEG = 30.0  # the world frame stands upright; what is tilted more was meant for the frame of a robot on a wall or a ceiling
DEEPEST_FLOOR = 20.0  # m below the base; a load falls no longer than 3 s
FARTHEST_PAYLOAD = 3.0  # m from the sensor; no arm that this is for carries anything larger


class Contradiction(NamedTuple):
    """A key whose value does not go with another.

    Args:
        in_the_way: name of the obstacle or zone that stands where the robot is, where that is what it is about.
    """

    key: str
    found: str
    expected: str
    in_the_way: str | None = None


def contradictions(cell: Cell) -> Iterator[Contradiction]:
    """What is wrong with a cell whose every value is right by itself."""
    yield from _name_contradictions(cell)
    yield from _place_contradictions(cell)
    yield from _sensor_contradictions(cell.sensor)
    for name, payload in cell.payloads.items():
        yield from _payload_contradictions(f"payloads.{name}", payload, cell)


def _name_contradictions(cell: Cell) -> Iterator[Contradiction]:
    names = [obstacle.name for obstacle in cell.obstacles] + [zone.name for zone in cell.zones]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield Contradiction("obstacles, zones", f"the name {name!r} {names.count(name)} times", "each name once")


def _place_contradictions(cell: Cell) -> Iterator[Contradiction]:
    strength = float(np.linalg.norm(cell.gravity))
    if not 9.0 < strength < 10.5:
        yield Contradiction("gravity_m_s2", f"{list(cell.gravity_m_s2)}, {strength:.3f} m/s2 strong", "that of the earth")
    elif (tilt := float(np.degrees(np.arccos(-cell.gravity[2] / strength)))) > GRAVITY_TILT_DEG:
        found = f"{list(cell.gravity_m_s2)}, {tilt:.0f} degrees from straight down"
        expected = (
            f"at most {GRAVITY_TILT_DEG:.0f} degrees: z of the world points up, a robot on a wall or a ceiling is turned by robot.base"
        )
        yield Contradiction("gravity_m_s2", found, expected)
    base = cell.robot.base.translation
    if base[2] < cell.floor_z_m:
        yield Contradiction("floor_z_m", f"{cell.floor_z_m} above the robot's base at {base[2]}", "a floor below the base")
    elif base[2] - cell.floor_z_m > DEEPEST_FLOOR:
        found = f"{cell.floor_z_m}, {base[2] - cell.floor_z_m:.1f} m below the robot's base"
        yield Contradiction("floor_z_m", found, f"a floor at most {DEEPEST_FLOOR:.0f} m below the base")
    boxes = {"payload_box": cell.payload_box, **{f"payloads.{name}.box": payload.box for name, payload in cell.payloads.items()}}
    for key, box in boxes.items():
        farthest = float(np.linalg.norm(box.corners, axis=1).max())
        if farthest > FARTHEST_PAYLOAD:
            yield Contradiction(key, f"a corner {farthest:.2f} m from the sensor", f"none farther than {FARTHEST_PAYLOAD:.0f} m")
    for key, items, allowed in (("obstacles", cell.obstacles, BASE_IN_OBSTACLE), ("zones", cell.zones, BASE_IN_ZONE)):
        for item in items:
            depth = item.shape.depth(base)
            if depth > allowed:
                found = f"the robot's base {depth:.3f} m inside it"
                expected = f"the base outside (at most {allowed} m inside)"
                yield Contradiction(f"{key}.{item.name}.shape", found, expected, item.name)


def _sensor_contradictions(sensor: Sensor) -> Iterator[Contradiction]:
    for key in ("noise_std", "resolution"):
        for value, limit in zip(getattr(sensor, key), sensor.range, strict=True):
            if value >= 0.1 * limit:
                yield Contradiction(f"sensor.{key}", f"{value}", f"less than a tenth of sensor.range, {limit}")


def _payload_contradictions(key: str, payload: Payload, cell: Cell) -> Iterator[Contradiction]:
    parameters = payload.parameters
    if not parameters.consistent:
        found = f"mass {payload.mass_kg}, first_moment {payload.first_moment_kg_m}, inertia {payload.inertia_kg_m2}"
        yield Contradiction(f"{key}.inertia_kg_m2", found, "values that a rigid body can have (pseudo-inertia positive definite)")
        return
    limit = cell.robot.payload_limit_kg
    if limit is not None and payload.mass_kg > limit:
        yield Contradiction(f"{key}.mass_kg", f"{payload.mass_kg}", f"at most the robot's payload_limit_kg, {limit}")
    depth = payload.box.depth(parameters.com)
    if depth < 0:
        found = f"a centre of mass at {np.round(parameters.com, 4).tolist()} m, {-depth:.3f} m outside the box"
        yield Contradiction(f"{key}.box", found, "a box that contains the payload")
    yield from load_contradictions(key, parameters, cell)


def load_contradictions(key: str, carried: InertialParameters, cell: Cell) -> Iterator[Contradiction]:
    """Where the weight of what is carried, named by its key, is more than the sensor measures."""
    g = float(np.linalg.norm(cell.gravity))
    c = carried.first_moment
    static = g * np.array([carried.mass] * 3 + [np.hypot(c[1], c[2]), np.hypot(c[0], c[2]), np.hypot(c[0], c[1])])
    for axis, load, limit, unit in zip(
        ("fx", "fy", "fz", "tx", "ty", "tz"), static, cell.sensor.range, ["N"] * 3 + ["N m"] * 3, strict=True
    ):
        if load > limit:
            found = f"{limit} {unit} for {axis}"
            yield Contradiction("sensor.range", found, f"more than the weight of {key} puts on it, {load:.3g} {unit}")
