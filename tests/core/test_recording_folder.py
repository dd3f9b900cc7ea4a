"""The recording's folder: what goes in comes out, and what is not `recording/1` is refused in one sentence."""

from __future__ import annotations

import gzip
import json
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.csv as pa_csv
import pyarrow.parquet as pq
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from core.errors import BadInput, BadRecording, BadRobot
from core.inertia import InertialParameters
from core.recording import Recording, RobotDescription, SensorDescription
from core.recording_folder import read_recording, write_recording

URDF = """<robot name="two"><link name="base"/><link name="a"/><link name="ft"/>
<joint name="j1" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" velocity="2" effort="9"/></joint>
<joint name="j2" type="revolute"><parent link="a"/><child link="ft"/><origin xyz="0 0 0.3"/><axis xyz="0 1 0"/>
<limit lower="-3" upper="3" velocity="2" effort="9"/></joint></robot>"""
REAL = Path(__file__).parents[3] / "shared" / "real"
N = 40


def recording() -> Recording:
    """A small recording with everything that a recording can have."""
    random = np.random.default_rng(1)
    return Recording(
        t=np.cumsum(random.uniform(0.001, 0.003, N)),
        gravity=np.array([0.0, 0.0, -9.81]),
        wrench=random.normal(size=(N, 6)),
        q=random.normal(size=(N, 2)),
        dq=random.normal(size=(N, 2)),
        q_cmd=random.normal(size=(N, 2)),
        tau=random.normal(size=(N, 2)),
        temperature=random.uniform(20, 30, N),
        phase=np.array(["transfer"] * 10 + ["hold:x+"] * 10 + ["rotate:x"] * 10 + ["hold:free"] * 10),
        robot=RobotDescription(URDF, ("j1", "j2"), "base", "ft"),
        sensor=SensorDescription(np.full(6, 0.05), np.full(6, 100.0), np.full(6, 0.01)),
        reference=InertialParameters.from_com(1.2, [0.01, 0.02, 0.03], np.diag([0.002, 0.002, 0.003])),
        reference_source="CAD",
        source="made up",
        cell="lwr4_bench",
        payload="steel_block",
    )


ARRAYS = ("t", "gravity", "wrench", "q", "dq", "q_cmd", "tau", "orientation", "position", "temperature", "phase")


def assert_same(first: Recording, second: Recording) -> None:
    for name in ARRAYS:
        a, b = getattr(first, name), getattr(second, name)
        assert (a is None) == (b is None), name
        if a is not None and name == "orientation":
            np.testing.assert_allclose(a, b, atol=1e-14)
        elif a is not None:
            np.testing.assert_array_equal(a, b, err_msg=name)
    assert first.robot == second.robot
    for name in ("noise_std", "range", "resolution"):
        np.testing.assert_array_equal(getattr(first.sensor, name), getattr(second.sensor, name))
    assert (first.reference is None) == (second.reference is None)
    if first.reference is not None and second.reference is not None:
        np.testing.assert_array_equal(first.reference.phi, second.reference.phi)
    for name in ("reference_source", "source", "cell", "payload"):
        assert getattr(first, name) == getattr(second, name)


# in and out


