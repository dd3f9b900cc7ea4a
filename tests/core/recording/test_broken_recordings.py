"""What is not `recording/1` is refused in one sentence."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from core.errors import BadInput, BadRecording, BadRobot
from core.recording.folder import read_recording, write_recording
from tests.core.recording.recording_damage import (
    as_csv,
    cell_of,
    change_manifest,
    change_samples,
    cut,
    deep_json,
    drop,
    link_out,
    load_samples,
    save_samples,
    set_column,
    text_of,
)
from tests.core.recording.small_recording import N, recording

BROKEN: dict[str, tuple[Callable[[Path], object], str]] = {
    "no manifest": (lambda f: (f / "recording.json").unlink(), "recording.json.*no such file"),
    "manifest is a folder": (lambda f: [(f / "recording.json").unlink(), (f / "recording.json").mkdir()], "no file"),
    "manifest not JSON": (lambda f: text_of(f, lambda s: s[:-9]), "JSON that does not parse"),
    "manifest a list": (lambda f: text_of(f, lambda _: "[1]"), "JSON that is no object.*a JSON object"),
    "manifest nested too deep": (deep_json, "JSON that does not parse"),
    "manifest not UTF-8": (lambda f: (f / "recording.json").write_bytes(b'{"format": "\xff"}'), "0xff at position 12"),
    "manifest huge": (lambda f: text_of(f, lambda s: s + " " * 1_100_000), "at most 1000000"),
    "manifest linked out": (lambda f: link_out(f, "recording.json"), "leads outside"),
    "no format": (lambda f: change_manifest(f, lambda c: c.pop("format")), "format: found no such key"),
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
    "friction of one joint": (
        lambda f: change_manifest(f, lambda c: c["robot"]["friction"]["coulomb_n_m"].pop()),
        "robot.friction.coulomb_n_m: found 1 value, expected 2, one for each joint",
    ),
    "friction that drives": (
        lambda f: change_manifest(f, lambda c: c["robot"]["friction"].update(viscous_n_m_s=[-1, 0])),
        "robot.friction.viscous_n_m_s.0: found -1",
    ),
    "friction misspelt": (
        lambda f: change_manifest(f, lambda c: c["robot"]["friction"].update(coulomb_nm=c["robot"]["friction"].pop("coulomb_n_m"))),
        "coulomb_nm.*'coulomb_n_m'",
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
    "one row": (lambda f: change_samples(f, lambda t: t.slice(0, 1)), "1 row,"),
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


@pytest.mark.parametrize("text", [b"hold:free", b"phase"])
def test_a_text_that_is_not_utf_8_is_refused(tmp_path: Path, text: bytes) -> None:
    write_recording(recording(), tmp_path / "run")
    file = tmp_path / "run" / "samples.parquet"
    content = file.read_bytes()
    assert text in content
    file.write_bytes(content.replace(text, b"\x80" + text[1:]))
    with pytest.raises(BadRecording, match=r"samples\.parquet"):
        read_recording(tmp_path / "run")


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
