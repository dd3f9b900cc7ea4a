"""What is wrong with a cell whose every value is right by itself: one that does not go with another."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from core.errors import BadCell
from core.payload.channels import CHANNELS

if TYPE_CHECKING:
    from core.cell.cell import Box, Cell, Payload
    from core.payload.inertia import InertialParameters

Locate = Callable[[str], str]
"""Where a key stands, as an error names it."""

BASE_IN_ZONE = 0.001  # m; a robot may stand at the border of a zone
BASE_IN_OBSTACLE = 0.05  # m; or be sunk into the table that carries it
GRAVITY = (9.0, 10.5)  # m/s2; anywhere on the earth, and roughly rounded
GRAVITY_TILT = float(np.radians(30.0))
"""The world frame stands upright; what is tilted more was meant for the frame of a robot on a wall or a ceiling."""
DEEPEST_FLOOR = 20.0  # m below the base; a load falls no longer than 3 s
FARTHEST_PAYLOAD = 3.0  # m from the sensor; no arm that this is for carries anything larger


def contradictions(cell: Cell) -> Iterator[BadCell]:
    """What is wrong with a cell whose every value is right by itself: the keys whose values do not go with others."""
    yield from _name_contradictions(cell)
    yield from _place_contradictions(cell)
    yield from _sensor_contradictions(cell)
    for name, payload in cell.payloads.items():
        yield from payload_contradictions(f"payloads.{name}", payload, cell, _key_in(cell, f"payloads.{name}."))


def _name_contradictions(cell: Cell) -> Iterator[BadCell]:
    names = [obstacle.name for obstacle in cell.obstacles] + [zone.name for zone in cell.zones]
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield BadCell(cell.locate("obstacles, zones"), "cell-name-twice", name=name, count=names.count(name))


def _place_contradictions(cell: Cell) -> Iterator[BadCell]:
    strength = float(np.linalg.norm(cell.gravity)) if any(cell.gravity_m_s2) else 0.0
    least, most = GRAVITY
    where = cell.locate("gravity_m_s2")
    if not least < strength < most:
        yield BadCell(
            where, "cell-gravity-strength",
            gravity_m_s2=cell.gravity_m_s2, strength_m_s2=strength, least_m_s2=least, most_m_s2=most,
        )  # fmt: skip
    elif (tilt := float(np.arccos(-cell.gravity[2] / strength))) > GRAVITY_TILT:
        yield BadCell(where, "cell-gravity-tilted", gravity_m_s2=cell.gravity_m_s2, angle_rad=tilt, most_rad=GRAVITY_TILT)
    base = cell.robot.base.translation
    depth = float(base[2]) - cell.floor_z_m
    if depth < 0:
        yield BadCell(cell.locate("floor_z_m"), "cell-floor-above-base", floor_z_m=cell.floor_z_m, base_z_m=base[2])
    elif depth > DEEPEST_FLOOR:
        yield BadCell(cell.locate("floor_z_m"), "cell-floor-too-deep", floor_z_m=cell.floor_z_m, depth_m=depth, most_m=DEEPEST_FLOOR)
    yield from box_contradictions(cell.payload_box, cell.locate("payload_box"))
    for name, payload in cell.payloads.items():
        yield from box_contradictions(payload.box, cell.locate(f"payloads.{name}.box"))
    for key, items, allowed in (("obstacles", cell.obstacles, BASE_IN_OBSTACLE), ("zones", cell.zones, BASE_IN_ZONE)):
        for item in items:
            if item.shape.kind == "mesh":  # read by who plans, who then says whether the base is in it
                continue
            depth = item.shape.depth(base)
            if depth > allowed:
                where = cell.locate(f"{key}.{item.name}.shape")
                yield BadCell(where, "cell-base-inside", in_the_way=item.name, depth_m=depth, most_m=allowed)


def box_contradictions(box: Box, where: str) -> Iterator[BadCell]:
    """What is wrong with the box of a payload, whatever the cell."""
    farthest = float(np.linalg.norm(box.corners, axis=1).max())
    if farthest > FARTHEST_PAYLOAD:
        yield BadCell(where, "cell-box-too-large", distance_m=farthest, most_m=FARTHEST_PAYLOAD)


def _key_in(cell: Cell, part: str) -> Locate:
    return lambda key: cell.locate(f"{part}{key}")


def _sensor_contradictions(cell: Cell) -> Iterator[BadCell]:
    for key in ("noise_std", "resolution"):
        for figure, measured in zip(getattr(cell.sensor, key), cell.sensor.range, strict=True):
            if figure >= 0.1 * measured:
                yield BadCell(cell.locate(f"sensor.{key}"), "cell-sensor-coarse", figure=figure, range=measured)


def payload_contradictions(name: str, payload: Payload, cell: Cell, locate: Locate) -> Iterator[BadCell]:
    """What is wrong with a payload in a cell, but for what is wrong with its box alone.

    Args:
        name: of the payload, as the sentence on the sensor's range says what is carried.
        locate: where a key of the payload stands.
    """
    parameters = payload.parameters
    if not parameters.consistent:
        yield BadCell(
            locate("inertia_kg_m2"), "cell-payload-inertia",
            mass_kg=payload.mass_kg, first_moment_kg_m=payload.first_moment_kg_m, inertia_kg_m2=payload.inertia_kg_m2,
        )  # fmt: skip
        return
    yield from mass_contradictions(payload.mass_kg, cell, locate("mass_kg"))
    depth = payload.box.depth(parameters.com)
    if depth < 0:
        yield BadCell(locate("box"), "cell-payload-outside-box", com_m=np.round(parameters.com, 4).tolist(), distance_m=-depth)
    yield from load_contradictions([name], parameters, cell)


def mass_contradictions(mass_kg: float, cell: Cell, where: str) -> Iterator[BadCell]:
    """Whether a mass is more than the maker of the arm allows."""
    limit = cell.robot.payload_limit_kg
    if limit is not None and mass_kg > limit:
        yield BadCell(where, "cell-payload-too-heavy", mass_kg=mass_kg, most_kg=limit)


def load_contradictions(keys: Sequence[str], carried: InertialParameters, cell: Cell) -> Iterator[BadCell]:
    """Where the weight of what is carried, named by its keys, is more than the sensor measures."""
    g = float(np.linalg.norm(cell.gravity))
    c = carried.first_moment
    static = g * np.array([carried.mass] * 3 + [np.hypot(c[1], c[2]), np.hypot(c[0], c[2]), np.hypot(c[0], c[1])])
    where = cell.locate("sensor.range")
    for axis, load, measured in zip(CHANNELS, static, cell.sensor.range, strict=True):
        if load <= measured:
            continue
        if axis.startswith("f"):
            yield BadCell(where, "cell-sensor-force-too-weak", range_n=measured, axis=axis, carried=keys, load_n=load)
        else:
            yield BadCell(where, "cell-sensor-torque-too-weak", range_n_m=measured, axis=axis, carried=keys, load_n_m=load)
