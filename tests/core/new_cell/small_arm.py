"""A small arm of boxes as a URDF, with whatever else a test hangs on it."""

from __future__ import annotations

from pathlib import Path

from core.new_cell.making import Made, make_cell
from core.new_cell.order import CellOrder

LIMIT = '<limit lower="-2.8" upper="2.8" velocity="2.0" effort="90"/>'
INERTIA = '<inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/>'
INERTIAL = f'<inertial><origin xyz="0 0 0.1"/><mass value="2"/>{INERTIA}</inertial>'
BOX = '<origin xyz="0 0 0.11"/><geometry><box size="0.08 0.08 0.2"/></geometry>'
AXES = ("0 0 1", "0 1 0", "0 0 1", "0 1 0", "0 0 1", "0 1 0")
LENGTH = 0.24


def link(name: str, *, inertial: str = INERTIAL, shapes: str = f"<collision>{BOX}</collision>") -> str:
    return f'<link name="{name}">{inertial}{shapes}</link>'


def joint(name: str, parent: str, child: str, *, kind: str = "revolute", axis: str = "0 0 1", z: float = LENGTH, rest: str = LIMIT) -> str:
    origin = f'<origin xyz="0 0 {z}"/><axis xyz="{axis}"/>'
    return f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{origin}{rest}</joint>'


def arm(extra: str = "", *, links: dict[int, str] | None = None, joints: dict[int, str] | None = None) -> str:
    """Six hinges; link k hangs on joint k, the last one carries the bare frame `flange`. Replaces links and joints by number."""
    links, joints = links or {}, joints or {}
    text = link("base")
    for k, axis in enumerate(AXES, start=1):
        above = "base" if k == 1 else f"link{k - 1}"
        text += joints.get(k, joint(f"joint{k}", above, f"link{k}", axis=axis)) + links.get(k, link(f"link{k}"))
    text += '<link name="flange"/>' + joint("mount", "link6", "flange", kind="fixed", rest="")
    return f'<robot name="small">{text}{extra}</robot>'


def write_arm(folder: Path, text: str, name: str = "arm.urdf") -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / name
    file.write_text(text)
    return file


def made(tmp_path: Path, text: str, **wanted: object) -> Made:
    return make_cell(CellOrder("tried", write_arm(tmp_path / "given", text), into=tmp_path / "cells", **wanted))
