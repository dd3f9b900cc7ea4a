"""Readers of what controllers and simulators take, one for each target, by the grammar and the names of the format; none of them knows what
writes it. Where somebody else's reader is at hand (MuJoCo, Pinocchio) it is that one."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Callable
from typing import Any

import mujoco
import numpy as np
import pinocchio as pin

from core.array import Array

Body = tuple[float, Array, Array]
"""Mass (kg), centre of mass (m), inertia about it (kg m2); where the target has no inertia or no products, NaN."""


def symmetric_of(xx: float, yy: float, zz: float, xy: float, xz: float, yz: float) -> Array:
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def turn_about(axis: int, angle_deg: float) -> Array:
    """An elementary rotation, written out."""
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[i, i] = turn[j, j] = c
    turn[i, j], turn[j, i] = -s, s
    return turn


def turn_of_abc(a: float, b: float, c: float) -> Array:
    """A about z, then B about the new y, then C about the new x, deg."""
    return turn_about(2, a) @ turn_about(1, b) @ turn_about(0, c)


def turn_of_quaternion(w: float, x: float, y: float, z: float) -> Array:
    """From the product q v q*, of a quaternion that a controller takes only if it has length one."""
    assert abs(w * w + x * x + y * y + z * z - 1.0) < 1e-7
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def read_call(text: str, name: str) -> list[Any]:
    """The arguments of the one call that is there: URScript and Python write it alike, with remarks after `#`."""
    (statement,) = ast.parse(text).body
    assert isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call) and not statement.value.keywords
    assert ast.unparse(statement.value.func) == name
    return [ast.literal_eval(argument) for argument in statement.value.args]


def read_ur(text: str) -> Body:
    """set_target_payload(m, cog, inertia): `inertia` is [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] about the centre of gravity."""
    m, cog, inertia = read_call(text, "set_target_payload")
    assert len(cog) == 3 and max(map(abs, inertia)) <= 133.0
    return m, np.array(cog), symmetric_of(*inertia)


def read_aggregate(text: str) -> dict[str, Any]:
    """A KRL aggregate {NAME value, NAME {...}}, by its names."""
    words = re.findall(r"[{},]|[A-Z]+|[-+]?\d[\d.]*(?:e[-+]?\d+)?", text)

    def value() -> Any:
        word = words.pop(0)
        if word != "{":
            return float(word)
        found: dict[str, Any] = {}
        while words[0] != "}":
            name = words.pop(0)
            assert name not in found
            found[name] = value()
            if words[0] == ",":
                words.pop(0)
        words.pop(0)
        return found

    found: dict[str, Any] = value()
    assert not words
    return found


def read_krl(text: str) -> Body:
    """LOAD_DATA[1]: M in kg, CM in mm with A B C in degrees, J in kg m2 about the centre of mass along the turned axes."""
    (line,) = [line for line in text.splitlines() if not line.startswith(";")]
    left, _, right = line.partition("=")
    assert left == "LOAD_DATA[1]"
    load = read_aggregate(right)
    assert set(load) == {"M", "CM", "J"}
    turn = turn_of_abc(*(load["CM"][name] for name in "ABC"))
    moments = np.diag([load["J"][name] for name in "XYZ"])
    return load["M"], np.array([load["CM"][name] for name in "XYZ"]) / 1000, turn @ moments @ turn.T


def read_sunrise(text: str) -> Body:
    """The template's fields by their names; it has no products."""
    fields = {match[1]: float(match[2]) for match in re.finditer(r"^(.+? \[[^]]+\]) +(\S+)$", text, re.MULTILINE)}
    inertia = np.full((3, 3), np.nan)
    np.fill_diagonal(inertia, [fields[f"J{name} [kg m2]"] for name in "XYZ"])
    return fields["Mass [kg]"], np.array([fields[f"MS {name} [mm]"] for name in "XYZ"]) / 1000, inertia


def read_abb(text: str) -> Body:
    """loaddata [mass, cog, aom, ix, iy, iz]: kg, mm, quaternion q1..q4 of the axes of moment, kg m2 about the centre of gravity."""
    (line,) = [line for line in text.splitlines() if not line.startswith("!")]
    declared = re.fullmatch(r"PERS loaddata \w+:=(.+);", line)
    assert declared is not None
    mass, cog, aom, *moments = ast.literal_eval(declared[1])
    assert (len(cog), len(aom), len(moments)) == (3, 4, 3)
    turn = turn_of_quaternion(*aom)
    return mass, np.array(cog) / 1000, turn @ np.diag(moments) @ turn.T


def read_franka(text: str) -> Body:
    """setLoad(load_mass, F_x_Cload, load_inertia): a 3x3 matrix, column after column."""
    load = json.loads(text)
    columns = [load["load_inertia"][k : k + 3] for k in (0, 3, 6)]
    assert len(load["load_inertia"]) == 9
    return load["load_mass"], np.array(load["F_x_Cload"]), np.array(columns).T


def read_flexiv(text: str) -> Body:
    """ToolParams: inertia [Ixx, Iyy, Izz, Ixy, Ixz, Iyz] about the centre of mass."""
    tool = json.loads(text)
    return tool["mass"], np.array(tool["CoM"]), symmetric_of(*tool["inertia"])


def read_xarm(text: str) -> Body:
    """set_tcp_load(weight, center_of_gravity): kg, mm."""
    weight, center_of_gravity = read_call(text, "arm.set_tcp_load")
    assert len(center_of_gravity) == 3
    return weight, np.array(center_of_gravity) / 1000, np.full((3, 3), np.nan)


def read_opc_ua(text: str) -> Body:
    """LoadType of OPC 40010-1: Inertia about the mounting point, along axes that CenterOfMass.Orientation turns; by the parallel axes'
    theorem (Steiner) about the centre of mass."""
    load = json.loads(text)
    place, turn = load["CenterOfMass"]["CartesianCoordinates"], load["CenterOfMass"]["Orientation"]
    m, com = load["Mass"]["Value"], np.array([place[name] for name in "XYZ"]) / 1000
    axes = turn_of_abc(*(turn[name] for name in "ABC"))
    about_mount = axes @ np.diag([load["Inertia"][name] for name in "XYZ"]) @ axes.T
    return m, com, about_mount - m * (com @ com * np.eye(3) - np.outer(com, com))


def read_mujoco(text: str) -> Body:
    """By MuJoCo itself, which refuses what no body can have."""
    model = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody><body><freejoint/>{text}</body></worldbody></mujoco>")
    turn = turn_of_quaternion(*model.body_iquat[1])
    return float(model.body_mass[1]), model.body_ipos[1].copy(), turn @ np.diag(model.body_inertia[1]) @ turn.T


def read_urdf(text: str) -> Body:
    """By Pinocchio."""
    joint = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    model = pin.buildModelFromXML(f'<robot name="r"><link name="a"/>{joint}<link name="b">{text}</link></robot>')
    body = model.inertias[1]
    return float(body.mass), np.array(body.lever), np.array(body.inertia)


READERS: dict[str, Callable[[str], Body]] = {
    "ur": read_ur, "kuka_krl": read_krl, "abb": read_abb, "franka": read_franka, "flexiv": read_flexiv, "opc_ua": read_opc_ua,
    "mujoco": read_mujoco, "urdf": read_urdf,
}  # fmt: skip
"""Of the targets that hold a whole body."""
PARTLY: dict[str, Callable[[str], Body]] = {"kuka_sunrise": read_sunrise, "xarm": read_xarm}
"""Of those that hold a part of it."""