def test_everything_that_is_written_is_read_back(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    assert_same(read_recording(tmp_path / "run"), recording())


def test_poses_come_back_as_rotations_whatever_the_sign_of_the_quaternion(tmp_path: Path) -> None:
    random = np.random.default_rng(2)
    turns = Rotation.random(N, random_state=3).as_matrix()
    poses = replace(
        recording(),
        robot=None,
        q=None,
        dq=None,
        q_cmd=None,
        tau=None,
        orientation=turns,
        position=random.normal(size=(N, 3)),
    )
    write_recording(poses, tmp_path / "run")
    assert_same(read_recording(tmp_path / "run"), poses)
    change_samples(tmp_path / "run", lambda table: scale_columns(table, ("qx", "qy", "qz", "qw"), -1.001))
    np.testing.assert_allclose(read_recording(tmp_path / "run").orientation, turns, atol=1e-12)


finite = st.floats(-1e6, 1e6, allow_nan=False)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    wrench=arrays(float, (7, 6), elements=finite),
    q=arrays(float, (7, 2), elements=finite),
    steps=arrays(float, 7, elements=st.floats(1e-6, 10.0)),
    suffix=st.sampled_from(["parquet", "csv", "csv.gz"]),
)
def test_parquet_csv_and_packed_csv_hold_the_same_numbers_bit_for_bit(
    tmp_path_factory: pytest.TempPathFactory, wrench: np.ndarray, q: np.ndarray, steps: np.ndarray, suffix: str
) -> None:
    folder = tmp_path_factory.mktemp("run") / "a"
    robot = RobotDescription(URDF, ("j1", "j2"), "base", "ft")
    original = Recording(t=np.cumsum(steps), gravity=np.array([0, 0, -9.81]), wrench=wrench, q=q, robot=robot)
    write_recording(original, folder)
    save_samples(folder, load_samples(folder), suffix)
    assert_same(read_recording(folder), original)


def test_a_log_of_the_opposite_sign_is_turned_into_the_papers(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    change_manifest(tmp_path / "run", lambda content: content["sensor"].update(sign=-1))
    np.testing.assert_array_equal(read_recording(tmp_path / "run").wrench, -recording().wrench)


def test_joint_torques_alone_are_a_recording(tmp_path: Path) -> None:
    write_recording(replace(recording(), wrench=None), tmp_path / "run")
    assert read_recording(tmp_path / "run").wrench is None


def test_columns_and_keys_that_the_format_does_not_know_are_left_alone(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    change_samples(tmp_path / "run", lambda table: table.append_column("battery", pa.array(np.ones(N))))
    change_manifest(tmp_path / "run", lambda content: content.update(operator="somebody", truth={"mass": 1}))
    assert_same(read_recording(tmp_path / "run"), recording())


def test_a_long_csv_may_begin_with_whole_numbers(tmp_path: Path) -> None:
    random = np.random.default_rng(5)
    wrench = random.normal(size=(15_000, 6))
    wrench[:14_000, 0] = 0.0
    long = Recording(
        t=np.arange(15_000) / 1000,
        gravity=np.array([0, 0, -9.81]),
        wrench=wrench,
        q=random.normal(size=(15_000, 2)),
        robot=RobotDescription(URDF, ("j1", "j2"), "base", "ft"),
    )
    write_recording(long, tmp_path / "run")
    save_samples(tmp_path / "run", load_samples(tmp_path / "run"), "csv")
    assert (tmp_path / "run" / "samples.csv").stat().st_size > 1_500_000
    assert_same(read_recording(tmp_path / "run"), long)


def test_a_recording_is_never_overwritten(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    before = sorted((file.name, file.read_bytes()) for file in (tmp_path / "run").iterdir())
    with pytest.raises(BadInput, match="never overwritten"):
        write_recording(replace(recording(), payload="other"), tmp_path / "run")
    assert sorted((file.name, file.read_bytes()) for file in (tmp_path / "run").iterdir()) == before


def test_a_write_that_breaks_off_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "rename", interrupt)
    with pytest.raises(KeyboardInterrupt):
        write_recording(recording(), tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"wrench": np.zeros((N - 1, 6))}, "39 values"),
        ({"q": np.full((N, 2), np.nan)}, "'q_1', row 1"),
        ({"t": np.zeros(N)}, "strictly increases"),
        ({"sensor": SensorDescription(noise_std=np.zeros(6))}, "noise_std"),
    ],
)
def test_what_could_not_be_read_again_is_not_written(tmp_path: Path, change: dict[str, Any], words: str) -> None:
    with pytest.raises(BadRecording, match=words):
        write_recording(replace(recording(), **change), tmp_path / "run")
    assert list(tmp_path.iterdir()) == []


