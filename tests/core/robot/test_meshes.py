"""A robot with meshes: the bad ones are refused by link and file, the sound ones are read once, and the bodies are where they should be."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.errors import BadCell, BadRobot
from core.files import confinement
from core.files.confinement import Arrays, Order
from core.report.faces import arm_parts
from core.robot.bodies import link_bodies, visual_shapes
from core.robot.model import RobotModel
from core.second_opinion.arm import build_solid_arm
from tests.core.robot.mesh_bytes import BAD, BODY, FLAT, binary_stl, dae, elbow

LWR = Path(__file__).parents[3] / "cells" / "lwr4_bench"


def cell_with(folder: Path, file: str, content: bytes, scale: str = "1 1 1", of: str = "collision") -> Path:
    """The LWR with a mesh for the last but one link."""
    shutil.copytree(LWR, folder, dirs_exist_ok=True)
    (folder / file).write_bytes(content)
    text = (folder / "robot.urdf").read_text()
    begin = text.index(f"<{of}>", text.index('<link name="link6">'))
    shape = text[text.index("<geometry>", begin) : text.index("</geometry>", begin)]
    mesh = f'<geometry><mesh filename="{file}" scale="{scale}"/>'
    (folder / "robot.urdf").write_text(text[:begin] + text[begin:].replace(shape, mesh, 1))
    return folder


def bodies_in(folder: Path) -> list[object]:
    cell = load_cell(folder)
    return [body.geometry for body in link_bodies(cell, RobotModel.of_cell(cell)) if body.name == "link6"]


@pytest.mark.parametrize("what", BAD)
def test_a_bad_mesh_is_refused_in_one_sentence_with_its_link(what: str, tmp_path: Path) -> None:
    file, content, scale, words = BAD[what]
    with pytest.raises(BadRobot, match=rf"robot\.urdf: link 'link6': mesh '{file}': found .*{words}"):
        bodies_in(cell_with(tmp_path, file, content, scale))


def test_a_bad_mesh_that_is_only_looked_at_is_refused_before_anything_moves(tmp_path: Path) -> None:
    with pytest.raises(BadRobot, match=r"link 'link6': mesh 'hand\.stl': found an empty file"):
        bodies_in(cell_with(tmp_path, "hand.stl", b"", of="visual"))


def test_a_flat_mesh_may_be_looked_at(tmp_path: Path) -> None:
    cell = load_cell(cell_with(tmp_path, "sign.stl", binary_stl(FLAT), of="visual"))
    robot = RobotModel.of_cell(cell)
    flat = next(each for each in visual_shapes(cell, robot) if each.shape.file)
    assert flat.parts == ()
    assert len(arm_parts(cell, robot)) > 5


def test_a_mesh_that_is_not_convex_stands_as_several_bodies_of_its_link(tmp_path: Path) -> None:
    found = bodies_in(cell_with(tmp_path, "elbow.stl", binary_stl(np.array(elbow().triangles)), "0.5 0.5 0.5"))
    assert len(found) == 2


def test_what_has_been_read_is_not_read_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = bodies_in(cell_with(tmp_path, "a.dae", dae(BODY)))
    asked: list[Order] = []

    def never(_: object, orders: list[Order]) -> list[Arrays]:
        asked.extend(orders)
        return []

    monkeypatch.setattr(confinement, "ask", never)
    (tmp_path / "a.dae").rename(tmp_path / "b.dae")
    again = bodies_in(cell_with(tmp_path, "b.dae", dae(BODY)))
    assert asked == []
    assert len(again) == len(first) == 1


def without_collision(folder: Path, looks: bool = True) -> Path:
    shutil.copytree(LWR, folder, dirs_exist_ok=True)
    text = (folder / "robot.urdf").read_text()
    begin = text.index('<link name="link6">')
    end = text.index("</link>", begin)
    link = text[begin:end]
    kept = link[: link.index("<collision>")] + link[link.index("</collision>") + len("</collision>") :]
    if not looks:
        kept = kept[: kept.index("<visual>")] + kept[kept.index("</visual>") + len("</visual>") :]
    (folder / "robot.urdf").write_text(text[:begin] + kept + text[end:])
    return folder


def say(folder: Path, names: str) -> Path:
    cell = (folder / "cell.toml").read_text()
    (folder / "cell.toml").write_text(cell.replace("[robot]\n", f"[robot]\nvisual_shapes = {names}\n", 1))
    return folder


def test_a_link_that_moves_without_a_shape_for_collisions_is_refused(tmp_path: Path) -> None:
    words = r"link 'link6': found a link that moves without a shape for collisions, expected <collision>"
    with pytest.raises(BadRobot, match=words + ", or 'link6' in robot.visual_shapes"):
        load_cell(without_collision(tmp_path / "a"))
    with pytest.raises(BadRobot, match=words + ", or neither mass nor shape"):
        load_cell(without_collision(tmp_path / "b", looks=False))


def test_its_looks_count_for_planner_and_second_opinion_where_the_cell_says_so(tmp_path: Path) -> None:
    cell = load_cell(say(without_collision(tmp_path), '["link6"]'))
    names = [body.name for body in link_bodies(cell, RobotModel.of_cell(cell))]
    assert sorted({*names}) == sorted({body.name for body in build_solid_arm(cell, cell.payload_box).bodies} - {"payload"})
    assert "link6" in names


@pytest.mark.parametrize("names", ['["link9"]', '["link5"]'])
def test_looks_count_only_where_there_are_some_and_nothing_else(names: str, tmp_path: Path) -> None:
    with pytest.raises(BadCell, match=r"robot\.visual_shapes: found 'link\d', expected a link of robot.urdf with a <visual> and without"):
        load_cell(say(without_collision(tmp_path), names))
