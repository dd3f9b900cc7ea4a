"""A cell is made whole or not at all, and what it says is true."""

from __future__ import annotations

import errno
import tomllib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.cell.cell import Robot
from core.cell.folder import load_cell
from core.errors import BadInput
from core.new_cell import making
from core.new_cell.making import make_cell
from core.new_cell.order import Behind, CellOrder
from core.new_cell.values import CellValues
from core.words.message import Message
from tests.core.new_cell.small_arm import BOX, INERTIAL, LIMIT, arm, joint, link, made, write_arm

TRIANGLE = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
FINGER = link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="") + link("finger")


def with_mesh(name: str) -> str:
    """An arm whose base has a mesh of that file name."""
    shape = f'<collision><geometry><mesh filename="{name}"/></geometry></collision>'
    return arm().replace(link("base"), link("base", shapes=shape))


def nothing_left(tmp_path: Path) -> bool:
    return not (tmp_path / "cells").exists()


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> making.Made:
    """A cell of the small arm as it comes."""
    return made(tmp_path_factory.mktemp("plain"), arm())


def test_a_made_cell_loads_and_is_free_at_home(plain, fcl_scene):
    cell = load_cell(plain.folder)
    assert (cell.name, cell.robot.base_frame, cell.robot.sensor_frame) == ("tried", "base", "flange")
    q = np.array(cell.robot.home_rad)
    scene = fcl_scene(cell, cell.payload_box)
    links = ["base", *(f"link{k}" for k in range(1, 7))]
    apart = [(a, b) for i, a in enumerate(links) for b in links[i + 2 :]] + [("payload", name) for name in links[:-1]]
    assert min(scene.between(q, *pair) for pair in apart) > 0.01
    assert np.all(np.abs(q) < 0.9 * 2.8)


def test_its_home_is_bent(plain):
    """Stretched, the arm of the small description is 6 x 0.24 m long."""
    import pinocchio as pin

    cell = load_cell(plain.folder)
    model = pin.buildModelFromXML(cell.urdf)
    data = model.createData()
    pin.framesForwardKinematics(model, data, np.array(cell.robot.home_rad))
    assert np.linalg.norm(data.oMf[model.getFrameId("flange")].translation) < 0.95 * 6 * 0.24


def test_the_same_order_makes_the_same_cell(plain, tmp_path):
    again = made(tmp_path, arm())
    for name in ("cell.toml", "robot.urdf"):
        assert (again.folder / name).read_bytes() == (plain.folder / name).read_bytes()


def test_the_folder_has_text_and_a_picture_and_nothing_else(plain):
    assert sorted(file.name for file in plain.folder.iterdir()) == ["cell.toml", "home.png", "robot.urdf"]
    assert (plain.folder / "home.png").read_bytes().startswith(b"\x89PNG")
    assert [file.name for file in plain.folder.parent.iterdir()] == ["tried"]


def test_every_figure_that_was_not_given_is_told(tmp_path):
    turning = joint("joint6", "link5", "link6", kind="continuous", axis="0 1 0", rest="<limit/>")
    text = arm(FINGER + joint("slide", "hand", "finger", kind="prismatic", rest=LIMIT.replace("-2.8", "0.01")), joints={6: turning})
    text = text.replace(link("link3"), link("link3", inertial=""))
    found = made(tmp_path, text, behind=Behind.TOOL)
    notes = "\n".join(map(str, found.notes))
    for words in (
        "'joint6' turns without end",
        "'joint6' has no limit of velocity",
        "'joint6' has no limit of torque",
        "'slide' (prismatic) is not the arm's: fixed at 0.01 m",
        "Link 'link3' has no mass: 1.28 kg from its shape",  # 0.08 x 0.08 x 0.2 m of water
        "felt by the sensor as a tool: hand, finger",
        "Accelerations of 10.0, 10.0, 10.0, 10.0, 10.0, 5.0 rad/s2 taken: each joint's greatest speed in 0.2 s, between 1 and 10 rad/s2.",
    ):
        assert words in notes
    assert "Das Gelenk „slide“ (prismatic) gehört nicht zum Arm: festgehalten bei 0,01 m." in [note.say("de") for note in found.notes]
    text = (found.folder / "cell.toml").read_text()
    assert tomllib.loads(text)["tools"]["hand_tool"]["links"] == ["hand", "finger"]