def test_real_static_poses_are_read_in_the_papers_sign() -> None:
    real = read_recording(REAL / "kuka-med14-static")
    assert len(real) == 24
    assert real.orientation is not None and real.wrench is not None
    down = real.orientation.transpose(0, 2, 1) @ real.gravity
    weight = np.linalg.lstsq(np.column_stack([-down.reshape(-1), np.tile(np.eye(3), (24, 1))]), real.wrench[:, :3].reshape(-1), rcond=None)[
        0
    ][0]
    assert weight == pytest.approx(0.932, abs=0.02)  # the authors' own estimate, kg; negative with the wrong sign


@pytest.mark.parametrize("number", [1, 2, 3])
def test_real_joint_torques_are_read(number: int) -> None:
    real = read_recording(REAL / f"kuka-lwr4-torques-{number}")
    assert real.wrench is None
    assert real.tau is not None and real.q is not None
    assert real.tau.shape == real.q.shape == (5027, 7)
    assert real.robot is not None and real.robot.sensor_frame == "lwr_7_link"


# bad input


def load_samples(folder: Path) -> pa.Table:
    return pq.read_table(folder / "samples.parquet")


def save_samples(folder: Path, table: pa.Table, suffix: str = "parquet") -> None:
    (folder / "samples.parquet").unlink()
    file = folder / f"samples.{suffix}"
    if suffix == "parquet":
        pq.write_table(table, file)
    elif suffix == "csv":
        pa_csv.write_csv(table, file)
    else:
        with gzip.open(file, "wb") as stream:
            pa_csv.write_csv(table, stream)


def change_samples(folder: Path, change: Callable[[pa.Table], pa.Table], suffix: str = "parquet") -> None:
    save_samples(folder, change(load_samples(folder)), suffix)


def scale_columns(table: pa.Table, names: tuple[str, ...], factor: float) -> pa.Table:
    for name in names:
        table = set_column(table, name, factor * table[name].to_numpy())
    return table


def set_column(table: pa.Table, name: str, values: Any) -> pa.Table:
    return table.set_column(table.column_names.index(name), name, pa.array(values))


def change_manifest(folder: Path, change: Callable[[dict[str, Any]], object]) -> None:
    content = json.loads((folder / "recording.json").read_text())
    change(content)
    (folder / "recording.json").write_text(json.dumps(content))


def text_of(folder: Path, change: Callable[[str], str], name: str = "recording.json") -> None:
    (folder / name).write_text(change((folder / name).read_text()))


def cell_of(folder: Path, name: str, row: int, value: Any, suffix: str = "parquet") -> None:
    def change(table: pa.Table) -> pa.Table:
        values = table[name].to_pylist()
        values[row - 1] = value
        if isinstance(value, str) and name != "phase":
            values = [str(v) for v in values]
        return set_column(table, name, values)

    change_samples(folder, change, suffix)


def drop(folder: Path, *names: str) -> None:
    change_samples(folder, lambda table: table.drop_columns(list(names)))


def cut(file: Path, keep: float) -> None:
    content = file.read_bytes()
    file.write_bytes(content[: int(keep * len(content))])


def link_out(folder: Path, name: str) -> None:
    outside = folder.parent / f"outside-{name}"
    (folder / name).rename(outside)
    (folder / name).symlink_to(outside)


def as_csv(folder: Path, change: Callable[[list[str]], list[str]]) -> None:
    save_samples(folder, load_samples(folder), "csv")
    lines = (folder / "samples.csv").read_text().splitlines()
    (folder / "samples.csv").write_text("\n".join(change(lines)) + "\n")


def deep_json(folder: Path) -> None:
    (folder / "recording.json").write_text("[" * 200_000)


