"""The text of a new `cell.toml`, with the comments that a person needs who goes on with it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, field

from core.array import Array
from core.cell.cell import Box, Friction, Limits, Sensor
from core.new_cell.values import CellValues

NOT_STATED = "not stated"
"""What a sensor's name begins with whose figures are nobody's."""

RANGE = (200, 200, 400, 10, 10, 10)
NOISE = (0.1, 0.1, 0.1, 0.005, 0.005, 0.005)
RESOLUTION = (0.05, 0.05, 0.05, 0.002, 0.002, 0.002)
"""Of a common six-axis wrist sensor, N and N m."""


@dataclass(frozen=True)
class CellParts:
    """What goes into the file.

    Args:
        home, acceleration: one for each joint, rad and rad/s2.
        adjacent: pairs of links that always overlap, or that a person has left out.
        visual_shapes: links that are taken from their visual shapes.
        tool: links of the description that hang behind the sensor.
        sensor_sizes: how many times larger the assumed sensor is than a common one of 200 N and 10 N m, in force and in torque.
        source: name of the description's file.
        values: what somebody has stated: sensor, limits and friction stand in the file as they are there.
    """

    name: str
    title: str
    source: str
    base: str
    sensor: str
    joints: tuple[str, ...]
    home: Array
    acceleration: Sequence[float]
    floor_z: float
    payload_box: Box
    adjacent: tuple[tuple[str, str], ...] = ()
    visual_shapes: tuple[str, ...] = ()
    tool: tuple[str, ...] = ()
    tool_name: str = "hand"
    sensor_sizes: tuple[int, int] = (1, 1)
    values: CellValues = field(default_factory=CellValues)


def cell_text(parts: CellParts) -> str:
    """The file."""
    given = parts.values
    sensor = _sensor(parts.sensor_sizes) if given.sensor is None else _state_sensor(given.sensor)
    sections = (_head(parts), _robot(parts), sensor, _limits(given.limits), _tool(parts), _payload(parts), _example(parts))
    return "\n".join(line for section in sections for line in section) + "\n"


def _head(parts: CellParts) -> list[str]:
    return [
        f"# Made by `heft cell new` from {_comment(parts.source)}. Look at every value; `heft cell check {parts.name}` says which.",
        f"name = {_text(parts.name)}",
        f"title = {_text(parts.title)}",
        "# the lowest point of the robot's base; nothing may get below it, and a load that comes off falls as deep",
        f"floor_z_m = {parts.floor_z:g}",
        "",
    ]


def _robot(parts: CellParts) -> list[str]:
    lines = [
        "[robot]",
        f"base_frame = {_text(parts.base)}",
        f"sensor_frame = {_text(parts.sensor)}",
        f"# joints: {_comment(', '.join(parts.joints))}",
        f"home_rad = {_list(parts.home)}",
        *_say_accelerations(parts),
        f"acceleration_rad_s2 = {_list(parts.acceleration)}",
        *_friction(parts.values.friction),
    ]
    if parts.visual_shapes:
        lines += [
            "# no shape for collisions in the description: the visual one is taken, which shows the cover and not what hangs on it",
            f"visual_shapes = {_list_of_texts(parts.visual_shapes)}",
        ]
    if parts.adjacent:
        why = "overlap in all configurations that were looked at" if parts.values.adjacent is None else "were left out by who made the cell"
        lines += [
            f"# These pairs {why}: no distance between them is watched.",
            "# Look at each pair on the robot: if the two can touch, mend the shapes in robot.urdf and take the pair out of this list.",
            "adjacent = [",
            *[f"    {_list_of_texts(pair)}," for pair in parts.adjacent],
            "]",
        ]
    return [
        *lines,
        "# base.xyz_m = [0.0, 0.0, 0.0]  # the base frame in the cell; base.rpy_rad turns it (hanging: [3.14159265, 0.0, 0.0])",
        "",
    ]


def _say_accelerations(parts: CellParts) -> list[str]:
    joints = parts.values.joints
    if all(name in joints and joints[name].acceleration_rad_s2 is not None for name in parts.joints):
        return []
    return ["# not in any URDF: each joint's greatest speed in 0.2 s, between 1 and 10 rad/s2; put in the robot's own"]


def _friction(friction: Friction | None) -> list[str]:
    if friction is None:
        return []
    return [f"friction.coulomb_n_m = {_list(friction.coulomb_n_m)}", f"friction.viscous_n_m_s = {_list(friction.viscous_n_m_s)}"]


def _state_sensor(sensor: Sensor) -> list[str]:
    lines = [
        "[sensor]",
        f"name = {_text(sensor.name)}",
        f"noise_std = {_list(sensor.noise_std)}",
        f"range = {_list(sensor.range)}",
        f"resolution = {_list(sensor.resolution)}",
    ]
    if sensor.mount is not None:
        lines += [f"mount.xyz_m = {_list(sensor.mount.xyz_m)}", f"mount.rpy_rad = {_list(sensor.mount.rpy_rad)}"]
    return [*lines, ""]


def _sensor(sizes: tuple[int, int]) -> list[str]:
    times = [size for size in sizes for _ in "xyz"]
    noise, range_, resolution = ([round(k * value, 6) for k, value in zip(times, row, strict=True)] for row in (NOISE, RANGE, RESOLUTION))
    force, torque = f"{range_[0]:g} N", f"{range_[3]:g} N m"
    return [
        f"# Figures of nobody's sensor: six axes, {force} and {torque}.",
        "# Put in those of yours: noise (standard deviation), range, resolution.",
        "[sensor]",
        f"name = {_text(f'{NOT_STATED}: six-axis wrist sensor, {force} / {torque}')}",
        f"noise_std = {_list(noise)}",
        f"range = {_list(range_)}",
        f"resolution = {_list(resolution)}",
        "# mount.xyz_m = [0.0, 0.0, 0.03]  # the sensor frame in the flange from which the controller counts its payload",
        "",
    ]


def _limits(limits: Limits) -> list[str]:
    return [
        "[limits]",
        f"cartesian_speed_m_s = {limits.cartesian_speed_m_s}",
        f"clearance_m = {limits.clearance_m}       # to obstacles, protected zones and the floor",
        f"self_clearance_m = {limits.self_clearance_m}  # between the robot's links, and the payload",
        "",
    ]


def _tool(parts: CellParts) -> list[str]:
    if not parts.tool:
        return []
    return [
        "# What the sensor carries before any payload; mass and shape are those of robot.urdf.",
        f"[tools.{parts.tool_name}]",
        'title = "What hangs behind the sensor"',
        f"links = {_list_of_texts(parts.tool)}",
        "",
    ]


def _payload(parts: CellParts) -> list[str]:
    box = parts.payload_box
    return [
        "# The room that a payload takes, in the sensor frame, from the flange on: the workpiece with what holds it.",
        "[payload_box]",
        f"size_m = {_list(box.size_m)}",
        f"pose.xyz_m = {_list(box.pose.xyz_m)}",
        *([f"pose.rpy_rad = {_list(box.pose.rpy_rad)}"] if any(box.pose.rpy_rad) else []),
        "",
    ]


def _example(parts: CellParts) -> list[str]:
    return [
        "# Everything that stands in the cell, each with a name of its own, in the world frame; the base frame is its origin, z up.",
        "# [[obstacles]]",
        '# name = "table"',
        f'# shape = {{ kind = "box", size_m = [1.2, 1.2, 0.1], pose.xyz_m = [0.0, 0.0, {parts.floor_z - 0.05:g}] }}',
        '# shape = { kind = "mesh", file = "meshes/fixture.stl", scale = [0.001, 0.001, 0.001], pose.xyz_m = [0.6, -0.4, 0.0] }  # instead',
        "#",
        "# Where people may be: neither the robot nor a load that comes off gets into it.",
        "# [[zones]]",
        '# name = "operator"',
        '# shape = { kind = "box", size_m = [1.0, 3.0, 2.5], pose.xyz_m = [1.6, 0.0, 0.6] }',
    ]


def _text(text: str) -> str:
    """A string of TOML; the names that get here can be printed."""
    return json.dumps(text, ensure_ascii=False)


def _comment(text: str) -> str:
    return "".join(character if character.isprintable() else "?" for character in text)


def _list(values: Sequence[float] | Array) -> str:
    return "[" + ", ".join(repr(float(value)) for value in values) + "]"


def _list_of_texts(texts: Sequence[str]) -> str:
    return "[" + ", ".join(map(_text, texts)) + "]"