def test_a_link_that_can_only_be_seen_is_taken_as_it_looks(tmp_path):
    found = made(tmp_path, arm(links={3: link("link3", shapes=f"<visual>{BOX}</visual>")}))
    robot = tomllib.loads((found.folder / "cell.toml").read_text())["robot"]
    assert robot["visual_shapes"] == ["link3"]
    assert Message.of("newcell-visual-taken", link="link3") in found.notes
    if "visual_shapes" in Robot.model_fields:
        load_cell(found.folder)


def test_pairs_that_always_overlap_are_listed(tmp_path):
    ring = '<collision><origin xyz="0 0 0.24"/><geometry><sphere radius="0.3"/></geometry></collision>'
    found = made(tmp_path, arm(links={1: link("link1", shapes=ring)}))
    robot = tomllib.loads((found.folder / "cell.toml").read_text())["robot"]
    assert ["link3", "link1"] in robot["adjacent"]
    assert Message.of("newcell-pair-left-out", first="link3", second="link1") in found.notes


def test_whoever_makes_the_cell_says_which_pairs_are_left_out(tmp_path):
    found = made(tmp_path, arm(), values=CellValues(adjacent=(("link5", "link2"),)))
    text = (found.folder / "cell.toml").read_text()
    assert tomllib.loads(text)["robot"]["adjacent"] == [["link5", "link2"]]
    assert "were left out by who made the cell" in text
    assert not [note for note in found.notes if note.code == "newcell-pair-left-out"]


def test_pairs_that_are_left_out_stand_in_the_way_of_no_home(tmp_path):
    """An arm that is folded so far that its fifth link is in its first one, and a hand's breadth from its base."""
    folded, pairs = (0.0, 2.4, 0.0, 2.75, 0.0, 0.0), (("link1", "link5"), ("link5", "base"))
    for count in range(2):
        first, second = sorted(pairs[count], reverse=True)
        with pytest.raises(BadInput, match=rf"robot\.home_rad: found '{first}' .* from '{second}'"):
            made(tmp_path, arm(), values=CellValues(home_rad=folded, adjacent=pairs[:count]))
    assert made(tmp_path, arm(), values=CellValues(home_rad=folded, adjacent=pairs)).home.q.tolist() == list(folded)


def test_a_tool_gets_a_name_that_no_link_has(tmp_path):
    hand = link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="")
    found = made(tmp_path, arm(hand), behind=Behind.TOOL)
    assert list(tomllib.loads((found.folder / "cell.toml").read_text())["tools"]) == ["hand_tool"]


def test_a_cell_in_which_nothing_could_be_planned_is_not_made(tmp_path):
    ring = '<collision><geometry><sphere radius="0.5"/></geometry></collision>'
    with pytest.raises(BadInput, match=r"cells/tried/cell\.toml: robot\.home_rad: found 'link1' -0\.260 m from 'floor'"):
        made(tmp_path, arm(links={1: link("link1", shapes=ring)}))
    assert not (tmp_path / "cells/tried").exists()


def test_meshes_are_copied_once_each_under_names_of_their_own(tmp_path):
    folder = tmp_path / "given/arm"
    for place, height in (("a", 1), ("b", 2)):
        (folder / place).mkdir(parents=True)
        (folder / place / "part.STL").write_text(_cube(0.05 * height))
    shape = '<collision><geometry><mesh filename="{}"/></geometry></collision>'
    links = {1: link("link1", shapes=shape.format("package://arm/a/part.STL")), 2: link("link2", shapes=shape.format("a/part.STL"))}
    links[3] = link("link3", shapes=shape.format("b/part.STL"))
    found = make_cell(CellOrder("tried", write_arm(folder, arm(links=links)), into=tmp_path / "cells"))
    assert sorted(file.name for file in (found.folder / "meshes").iterdir()) == ["part.stl", "part_2.stl"]
    assert (found.folder / "meshes/part_2.stl").read_text() == _cube(0.1)
    assert "package://" not in (found.folder / "robot.urdf").read_text()
    load_cell(found.folder)


