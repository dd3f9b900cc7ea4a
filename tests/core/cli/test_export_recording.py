"""What is exported, read by `rosbags` and by numpy, and taken in again by `heft import`."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from rosbags.highlevel import AnyReader
from typer.testing import CliRunner

from core.cli.main import app
from core.errors import BadInput
from core.recording.folder import read_recording, write_recording
from core.recording.recording import Recording
from core.robot.model import RobotModel
from tests.synthetic import payload, record, run_of


@pytest.fixture(scope="module")
def recording() -> Recording:
    return record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1))


def test_an_mcap_file_is_what_rosbags_reads_and_what_import_takes(tmp_path: Path, recording: Recording) -> None:
    write_recording(recording, tmp_path / "recording")
    file = tmp_path / "out.mcap"
    said = CliRunner().invoke(app, ["export-recording", str(tmp_path / "recording"), "--out", str(file)])
    assert said.exit_code == 0, said.output
    n = len(recording)
    poses = RobotModel(recording.robot).sensor_poses(recording.q)
    with AnyReader([file]) as bag:
        counts = {each.topic: each.msgcount for each in bag.connections}
        assert counts["/wrench"] == counts["/joint_states"] == counts["/tf"] == n
        seen = dict.fromkeys(counts, 0)
        for connection, ns, content in bag.messages():
            k = seen[connection.topic]
            seen[connection.topic] += 1
            if k % 500:
                continue
            message = bag.deserialize(content, connection.msgtype)
            if connection.topic == "/wrench":
                force, torque = message.wrench.force, message.wrench.torque
                assert [force.x, force.y, force.z, torque.x, torque.y, torque.z] == recording.wrench[k].tolist()
                assert message.header.frame_id == recording.robot.sensor_frame
                assert message.header.stamp.sec * 10**9 + message.header.stamp.nanosec == ns == round(1e9 * recording.t[k])
            elif connection.topic == "/joint_states":
                assert tuple(message.name) == recording.robot.joints
                assert np.array_equal(message.position, recording.q[k])
            elif connection.topic == "/tf":
                (transform,) = message.transforms
                where = transform.transform.translation
                assert [where.x, where.y, where.z] == pytest.approx(poses.position[k].tolist(), abs=1e-12)
            elif connection.topic == "/robot_description":
                assert message.data == recording.robot.urdf
    back = CliRunner().invoke(app, ["import", str(file), "--out", str(tmp_path / "back")])
    assert back.exit_code == 0, back.output
    again = read_recording(tmp_path / "back")
    assert np.array_equal(again.wrench, recording.wrench)
    assert np.array_equal(again.q, recording.q)
    assert again.robot.joints == recording.robot.joints


def test_a_csv_has_the_columns_of_the_recording_bit_for_bit(tmp_path: Path, recording: Recording) -> None:
    write_recording(recording, tmp_path / "recording")
    file = tmp_path / "out.csv"
    said = CliRunner().invoke(app, ["export-recording", str(tmp_path / "recording"), "--format", "csv", "--out", str(file)])
    assert said.exit_code == 0, said.output
    names = file.read_text().splitlines()[0].replace('"', "").split(",")
    kept = [k for k, name in enumerate(names) if name != "phase"]
    values = np.loadtxt(file, delimiter=",", skiprows=1, usecols=kept)
    assert np.array_equal(values[:, [names.index(name) for name in ("fx", "fy", "fz", "tx", "ty", "tz")]], recording.wrench)
    assert np.array_equal(values[:, names.index("t")], recording.t)


def test_nothing_is_overwritten_and_nothing_half_written(tmp_path: Path, recording: Recording) -> None:
    write_recording(recording, tmp_path / "recording")
    (tmp_path / "there.mcap").write_text("kept")
    for out in (tmp_path / "there.mcap", tmp_path / "nowhere" / "x.mcap"):
        said = CliRunner().invoke(app, ["export-recording", str(tmp_path / "recording"), "--out", str(out)])
        assert isinstance(said.exception, BadInput)
    assert sorted(each.name for each in tmp_path.iterdir()) == ["recording", "there.mcap"]
    assert (tmp_path / "there.mcap").read_text() == "kept"