BROKEN: dict[str, tuple[Callable[[Path], object], str]] = {
    "no manifest": (lambda f: (f / "recording.json").unlink(), "recording.json.*no such file"),
    "manifest is a folder": (lambda f: [(f / "recording.json").unlink(), (f / "recording.json").mkdir()], "no file"),
    "manifest not JSON": (lambda f: text_of(f, lambda s: s[:-9]), "JSON that does not parse"),
    "manifest a list": (lambda f: text_of(f, lambda _: "[1]"), "a list.*a JSON object"),
    "manifest nested too deep": (deep_json, "JSON that does not parse"),
    "manifest not UTF-8": (lambda f: (f / "recording.json").write_bytes(b'{"format": "\xff"}'), "0xff at position 12"),
    "manifest huge": (lambda f: text_of(f, lambda s: s + " " * 1_100_000), "at most 1000000"),
    "manifest linked out": (lambda f: link_out(f, "recording.json"), "leads outside"),
    "no format": (lambda f: change_manifest(f, lambda c: c.pop("format")), "format: found None"),
    "unknown format": (lambda f: change_manifest(f, lambda c: c.update(format="recording/2")), "'recording/2'"),
    "no gravity": (lambda f: change_manifest(f, lambda c: c.pop("gravity")), "gravity: found no such key"),
    "gravity too short": (lambda f: change_manifest(f, lambda c: c["gravity"].pop()), r"gravity.2: found no such key"),
    "gravity not the earth's": (lambda f: change_manifest(f, lambda c: c.update(gravity=[0, 0, -981])), "9.81 m/s2"),
    "gravity NaN": (
        lambda f: change_manifest(f, lambda c: c.update(gravity=[0, 0, float("nan")])),
        "gravity.2: found nan",
    ),
    "gravity as text": (
        lambda f: change_manifest(f, lambda c: c.update(gravity=["0", "0", "-9.81"])),
        "a valid number",
    ),
    "misspelt key": (lambda f: change_manifest(f, lambda c: c.update(senzor=c.pop("sensor"))), "senzor.*'sensor'"),
    "misspelt inner key": (
        lambda f: change_manifest(f, lambda c: c["sensor"].update(noise_sdt=c["sensor"].pop("noise_std"))),
        "noise_sdt.*'noise_std'",
    ),
    "sign of two": (lambda f: change_manifest(f, lambda c: c["sensor"].update(sign=2)), "sensor.sign: found 2"),
    "five noises": (lambda f: change_manifest(f, lambda c: c["sensor"]["noise_std"].pop()), "sensor.noise_std.5"),
    "negative noise": (
        lambda f: change_manifest(f, lambda c: c["sensor"].update(noise_std=[-1] * 6)),
        "noise_std.0: found -1",
    ),
    "negative reference": (
        lambda f: change_manifest(f, lambda c: c["payload_reference"].update(mass=-1)),
        "payload_reference.mass: found -1",
    ),
    "impossible reference": (
        lambda f: change_manifest(f, lambda c: c["payload_reference"].update(inertia=[1, 0, 0, 1, 0, 9])),
        "a rigid body can have",
    ),
    "no joints key": (
        lambda f: change_manifest(f, lambda c: c["robot"].pop("joints")),
        "robot.joints: found no such key",
    ),
    "unknown joint": (
        lambda f: change_manifest(f, lambda c: c["robot"].update(joints=["j1", "j9"])),
        "'j9'.*joints of the URDF",
    ),
    "joints in disorder": (
        lambda f: change_manifest(f, lambda c: c["robot"].update(joints=["j2", "j1"])),
        "in its order",
    ),
    "joint twice": (lambda f: change_manifest(f, lambda c: c["robot"].update(joints=["j1", "j1"])), "in its order"),
    "unknown frame": (
        lambda f: change_manifest(f, lambda c: c["robot"].update(sensor_frame="tip")),
        "sensor_frame: found 'tip'",
    ),
    "no URDF": (lambda f: (f / "robot.urdf").unlink(), "robot.urdf: found no such file"),
    "URDF outside": (lambda f: change_manifest(f, lambda c: c["robot"].update(urdf="../robot.urdf")), "leads outside"),
    "URDF absolute": (lambda f: change_manifest(f, lambda c: c["robot"].update(urdf="/etc/passwd")), "leads outside"),
    "URDF linked out": (lambda f: link_out(f, "robot.urdf"), "leads outside"),
    "URDF name with NUL": (
        lambda f: change_manifest(f, lambda c: c["robot"].update(urdf="a\0b")),
        "cannot be followed",
    ),
    "URDF a loop of links": (
        lambda f: [(f / "robot.urdf").unlink(), (f / "robot.urdf").symlink_to(f / "robot.urdf")],
        "robot.urdf: found",
    ),
    "URDF not UTF-8": (lambda f: (f / "robot.urdf").write_bytes(b"\xfe\xff"), "UTF-8"),
    "no samples": (lambda f: (f / "samples.parquet").unlink(), "no samples"),
    "two samples": (lambda f: (f / "samples.csv").write_text("t\n0\n"), "exactly one of"),
    "samples linked out": (lambda f: link_out(f, "samples.parquet"), "leads outside"),
    "samples a pipe": (lambda f: [(f / "samples.parquet").unlink(), os.mkfifo(f / "samples.parquet")], "no file"),
    "Parquet truncated": (lambda f: cut(f / "samples.parquet", 0.7), "Parquet that cannot be read"),
    "Parquet empty file": (lambda f: cut(f / "samples.parquet", 0.0), "Parquet that cannot be read"),
    "Parquet in name only": (
        lambda f: (f / "samples.parquet").write_text("t,q_1\n0,1\n"),
        "Parquet that cannot be read",
    ),
    "no rows": (lambda f: change_samples(f, lambda t: t.slice(0, 0)), "0 rows"),
    "one row": (lambda f: change_samples(f, lambda t: t.slice(0, 1)), "1 rows"),
    "no time": (lambda f: drop(f, "t"), "column 't'.*no such column"),
    "no q_2": (lambda f: drop(f, "q_2"), "column 'q_2'.*no such column"),
    "half of dq": (lambda f: drop(f, "dq_1"), "column 'dq_1'.*no such column"),
    "five wrench columns": (lambda f: drop(f, "ty"), "column 'ty'.*no such column"),
    "neither wrench nor torques": (
        lambda f: drop(f, "fx", "fy", "fz", "tx", "ty", "tz", "tau_1", "tau_2"),
        "neither a wrench .* nor joint torques",
    ),
    "joints without robot": (lambda f: change_manifest(f, lambda c: c.pop("robot")), "without a robot"),
    "neither joints nor poses": (
        lambda f: [change_manifest(f, lambda c: c.pop("robot")), drop(f, "q_1", "q_2")],
        "neither joint positions",
    ),
    "more columns than joints": (
        lambda f: change_samples(f, lambda t: t.append_column("q_3", pa.array(np.ones(N)))),
        "'q_3'.*more columns than joints",
    ),
    "column twice": (
        lambda f: as_csv(f, lambda lines: [line + "," + ("t" if k == 0 else "1") for k, line in enumerate(lines)]),
        "'t'.*2 of them",
    ),
    "NaN": (lambda f: cell_of(f, "fy", 7, float("nan")), "'fy', row 7: found nan"),
    "infinite": (lambda f: cell_of(f, "q_2", 12, float("-inf")), "'q_2', row 12: found -inf"),
    "a gap": (lambda f: cell_of(f, "tz", 3, None), "'tz', row 3: found no value"),
    "text in Parquet": (lambda f: cell_of(f, "fx", 9, "n/a"), "'fx', row 9: found the text 'n/a'"),
    "text in CSV": (lambda f: cell_of(f, "fx", 9, "n/a", "csv"), "'fx', row 9: found the text 'n/a'"),
    "a gap in CSV": (lambda f: cell_of(f, "fx", 5, None, "csv"), "'fx', row 5: found no value"),
    "NaN in CSV": (lambda f: cell_of(f, "fx", 6, float("nan"), "csv"), "'fx', row 6: found nan"),
    "true and false": (lambda f: change_samples(f, lambda t: set_column(t, "fx", [True] * N)), "'fx'.*bool.*numbers"),
    "dates": (
        lambda f: change_samples(f, lambda t: t.set_column(0, "t", pa.array(range(N), pa.timestamp("ms")))),
        "'t'.*timestamp.*numbers",
    ),
    "time stands still": (lambda f: cell_of(f, "t", 5, float(recording().t[3])), "'t', row 5.*strictly increases"),
    "time runs backwards": (lambda f: cell_of(f, "t", 20, -1.0), "'t', row 20: found -1 s after"),
    "unknown phase": (lambda f: cell_of(f, "phase", 30, "dance"), "'phase', row 30: found 'dance'"),
    "no phase in a row": (lambda f: cell_of(f, "phase", 2, None), "'phase', row 2: found no value"),
    "phase a number": (lambda f: change_samples(f, lambda t: set_column(t, "phase", np.ones(N))), "'phase'.*text"),
    "CSV ends in the middle of a row": (
        lambda f: as_csv(f, lambda lines: [*lines[:-1], lines[-1][: len(lines[-1]) // 2].rpartition(",")[0]]),
        "row 40.* values",
    ),
    "CSV row too long": (
        lambda f: as_csv(f, lambda lines: [*lines[:4], lines[4] + ",1", *lines[5:]]),
        "row 4.* values",
    ),
    "CSV empty": (lambda f: as_csv(f, lambda _: []), "CSV that cannot be read|rows"),
    "packed CSV truncated": (
        lambda f: [save_samples(f, load_samples(f), "csv.gz"), cut(f / "samples.csv.gz", 0.6)],
        "CSV that cannot be read",
    ),
    "packed CSV not packed": (
        lambda f: [(f / "samples.parquet").unlink(), (f / "samples.csv.gz").write_text("t\n1\n")],
        "CSV that cannot be read",
    ),
}


@pytest.mark.parametrize("name", BROKEN)
def test_bad_input_is_refused_in_one_sentence(name: str, tmp_path: Path) -> None:
    break_it, words = BROKEN[name]
    folder = tmp_path / "run"
    write_recording(recording(), folder)
    break_it(folder)
    with pytest.raises(BadRecording, match=words) as caught:
        read_recording(folder)
    assert str(folder) in str(caught.value)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 900


POSES_BROKEN = {
    "not a rotation": (("qw", 8, 3.0), "row 8: found a norm"),
    "a zero quaternion's row": (("qx", 4, float("nan")), "'qx', row 4"),
}


@pytest.mark.parametrize("name", POSES_BROKEN)
def test_bad_poses_are_refused_with_their_row(name: str, tmp_path: Path) -> None:
    (column, row, value), words = POSES_BROKEN[name]
    turns = Rotation.random(N, random_state=4).as_matrix()
    write_recording(replace(recording(), robot=None, q=None, dq=None, q_cmd=None, tau=None, orientation=turns), tmp_path / "run")
    cell_of(tmp_path / "run", column, row, value)
    with pytest.raises(BadRecording, match=words):
        read_recording(tmp_path / "run")


def test_positions_alone_are_no_poses(tmp_path: Path) -> None:
    write_recording(
        replace(recording(), robot=None, q=None, dq=None, q_cmd=None, tau=None, position=np.zeros((N, 3))),
        tmp_path / "r",
    )
    with pytest.raises(BadRecording, match="nor poses"):
        read_recording(tmp_path / "r")


def test_a_hostile_urdf_in_a_recording_is_refused(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    text_of(tmp_path / "run", lambda s: "<!DOCTYPE a [<!ENTITY b 'c'>]>" + s, "robot.urdf")
    with pytest.raises(BadRobot, match="DOCTYPE"):
        read_recording(tmp_path / "run")


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadRecording, match="no such folder"):
        read_recording(tmp_path / "nowhere")


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    position=st.floats(0, 1, exclude_max=True),
    byte=st.integers(0, 255),
    name=st.sampled_from(["samples.parquet", "recording.json", "robot.urdf"]),
)
def test_a_damaged_byte_is_refused_or_read_but_never_anything_else(
    tmp_path_factory: pytest.TempPathFactory, position: float, byte: int, name: str
) -> None:
    folder = tmp_path_factory.mktemp("damaged") / "run"
    write_recording(recording(), folder)
    content = bytearray((folder / name).read_bytes())
    content[int(position * len(content))] = byte
    (folder / name).write_bytes(content)
    try:
        assert len(read_recording(folder)) == N
    except BadInput as error:
        assert "\n" not in str(error)