def _cube(edge: float) -> str:
    """The faces of a cube as an STL of triangles from its corners."""
    corners = [(x * edge, y * edge, z * edge) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    triangles = [corner for a, b, c, d in quads for corner in ((a, b, c), (a, c, d))]
    facets = "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*corners[k]) for k in triangle) + "endloop\nendfacet\n"
        for triangle in triangles
    )
    return f"solid cube\n{facets}endsolid cube\n"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('<!DOCTYPE robot [<!ENTITY a "b">]>' + arm(), "document type"),
        (with_mesh("package://no_such_package/a.stl"), "no such package"),
        (with_mesh("missing.stl"), "no such file"),
        (with_mesh("/etc/passwd.stl"), "leads outside"),
        (with_mesh("../../secret.stl"), "leads outside"),
        (with_mesh("/etc/passwd"), "one of .stl"),
        (arm(joints={3: joint("joint3", "link2", "link3", kind="prismatic")}), "prismatic"),
        (arm(joints={3: joint("joint3", "link2", "link3", rest=LIMIT.replace("-2.8", "-170"))}), "lower < upper"),
        (arm().replace('<box size="0.08 0.08 0.2"/>', '<box size="5 5 5"/>'), "configurations free"),
        (arm().replace(f"<collision>{BOX}</collision>", ""), "no shape on any link that moves"),
        (arm() + "<", "does not parse"),
        (INERTIAL, "<inertial>"),
    ],
)
def test_a_description_that_cannot_be_used_is_refused_and_leaves_nothing(tmp_path, text, words):
    (tmp_path / "secret.stl").write_text(TRIANGLE)
    with pytest.raises(BadInput) as refused:
        made(tmp_path, text)
    assert words in str(refused.value)
    assert nothing_left(tmp_path)


@pytest.mark.parametrize("name", ["../up", "a/b", "", ".", "..", "a b", "/tmp/x", "x" * 65, "a\n", "é"])
def test_a_name_that_is_none_is_refused(tmp_path, name):
    with pytest.raises(BadInput, match="NAME"):
        make_cell(CellOrder(name, write_arm(tmp_path, arm()), into=tmp_path / "cells"))
    assert nothing_left(tmp_path)


@pytest.mark.parametrize("what", ["folder", "file", "link"])
def test_what_exists_is_not_touched(tmp_path, what):
    target = tmp_path / "cells/tried"
    target.parent.mkdir()
    {"folder": target.mkdir, "file": target.touch, "link": lambda: target.symlink_to(tmp_path / "nowhere")}[what]()
    with pytest.raises(BadInput, match="exists already"):
        made(tmp_path, arm())
    assert [each.name for each in target.parent.iterdir()] == ["tried"]


@pytest.mark.parametrize("step", ["copy_meshes", "draw_home"])
def test_a_disk_that_gets_full_leaves_nothing(tmp_path, monkeypatch, step):
    def full(*_arguments: object, **_named: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(making, step, full)
    with pytest.raises(BadInput, match="No space left on device"):
        made(tmp_path, arm())
    assert nothing_left(tmp_path)


@given(name=st.text(min_size=1, max_size=30).filter(lambda name: not set(name) & set('<>&"')))
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_whatever_a_mesh_is_called_nothing_is_written_outside_the_cell(tmp_path, name):
    text = with_mesh(name + ".stl")
    with pytest.raises(BadInput):
        made(tmp_path, text)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["given"]
