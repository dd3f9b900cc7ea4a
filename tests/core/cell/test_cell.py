"""A cell is data from outside: what is malformed or contradicts itself is refused with the key, the value and what is expected."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.cell.cell import Box, Capsule, Cylinder, Pose, Shape, Sphere
from core.cell.folder import contradictions_of, find_cell, list_cell_folders, load_cell, read_cell_folder
from core.errors import BadCell, BadInput, BadRobot

CELLS = Path(__file__).parents[3] / "cells"
NAMES = sorted(folder.name for folder in CELLS.iterdir() if folder.is_dir())


def swap(old: str, new: str) -> Callable[[Path], object]:
    def change(folder: Path) -> None:
        text = (folder / "cell.toml").read_text()
        assert old in text
        (folder / "cell.toml").write_text(text.replace(old, new, 1))

    return change


def add(text: str) -> Callable[[Path], object]:
    return lambda folder: (folder / "cell.toml").write_text((folder / "cell.toml").read_text() + "\n" + text)


def raw(content: bytes) -> Callable[[Path], object]:
    return lambda folder: (folder / "cell.toml").write_bytes(content)


def urdf(old: str, new: str) -> Callable[[Path], object]:
    def change(folder: Path) -> None:
        text = (folder / "robot.urdf").read_text()
        assert old in text
        (folder / "robot.urdf").write_text(text.replace(old, new, 1))

    return change


def link_out(folder: Path) -> None:
    (folder / "robot.urdf").rename(folder.parent / "elsewhere.urdf")
    (folder / "robot.urdf").symlink_to(folder.parent / "elsewhere.urdf")


BLOCK = "inertia_kg_m2 = [0.006928, 0.0, 0.0, 0.006634, 0.001708, 0.003326]"
BROKEN: dict[str, tuple[Callable[[Path], object], str]] = {
    "no file": (lambda f: (f / "cell.toml").unlink(), "no such file"),
    "empty": (raw(b""), "name: found no such key"),
    "not TOML": (raw(b"name = \n"), "TOML that does not parse"),
    "not UTF-8": (raw(b'name = "\xff"'), "0xff at position 8"),
    "huge": (raw(b"#" * 1_100_000), "at most 1000000"),
    "nested too deep": (raw(b"a = " + b"[" * 100_000), "TOML that does not parse"),
    "no robot": (raw(b'name = "a"\ntitle = "a"\n'), "robot: found no such key"),
    "misspelt key": (swap("floor_z_m", "flor_z_m"), "flor_z_m: found an unknown key, expected 'floor_z_m'"),
    "misspelt inner key": (swap("clearance_m =", "clearence_m ="), "limits.clearence_m: .* expected 'clearance_m'"),
    "unknown key": (add('[coffee]\nmilk = "yes"'), "coffee: found an unknown key"),
    "name with a slash": (swap('name = "lwr4_bench"', 'name = "../lwr4"'), 'name: found "../lwr4"'),
    "no title": (swap('title = "KUKA', 'title = ""#"KUKA'), 'title: found ""'),
    "table instead of number": (swap("floor_z_m = -0.75", "floor_z_m = {a = 1}"), 'floor_z_m: found {"a": 1}'),
    "number as text": (swap("clearance_m = 0.03", 'clearance_m = "0.03"'), 'clearance_m: found "0.03", expected a valid number'),
    "true as number": (swap("clearance_m = 0.03", "clearance_m = true"), "clearance_m: found true"),
    "clearance negative": (swap("clearance_m = 0.03", "clearance_m = -0.03"), "clearance_m: found -0.03, expected greater than 0"),
    "clearance NaN": (swap("clearance_m = 0.03", "clearance_m = nan"), "limits.clearance_m: found nan"),
    "speed infinite": (swap("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = inf"), "limits.cartesian_speed_m_s: found inf"),
    "size negative": (swap("[1.6, 1.6, 0.1]", "[1.6, -1.6, 0.1]"), r"obstacles.0.shape.box.size_m.1: found -1.6"),
    "size zero": (swap("[1.6, 1.6, 0.1]", "[1.6, 0, 0.1]"), "size_m.1: found 0"),
    "two sizes": (swap("[1.6, 1.6, 0.1]", "[1.6, 0.1]"), "size_m.2: found no such key|size_m: found"),
    "four sizes": (swap("[1.6, 1.6, 0.1]", "[1.6, 0.1, 1, 1]"), "size_m: found"),
    "kilometres": (swap("[1.6, 1.6, 0.1]", "[1.6, 2000, 0.1]"), "size_m.1: found 2000, expected less than or equal to 1000"),
    "unknown shape": (swap('kind = "box", size_m = [1.6', 'kind = "cone", size_m = [1.6'), "shape.kind: found 'cone', expected box"),
    "no shape kind": (
        swap('kind = "box", size_m = [1.6', "size_m = [1.6"),
        "shape.kind: found no such key, expected box, sphere, capsule or cylinder",
    ),
    "angle in degrees": (swap("base_frame", "base.rpy_rad = [0, 0, 90]\nbase_frame"), "robot.base.rpy_rad.2: found 90"),
    "name twice": (swap('name = "wall_left"', 'name = "wall_back"'), "the name 'wall_back' 2 times"),
    "zone named like an obstacle": (swap('name = "operator"', 'name = "bench"'), "the name 'bench' 2 times"),
    "speed 250 for 250 mm/s": (
        swap("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = 250"),
        "limits.cartesian_speed_m_s: found 250, expected less than or equal to 1",
    ),
    "speed that never arrives": (swap("cartesian_speed_m_s = 0.25", "cartesian_speed_m_s = 1e-6"), "found 1e-06, expected greater than or"),
    "clearance larger than the cell": (swap("clearance_m = 0.03", "clearance_m = 30"), "limits.clearance_m: found 30, expected less than"),
    "self-clearance larger than the arm": (
        swap("clearance_m = 0.03", "clearance_m = 0.03\nself_clearance_m = 2"),
        "limits.self_clearance_m: found 2, expected less than or equal to 0.2",
    ),
    "acceleration of a bullet": (
        swap("acceleration_rad_s2 = [15.0", "acceleration_rad_s2 = [900.0"),
        "rad_s2.0: found 900.0, expected less",
    ),
    "velocity of a turbine": (swap("base_frame", "velocity_rad_s = [900,1,1,1,1,1,1]\nbase_frame"), "velocity_rad_s.0: found 900"),
    "gravity that points up": (
        swap("floor_z_m", "gravity_m_s2 = [0, 0, 9.81]\nfloor_z_m"),
        "gravity_m_s2: found .*180 degrees from straight down, expected at most 30 degrees.*robot.base",
    ),
    "gravity of a robot on a wall": (
        swap("floor_z_m", "gravity_m_s2 = [9.81, 0, 0]\nfloor_z_m"),
        "gravity_m_s2: found .*, 90 degrees from",
    ),
    "floor at the centre of the earth": (swap("floor_z_m = -0.75", "floor_z_m = -900"), "floor_z_m: found -900 m, 900.0 m below .*20 m"),
    "payload of a ship": (swap("[payload_box]\nsize_m = [0.16", "[payload_box]\nsize_m = [16"), "payload_box: found a corner 8.00 m from"),
    "payload heavier than the arm may carry": (
        swap("base_frame", "payload_limit_kg = 2.5\nbase_frame"),
        "payloads.steel_block.mass_kg: found 2.783 kg, expected at most the robot's payload_limit_kg, 2.5 kg",
    ),
    "gravity of the moon": (swap("floor_z_m", "gravity_m_s2 = [0, 0, -1.62]\nfloor_z_m"), "gravity_m_s2: .*1.62"),
    "floor above the base": (swap("floor_z_m = -0.75", "floor_z_m = 0.4"), "floor_z_m: found 0.4 m, above the robot's base at 0 m"),
    "zone swallows the base": (
        swap("size_m = [1.0, 3.0, 2.75], pose.xyz_m = [1.35", "size_m = [3.0, 3.0, 2.75], pose.xyz_m = [1.35"),
        "zones.operator.shape: found the robot's base 0.150 m inside",
    ),
    "ball swallows the base": (
        add('[[zones]]\nname = "ball"\nshape = {kind = "sphere", radius_m = 0.5, pose.xyz_m = [0.1, 0, 0.1]}'),
        "zones.ball.shape: found the robot's base 0.359 m inside",
    ),
    "obstacle swallows the base": (
        add('[[obstacles]]\nname = "post"\nshape = {kind = "capsule", radius_m = 0.2, length_m = 1.0}'),
        "obstacles.post.shape: found the robot's base 0.200 m inside",
    ),
    "payload box missing": (
        swap("[payload_box]\nsize_m = [0.16, 0.16, 0.16]\npose", "[payload_box]\npose"),
        "payload_box.size_m: found no",
    ),
    "mass NaN": (swap("mass_kg = 2.783", "mass_kg = nan"), "payloads.steel_block.mass_kg: found nan"),
    "mass negative": (swap("mass_kg = 2.783", "mass_kg = -2.783"), "mass_kg: found -2.783, expected greater than 0"),
    "inertia negative": (swap(BLOCK, BLOCK.replace("0.006928", "-0.006928")), "payloads.steel_block.inertia_kg_m2: .*rigid body"),
    "inertia of no body": (swap(BLOCK, BLOCK.replace("0.003326", "0.023326")), "payloads.steel_block.inertia_kg_m2: .*rigid body"),
    "five inertias": (swap(BLOCK, BLOCK.replace(", 0.003326", "")), "payloads.steel_block.inertia_kg_m2"),
    "box beside the load": (
        swap("size_m = [0.12, 0.13, 0.08], pose.xyz_m = [0.0, -0.017, 0.04]", "size_m = [0.12, 0.13, 0.08], pose.xyz_m = [0.0, 0.1, 0.04]"),
        "payloads.steel_block.box: found a centre of mass at .* 0.052 m outside",
    ),
    "sensor too weak": (
        swap("range = [145, 145, 290, 5, 5, 5]", "range = [20, 145, 290, 5, 5, 5]"),
        "found 20 N for fx, .*steel_block .*27.3 N",
    ),
    "sensor too weak to turn": (swap("range = [145, 145, 290, 5, 5, 5]", "range = [145, 145, 290, 1, 5, 5]"), "found 1 N m for tx"),
    "sensor deaf": (swap("noise_std = [0.0548", "noise_std = [54.8"), "sensor.noise_std: found 54.8"),
    "noise zero": (swap("noise_std = [0.0548", "noise_std = [0.0"), "sensor.noise_std.0: found 0.0"),
    "resolution as coarse as the range": (swap("resolution = [0.0625", "resolution = [145"), "sensor.resolution: found 145"),
    "home of six": (swap("home_rad = [0.0, ", "home_rad = ["), r"robot.home_rad: found 6 values, expected 7"),
    "home outside the limits": (swap("home_rad = [0.0, -0.35", "home_rad = [0.0, -2.35"), r"robot.home_rad: found -2.35 for 'joint2'"),
    "home in degrees": (swap("home_rad = [0.0, -0.35", "home_rad = [0.0, -20"), "robot.home_rad.1: found -20"),
    "accelerations of six": (swap("acceleration_rad_s2 = [15.0, ", "acceleration_rad_s2 = ["), "acceleration_rad_s2: found 6 values"),
    "acceleration zero": (swap("acceleration_rad_s2 = [15.0, ", "acceleration_rad_s2 = [0.0, "), "acceleration_rad_s2.0: found 0.0"),
    "friction of six": (swap("coulomb_n_m = [3.52, ", "coulomb_n_m = ["), r"robot.friction.coulomb_n_m: found 6 values, expected 7"),
    "friction that drives": (swap("viscous_n_m_s = [8.8, ", "viscous_n_m_s = [-8.8, "), "friction.viscous_n_m_s.0: found -8.8"),
    "faster than the URDF": (swap("base_frame", "velocity_rad_s = [9,9,9,9,9,9,9]\nbase_frame"), "velocity_rad_s: found 9 for 'joint1'"),
    "unknown base frame": (swap('base_frame = "base"', 'base_frame = "world"'), "robot.base_frame: found 'world'"),
    "unknown sensor frame": (swap('sensor_frame = "ft_sensor"', 'sensor_frame = "tip"'), "robot.sensor_frame: found 'tip'"),
    "URDF not there": (
        swap('base_frame = "base"', 'base_frame = "base"\nurdf = "other.urdf"'),
        "robot.urdf: found no such file, expected the file 'other.urdf'",
    ),
    "URDF outside": (swap('base_frame = "base"', 'base_frame = "base"\nurdf = "../x.urdf"'), "leads outside"),
    "URDF absolute": (swap('base_frame = "base"', 'base_frame = "base"\nurdf = "/etc/passwd"'), "leads outside"),
    "URDF linked out": (link_out, "leads outside"),
    "URDF with a joint without limits": (urdf('type="revolute"', 'type="continuous"'), "robot.urdf: joint 'joint1'.*without limits"),
    "URDF with a massless link": (urdf('<mass value="2.3"/>', '<mass value="0"/>'), "robot.urdf: link 'link1': mass"),
    "URDF with a mesh elsewhere": (
        urdf('<box size="0.17 0.17 0.11"/>', '<mesh filename="package://kuka/base.stl"/>'),
        "mesh: found 'package://kuka/base.stl'",
    ),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(shutil.copytree(CELLS / "lwr4_bench", tmp_path / "lwr4_bench"))


@pytest.mark.parametrize("name", NAMES)
def test_the_cells_that_come_with_the_program_are_right(name: str) -> None:
    cell = load_cell(CELLS / name)
    assert cell.name == name
    assert cell.zones and cell.obstacles and cell.payloads


@pytest.mark.parametrize("name", BROKEN)
def test_a_bad_cell_is_refused_in_one_sentence(name: str, folder: Path) -> None:
    break_it, words = BROKEN[name]
    break_it(folder)
    with pytest.raises((BadCell, BadRobot), match=words) as caught:
        load_cell(folder)
    assert str(caught.value).startswith(str(folder))
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 500


@pytest.mark.parametrize(
    ("changes", "keys"),
    [
        ([("clearance_m", "clearance_n"), ("noise_std", "noise")],
         {"limits.clearance_n", "sensor.noise_std", "sensor.noise"}),
        ([("floor_z_m = -0.75", "floor_z_m = 0.75"), (BLOCK, BLOCK.replace("0.006928", "6.928"))],
         {"floor_z_m", "payloads.steel_block.inertia_kg_m2"}),
    ],
    ids=["each value by itself", "values that do not go together"],
)  # fmt: skip
def test_all_that_is_wrong_with_a_cell_is_told_at_once(changes: list[tuple[str, str]], keys: set[str], folder: Path) -> None:
    for before, after in changes:
        swap(before, after)(folder)
    with pytest.raises(BadCell) as caught:
        load_cell(folder)
    told = (caught.value, *caught.value.others)
    assert {each.where.removeprefix(f"{folder / 'cell.toml'}: ") for each in told} == keys
    assert all(isinstance(each, BadCell) for each in told)


@pytest.mark.parametrize(
    ("name", "of_robot"),
    [("floor above the base", False), ("zone swallows the base", False), ("sensor too weak", False), ("name twice", False),
     ("home of six", True), ("unknown base frame", True), ("URDF not there", True), ("URDF with a massless link", True)],
)  # fmt: skip
def test_a_cell_that_contradicts_itself_can_be_read_and_says_what_is_wrong(name: str, of_robot: bool, folder: Path) -> None:
    break_it, words = BROKEN[name]
    break_it(folder)
    found = read_cell_folder(folder)
    assert (found.cell.name, len(found.cell.zones)) == ("lwr4_bench", 1)
    [flaw] = found.flaws
    assert re.search(words, str(flaw))
    assert bool(found.robot_flaws) is of_robot
    with pytest.raises(BadInput) as caught:
        load_cell(folder)
    assert str(caught.value) == str(flaw)


@pytest.mark.parametrize("name", ["no file", "not TOML", "not UTF-8", "clearance negative", "no robot"])
def test_a_file_that_holds_no_cell_cannot_be_read(name: str, folder: Path) -> None:
    BROKEN[name][0](folder)
    with pytest.raises(BadCell, match=BROKEN[name][1]):
        read_cell_folder(folder)


def test_a_sound_cell_has_no_flaws_until_a_zone_is_moved_onto_the_robot(folder: Path) -> None:
    found = read_cell_folder(folder)
    assert found.flaws == ()
    [flaw] = found._replace(cell=found.cell.with_pose_of("operator", Pose())).flaws
    assert flaw.where.endswith("zones.operator.shape")
    assert flaw.in_the_way == "operator"
    assert contradictions_of(found.cell.with_pose_of("operator", Pose(xyz_m=(1.5, 0.0, 0.6)))) == []


def test_a_flaw_is_a_code_with_what_it_names_in_si(folder: Path) -> None:
    BROKEN["gravity that points up"][0](folder)
    [flaw] = read_cell_folder(folder).flaws
    assert flaw.message.code == "cell-gravity-tilted"
    assert flaw.message.parameters == {
        "where": f"{folder / 'cell.toml'}: gravity_m_s2",
        "gravity_m_s2": [0.0, 0.0, 9.81],
        "angle_rad": pytest.approx(np.pi),
        "most_rad": pytest.approx(np.pi / 6),
    }
    assert "gefunden: (0.0, 0.0, 9.81) m/s², 180 Grad von senkrecht nach unten, erwartet: höchstens 30 Grad" in flaw.message.say("de")


def test_a_folder_without_a_cell_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadCell, match="no such file"):
        load_cell(tmp_path)


def test_a_cell_is_found_by_name_by_folder_and_by_file(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder.parent)
    assert find_cell("ur5e_line").samefile(CELLS / "ur5e_line")
    assert find_cell(str(folder)) == folder
    assert find_cell(folder / "cell.toml") == folder


def test_a_cell_of_the_working_directory_goes_before_one_of_the_program(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder.parent)
    assert [cell.name for cell in list_cell_folders()] == NAMES
    (folder.parent / "cells").mkdir()
    folder.rename(folder.parent / "cells" / "lwr4_bench")
    assert find_cell("lwr4_bench").resolve() == (folder.parent / "cells" / "lwr4_bench").resolve()
    assert [cell.name for cell in list_cell_folders()] == NAMES


@pytest.mark.parametrize(("name", "words"), [("lwr4_bensh", "'lwr4_bench', if"), ("nothing", "one of"), ("../cells", "one of")])
def test_an_unknown_cell_is_refused_with_a_hint(name: str, words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(BadInput, match=words):
        find_cell(name)


number = st.floats(-2, 2)
poses = st.builds(Pose, xyz_m=st.tuples(number, number, number), rpy_rad=st.tuples(number, number, number))
size = st.floats(0.1, 2)
shapes = st.one_of(
    st.builds(Box, size_m=st.tuples(size, size, size), pose=poses),
    st.builds(Sphere, kind=st.just("sphere"), radius_m=size, pose=poses),
    st.builds(Capsule, kind=st.just("capsule"), radius_m=size, length_m=size, pose=poses),
    st.builds(Cylinder, kind=st.just("cylinder"), radius_m=size, length_m=size, pose=poses),
)


def is_inside(shape: Shape, p: np.ndarray) -> bool:
    """Membership by definition, of a point in the shape's own frame."""
    match shape:
        case Box():
            return all(abs(x) < s / 2 for x, s in zip(p, shape.size_m, strict=True))
        case Sphere():
            return p @ p < shape.radius_m**2
        case Cylinder():
            return np.hypot(p[0], p[1]) < shape.radius_m and abs(p[2]) < shape.length_m / 2
        case Capsule():
            ends = [np.array([0, 0, s * shape.length_m / 2]) for s in (-1, 1)]
            in_balls = any((p - end) @ (p - end) < shape.radius_m**2 for end in ends)
            return in_balls or (np.hypot(p[0], p[1]) < shape.radius_m and abs(p[2]) < shape.length_m / 2)


