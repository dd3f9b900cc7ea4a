"""Bags that `rosbags` wrote, read here; and what is made of them when they are damaged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.errors import BadInput
from core.recording.bags.bag import is_bag, read_bag
from core.recording.bags.transforms import compose_transforms, find_root
from tests.core.recording.bags.bag_writer import BEGIN_NS, ROS1, ROS2, Messages, write_bag

ROWS = 300
T = np.arange(ROWS) * 0.002
RNG = np.random.default_rng(1)
WRENCH = RNG.normal(size=(ROWS, 6))
Q, DQ, TAU = RNG.normal(size=(3, ROWS, 3))
NAMES = ["shoulder", "elbow", "wrist"]


def topics(store: object = ROS2) -> dict[str, list]:
    make = Messages(store)
    return {
        "/ft": [(t, make.wrench(t, w, "ft_sensor")) for t, w in zip(T, WRENCH, strict=True)],
        "/joint_states": [(t, make.joints(t, NAMES, *x)) for t, *x in zip(T, Q, DQ, TAU, strict=True)],
    }


@pytest.mark.parametrize("storage", ["mcap", "sqlite", "ros1"])
def test_wrench_and_joints_come_out_as_they_were_written(tmp_path: Path, storage: str) -> None:
    path = write_bag(tmp_path / ("log.bag" if storage == "ros1" else "log"), topics(ROS1 if storage == "ros1" else ROS2), storage=storage)
    assert is_bag(path)
    tables = read_bag(path).tables
    assert set(tables) == {"/ft", "/joint_states"}
    ft, joints = tables["/ft"], tables["/joint_states"]
    assert ft.frame == "ft_sensor"
    parts = [f"wrench.{part}.{axis}" for part in ("force", "torque") for axis in "xyz"]
    assert np.array_equal(ft.numbers(*parts), WRENCH)
    assert ft.numbers("t")[:, 0] - 1e-9 * BEGIN_NS == pytest.approx(T, abs=1e-6)
    for prefix, values in {"position": Q, "velocity": DQ, "effort": TAU}.items():
        assert np.array_equal(joints.numbers(*(f"{prefix}.{name}" for name in NAMES)), values)
    assert np.array_equal(ft.numbers("wrench.force.y", rows=slice(100, 103))[:, 0], WRENCH[100:103, 1])


def test_two_sets_of_joints_in_one_topic_are_two_tables(tmp_path: Path) -> None:
    make = Messages()
    arm = [(t, make.joints(t, NAMES, q)) for t, q in zip(T, Q, strict=True)]
    gripper = [(t + 0.001, make.joints(t + 0.001, ["finger"], q[:1])) for t, q in zip(T[::3], Q[::3], strict=True)]
    tables = read_bag(write_bag(tmp_path / "log", {"/joint_states": sorted(arm + gripper, key=lambda each: each[0])})).tables
    assert np.array_equal(tables["/joint_states"].numbers(*(f"position.{name}" for name in NAMES)), Q)
    assert np.array_equal(tables["/joint_states#2"].numbers("position.finger"), Q[::3, :1])


def test_messages_without_a_stamp_have_the_time_of_the_log(tmp_path: Path) -> None:
    make = Messages()
    written = [(t, make.wrench(-1e-9 * BEGIN_NS, w, "ft")) for t, w in zip(T, WRENCH, strict=True)]
    tables = read_bag(write_bag(tmp_path / "log", {"/ft": written})).tables
    assert tables["/ft"].numbers("t")[:, 0] - 1e-9 * BEGIN_NS == pytest.approx(T, abs=1e-6)


def test_the_pose_of_a_frame_is_composed_of_the_transforms_above_it(tmp_path: Path) -> None:
    make = Messages()
    first, second = Rotation.from_rotvec(np.outer(np.sin(T), [0.3, 0.1, 0.9])), Rotation.from_rotvec(np.outer(T, [1.0, 0.0, 0.4]))
    fixed, lever = Rotation.from_rotvec([0.2, -0.4, 0.1]), np.array([0.1, 0.2, 0.3])
    steps = {("world", "base"): (np.array([1.0, 0.0, 0.5]), fixed.as_quat())}
    moved = [
        (t, make.transforms(t, {("base", "arm"): (lever, a.as_quat()), ("arm", "ft"): (2.0 * lever, b.as_quat())}))
        for t, a, b in zip(T, first, second, strict=True)
    ]
    tables = read_bag(write_bag(tmp_path / "log", {"/tf_static": [(0.0, make.transforms(0.0, steps))], "/tf": moved})).tables
    assert find_root(tables, "ft") == "world"
    made = compose_transforms(tables, "ft", "tf")
    assert made is not None
    turned = Rotation.from_quat(made.numbers(*(f"orientation.{axis}" for axis in "xyzw")))
    assert (turned.inv() * fixed * first * second).magnitude().max() < 1e-9
    expected = np.array([1.0, 0.0, 0.5]) + fixed.apply(lever + first.apply(2.0 * lever))
    assert np.abs(made.numbers(*(f"position.{axis}" for axis in "xyz")) - expected).max() < 1e-9
    assert compose_transforms(tables, "elsewhere", "tf") is None


@pytest.fixture(scope="module")
def content(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    folder = write_bag(tmp_path_factory.mktemp("bag") / "log", {name: each[:20] for name, each in topics().items()})
    (file,) = folder.glob("*.mcap")
    return file.read_bytes()


@settings(max_examples=150, deadline=None)
@given(at=st.floats(0.0, 1.0), size=st.integers(0, 8), value=st.integers(0, 255), cut=st.booleans())
def test_a_damaged_file_is_refused_in_words_or_read(
    tmp_path_factory: pytest.TempPathFactory, content: bytes, at: float, size: int, value: int, cut: bool
) -> None:
    k = int(at * (len(content) - 1))
    damaged = content[:k] if cut else content[:k] + bytes([value] * size) + content[k + size :]
    file = tmp_path_factory.getbasetemp() / "damaged.mcap"
    file.write_bytes(damaged)
    try:
        tables = read_bag(file).tables
    except BadInput as error:
        assert error.message.code in {"bag-broken", "bag-too-many-topics", "recording-rows"}
    else:
        assert all(len(table) <= 20 for table in tables.values())
    if cut:
        with pytest.raises(BadInput, match="a bag that cannot be read"):
            read_bag(file)


@pytest.mark.parametrize("name", ["log.mcap", "log.bag", "log/metadata.yaml"])
@pytest.mark.parametrize("text", [b"", b"rubbish" * 50, b"\x89MCAP0\r\n" + b"\xff" * 40])
def test_what_is_no_bag_is_refused(tmp_path: Path, name: str, text: bytes) -> None:
    file = tmp_path / name
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(text)
    with pytest.raises(BadInput, match="a bag that cannot be read"):
        read_bag(file.parent if "/" in name else file)
