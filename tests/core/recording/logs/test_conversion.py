"""Logs written here by numpy in other people's units, clocks and rotations, against the recording that they were made of."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.errors import BadInput, BadRecording
from core.recording.logs import conversion
from core.recording.logs.conversion import Conversion
from core.recording.logs.mapping import Mapping, change_mapping, read_mapping, write_mapping
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.tables import open_log
from core.recording.recording import Recording
from tests.core.recording.logs.torque_log import ANSWERS, write_torque_log
from tests.torque_recordings import make

GRAVITY = np.array([0.0, 0.0, -9.81])
WRENCH = {"time": "t", "force": ["fx", "fy", "fz"], "torque": ["tx", "ty", "tz"]}
WAYS = {
    "quaternion": lambda R: Rotation.from_matrix(R).as_quat(),
    "matrix": lambda R: R.reshape(-1, 9),
    "rotation_vector": lambda R: Rotation.from_matrix(R).as_rotvec(),
    "roll_pitch_yaw": lambda R: Rotation.from_matrix(R).as_euler("xyz"),
}
COUNTS = {"quaternion": 4, "matrix": 9, "rotation_vector": 3, "roll_pitch_yaw": 3}


def known(rows: int = 400, seed: int = 1) -> Recording:
    """Smooth attitudes and positions, any wrench."""
    rng = np.random.default_rng(seed)
    t = np.arange(rows) * 0.002
    phase = 0.8 * np.sin(2.0 * t[:, None] + rng.uniform(0, 6, 3))
    return Recording(
        t=t,
        gravity=GRAVITY,
        wrench=rng.normal(size=(rows, 6)) * [10, 10, 10, 1, 1, 1],
        orientation=Rotation.from_rotvec(phase).as_matrix(),
        position=0.3 * np.cos(t[:, None] + rng.uniform(0, 6, 3)),
    )


def write(file: Path, columns: dict[str, np.ndarray]) -> None:
    np.savetxt(file, np.column_stack(list(columns.values())), delimiter=",", header=",".join(columns), comments="", fmt="%.17g")


def convert(folder: Path, names: list[str], mapping: Mapping, beside: Path) -> Conversion:
    return Conversion(open_log([folder / name for name in names]), mapping, beside)


def wrench_columns(recording: Recording, *, time: float = 1.0, force: float = 1.0, torque: float = 1.0) -> dict[str, np.ndarray]:
    names = ("fx", "fy", "fz", "tx", "ty", "tz")
    scale = np.array([force] * 3 + [torque] * 3)
    return {"t": recording.t * time, **dict(zip(names, (recording.wrench * scale).T, strict=True))}


def pose_columns(recording: Recording, way: str) -> dict[str, np.ndarray]:
    values = WAYS[way](recording.orientation)
    return {f"r{k}": column for k, column in enumerate(values.T)}


def mapping(pose: dict[str, object], **wrench: object) -> Mapping:
    return Mapping.model_validate({"wrench": {**WRENCH, **wrench}, "pose": pose})


@pytest.mark.parametrize("way", list(WAYS))
@pytest.mark.parametrize("inverse", [False, True])
def test_every_way_to_write_a_rotation_is_read(tmp_path: Path, way: str, inverse: bool) -> None:
    recording = known()
    turned = replace(recording, orientation=recording.orientation.transpose(0, 2, 1)) if inverse else recording
    write(tmp_path / "log.csv", {**wrench_columns(recording), **pose_columns(turned, way)})
    columns = [f"r{k}" for k in range(COUNTS[way])]
    made = convert(tmp_path, ["log.csv"], mapping({"time": "t", way: columns, "inverse": inverse}), tmp_path).recording()
    assert np.allclose(made.orientation, recording.orientation, atol=1e-9)
    assert np.allclose(made.wrench, recording.wrench, atol=1e-12)
    assert np.allclose(made.t, recording.t, atol=1e-12)


@pytest.mark.parametrize(
    ("units", "scales"),
    [
        ({"time_unit": "us", "force_unit": "lbf", "torque_unit": "lbf in"}, (1e6, 1 / 4.4482216152605, 8.850745767)),
        ({"time_unit": "ms", "force_unit": "kgf", "torque_unit": "N mm"}, (1e3, 1 / 9.80665, 1e3)),
        ({"time_unit": "ns", "force_unit": "kN", "torque_unit": "kgf m"}, (1e9, 1e-3, 1 / 9.80665)),
        ({"sign": -1}, (1.0, -1.0, -1.0)),
    ],
)
def test_other_units_and_the_other_sign_end_in_si_and_in_the_papers_sign(tmp_path: Path, units: dict, scales: tuple) -> None:
    recording = known()
    time, force, torque = scales
    write(tmp_path / "w.csv", wrench_columns(recording, time=time, force=force, torque=torque))
    write(tmp_path / "p.csv", {"t": recording.t, **pose_columns(recording, "quaternion")})
    pose = {"file": "p.csv", "time": "t", "quaternion": ["r0", "r1", "r2", "r3"]}
    made = convert(tmp_path, ["w.csv", "p.csv"], mapping(pose, file="w.csv", **units), tmp_path).recording()
    assert made.wrench == pytest.approx(recording.wrench, rel=1e-8)


def test_a_wrench_in_base_axes_is_turned_into_the_sensors(tmp_path: Path) -> None:
    recording = known()
    turned = np.concatenate(
        [np.einsum("nij,nj->ni", recording.orientation, part) for part in np.split(recording.wrench, 2, axis=1)], axis=1
    )
    write(tmp_path / "log.csv", {**wrench_columns(replace(recording, wrench=turned)), **pose_columns(recording, "matrix")})
    made = convert(tmp_path, ["log.csv"], mapping({"time": "t", "matrix": [f"r{k}" for k in range(9)]}, axes="base"), tmp_path).recording()
    assert np.allclose(made.wrench, recording.wrench, atol=1e-9)


@settings(max_examples=20, deadline=None)
@given(ahead_s=st.floats(-1000.0, 1000.0), every=st.integers(2, 8))
def test_two_clocks_of_other_rates_are_brought_together(tmp_path_factory: pytest.TempPathFactory, ahead_s: float, every: int) -> None:
    folder, recording = tmp_path_factory.mktemp("log"), known()
    write(folder / "w.csv", wrench_columns(recording))
    some = slice(0, None, every)
    sparse = {"t": recording.t[some] - ahead_s, **{name: column[some] for name, column in pose_columns(recording, "quaternion").items()}}
    sparse |= dict(zip(("x", "y", "z"), 1000.0 * recording.position[some].T, strict=True))
    write(folder / "p.csv", sparse)
    pose = {"file": "p.csv", "time": "t", "begins_s": ahead_s, "quaternion": ["r0", "r1", "r2", "r3"]}
    pose |= {"position": ["x", "y", "z"], "position_unit": "mm"}
    done = convert(folder, ["w.csv", "p.csv"], mapping(pose, file="w.csv"), folder)
    kept = done.recording()
    # the first row may be lost to the rounding of clocks that are far apart
    begin = int(not np.array_equal(kept.wrench[0], recording.wrench[0]))
    rows = slice(begin, begin + len(kept))
    assert len(kept) >= len(recording) - every - 1
    assert np.array_equal(kept.wrench, recording.wrench[rows])
    assert Rotation.from_matrix(kept.orientation.transpose(0, 2, 1) @ recording.orientation[rows]).magnitude().max() < 0.01
    assert np.abs(kept.position - recording.position[rows]).max() < 1e-6
    assert done.moved_hz == pytest.approx(500.0 / every, rel=1e-6)


def test_rows_that_repeat_a_time_and_rows_in_a_hole_of_the_attitudes_are_left_out_and_counted(tmp_path: Path) -> None:
    recording = known(1000)
    columns = wrench_columns(recording)
    columns["t"] = np.where(np.arange(1000) == 7, recording.t[6], recording.t)
    write(tmp_path / "w.csv", columns)
    kept = (recording.t < 0.8) | (recording.t > 1.2)
    write(tmp_path / "p.csv", {name: column[kept] for name, column in {"t": recording.t, **pose_columns(recording, "quaternion")}.items()})
    pose = {"file": "p.csv", "time": "t", "quaternion": ["r0", "r1", "r2", "r3"]}
    done = convert(tmp_path, ["w.csv", "p.csv"], mapping(pose, file="w.csv"), tmp_path)
    assert (done.read, done.repeated) == (1000, 1)
    assert done.outside == pytest.approx(0.4 / 0.002, abs=2)
    assert not ((done.t > 0.81) & (done.t < 1.19)).any()


def test_a_file_without_names_has_columns_by_number(tmp_path: Path) -> None:
    recording = known()
    values = np.column_stack([recording.t, recording.wrench, WAYS["rotation_vector"](recording.orientation)])
    np.savetxt(tmp_path / "log.csv", values, delimiter=", ", fmt="%.12g")
    (tmp_path / "map.toml").write_text(
        "[wrench]\ntime = 1\nforce = [2, 3, 4]\ntorque = [5, 6, 7]\n[pose]\ntime = 1\nrotation_vector = [8, 9, 10]\n"
    )
    made = convert(tmp_path, ["log.csv"], read_mapping(tmp_path / "map.toml"), tmp_path).recording()
    assert made.wrench == pytest.approx(recording.wrench, rel=1e-9)


POSE = '[pose]\ntime = "t"\nquaternion = ["r0", "r1", "r2", "r3"]\n'
READINGS = '[wrench]\ntime = "t"\nforce = ["fx", "fy", "fz"]\ntorque = ["tx", "ty", "tz"]\n'


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (READINGS, "neither [pose] nor [joints]"),
        (READINGS + "force_unit = 'stone'\n" + POSE, "wrench.force_unit"),
        (READINGS + "sign = 2\n" + POSE, "wrench.sign"),
        (READINGS + POSE + 'matrix = ["a","b","c","d","e","f","g","h","i"]\n', "exactly one of quaternion"),
        (READINGS + POSE + "sped = 1\n", "pose.sped"),
        (READINGS.replace('"fz"', '"nothing"') + POSE, "nothing"),
        (READINGS + POSE + "begins_s = 100.0\n", "begins_s says by how much"),
        (READINGS + POSE.replace("pose]", "pose]\nfile = '../x.csv'"), "../x.csv"),
        ("[wrench\n", "TOML that does not parse"),
    ],
)
def test_a_mapping_that_cannot_be_is_refused_in_words(tmp_path: Path, text: str, said: str) -> None:
    recording = known()
    write(tmp_path / "log.csv", {**wrench_columns(recording), **pose_columns(recording, "quaternion")})
    (tmp_path / "map.toml").write_text(text)
    with pytest.raises(BadInput, match=re.escape(said)):
        convert(tmp_path, ["log.csv"], read_mapping(tmp_path / "map.toml"), tmp_path).recording()


@pytest.mark.parametrize(
    ("name", "row", "value", "said"),
    [
        ("t", 5, -1.0, "column 't', row 6"),
        ("r0", 9, 3.0, "column 'r0', row 10"),
        ("fx", 3, np.nan, "column 'fx', row 4"),
    ],
)
def test_a_row_that_cannot_be_is_named(tmp_path: Path, name: str, row: int, value: float, said: str) -> None:
    recording = known()
    columns = {**wrench_columns(recording), **pose_columns(recording, "quaternion")}
    columns[name] = columns[name].copy()
    columns[name][row] = value
    write(tmp_path / "log.csv", columns)
    with pytest.raises(BadRecording, match=re.escape(said)):
        convert(tmp_path, ["log.csv"], mapping({"time": "t", "quaternion": ["r0", "r1", "r2", "r3"]}), tmp_path).recording()


def test_a_long_log_is_the_same_block_by_block(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    recording = known(1000)
    write(tmp_path / "w.csv", wrench_columns(recording))
    sparse = {name: column[::4] for name, column in {"t": recording.t, **pose_columns(recording, "quaternion")}.items()}
    sparse |= {"x": recording.position[::4, 0], "y": recording.position[::4, 1], "z": recording.position[::4, 2]}
    write(tmp_path / "p.csv", sparse)
    pose = {"file": "p.csv", "time": "t", "quaternion": ["r0", "r1", "r2", "r3"], "position": ["x", "y", "z"]}
    done = convert(tmp_path, ["w.csv", "p.csv"], mapping(pose, file="w.csv"), tmp_path)
    whole = done.recording()
    monkeypatch.setattr(conversion, "BLOCK", 170)
    pieces = list(done.blocks())
    assert len(pieces) == 6
    assert np.allclose(np.concatenate([piece.orientation for piece in pieces]), whole.orientation, atol=1e-9)
    assert np.allclose(np.concatenate([piece.position for piece in pieces]), whole.position, atol=1e-9)
    assert np.array_equal(np.concatenate([piece.wrench for piece in pieces]), whole.wrench)
    assert np.array_equal(np.concatenate([piece.t for piece in pieces]), whole.t)


def test_a_list_of_averaged_poses_needs_no_time(tmp_path: Path) -> None:
    recording = known(12)
    write(tmp_path / "log.csv", {**wrench_columns(recording), **pose_columns(recording, "matrix")})
    part = mapping({"matrix": [f"r{k}" for k in range(9)]}, time=None)
    made = convert(tmp_path, ["log.csv"], part, tmp_path).recording()
    assert np.array_equal(made.t, np.arange(12.0))
    assert np.array_equal(made.wrench, recording.wrench)


def test_a_mapping_is_written_as_it_is_read_and_changed_by_its_keys(tmp_path: Path) -> None:
    first = mapping({"time": "t", "quaternion": ['q "a"', "b", "c", "d"], "begins_s": 1.5}, sign=-1)
    (tmp_path / "map.toml").write_text(write_mapping(first))
    assert read_mapping(tmp_path / "map.toml") == first
    changed = change_mapping(first, {"wrench.torque_unit": "N mm", "wrench.sign": "1", "pose.begins_s": "0.25"})
    assert (changed.wrench.torque_unit, changed.wrench.sign, changed.pose.begins_s) == ("N mm", 1, 0.25)
    for changes in ({"wrench.sing": "1"}, {"wrench.sign": "up"}, {"wrench.sign.x": "1"}):
        with pytest.raises(BadInput):
            change_mapping(first, changes)


def test_a_log_of_joints_and_torques_is_a_recording_of_its_own_rows(tmp_path: Path) -> None:
    truth = make(1).loaded
    file, urdf = write_torque_log(tmp_path, "arm", truth)
    (mapping,) = propose_mappings(open_log([file]), ANSWERS, urdf.read_text())
    mapping = change_mapping(mapping, {"joints.urdf": '"arm.urdf"', "joints.file": '"arm.csv"'})
    found = convert(tmp_path, ["arm.csv"], mapping, tmp_path).recording()
    assert found.wrench is None
    assert (found.robot, found.torque_gain_std) == (truth.robot, None)
    stated = change_mapping(mapping, {"joints.torque_gain_std": "0.02", "joints.link_mass_std": "0.05"})
    told = convert(tmp_path, ["arm.csv"], stated, tmp_path).recording()
    assert (told.torque_gain_std, told.link_mass_std) == (0.02, 0.05)
    for name in ("t", "q", "tau"):
        assert np.allclose(getattr(found, name), getattr(truth, name), atol=1e-9)


def test_a_mapping_with_neither_wrench_nor_torques_is_refused(tmp_path: Path) -> None:
    (tmp_path / "map.toml").write_text('[joints]\nnames = ["a"]\nbase_frame = "b"\nsensor_frame = "c"\nposition = ["q"]\n')
    with pytest.raises(BadInput) as refused:
        read_mapping(tmp_path / "map.toml")
    assert refused.value.message.code == "import-nothing-felt"