@settings(max_examples=200, deadline=None)
@given(shape=shapes, p=st.tuples(number, number, number))
def test_depth_is_positive_inside_a_shape_and_only_there(shape: Shape, p: tuple[float, float, float]) -> None:
    local = np.array(p)
    depth = shape.depth(shape.pose.rotation @ local + shape.pose.translation)
    if abs(depth) > 1e-9:
        assert (depth > 0) == is_inside(shape, local)


@settings(max_examples=50, deadline=None)
@given(shape=st.builds(Box, size_m=st.tuples(size, size, size), pose=poses))
def test_corners_of_a_box_are_on_its_surface_and_as_far_apart_as_its_diagonals(shape: Box) -> None:
    assert [shape.depth(corner) for corner in shape.corners] == pytest.approx([0.0] * 8, abs=1e-12)
    apart = np.linalg.norm(shape.corners[:, None] - shape.corners[None], axis=2)
    assert apart.max(axis=1) == pytest.approx(np.full(8, np.linalg.norm(shape.size_m)))


@pytest.mark.parametrize(("degrees", "right"), [(0.0, True), (29.0, True), (31.0, False), (180.0, False)])
def test_gravity_may_be_tilted_as_a_floor_is_and_no_more(degrees: float, right: bool, folder: Path) -> None:
    angle = np.radians(degrees)
    swap("floor_z_m", f"gravity_m_s2 = [{9.81 * np.sin(angle)}, 0.0, {-9.81 * np.cos(angle)}]\nfloor_z_m")(folder)
    assert [flaw.where.rpartition(": ")[2] for flaw in read_cell_folder(folder).flaws] == ([] if right else ["gravity_m_s2"])


def test_a_robot_that_hangs_from_the_ceiling_is_no_flaw(folder: Path) -> None:
    swap("base_frame", "base = { xyz_m = [0.0, 0.0, 2.5], rpy_rad = [3.14159, 0.0, 0.0] }\nbase_frame")(folder)
    assert read_cell_folder(folder).flaws == ()
