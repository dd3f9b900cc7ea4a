from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import Result
from scipy.spatial.transform import Rotation
from typer.testing import CliRunner

from core.cli import import_log
from core.cli.answer_file import read_result_file
from core.cli.main import app
from core.errors import BadInput, BadRecording
from core.recording.folder import read_recording
from core.recording.logs.question import OpenQuestion
from core.robot.model import RobotModel
from tests.synthetic import payload, record, run_of

REAL = Path(__file__).parents[3] / "docs" / "logs"
KUKA, UR5 = REAL / "kuka-med14", REAL / "ur5-pushes"


def run(*arguments: object) -> Result:
    return CliRunner().invoke(app, ["import", *map(str, arguments)])


@pytest.mark.parametrize("log", [KUKA, UR5])
def test_logs_of_real_arms_come_in_with_a_mapping_of_twelve_lines(tmp_path: Path, log: Path) -> None:
    assert len((log / "map.toml").read_text().splitlines()) <= 12
    said = run(log, "--map", log / "map.toml", "--out", tmp_path / "recording")
    assert said.exit_code == 0, said.output
    assert "Nothing speaks against it" in said.output
    recording = read_recording(tmp_path / "recording")
    assert recording.t[-1] > 6.0
    assert recording.orientation is not None


def test_without_a_mapping_the_sign_is_the_one_with_which_the_payload_weighs_something(tmp_path: Path) -> None:
    said = run(*KUKA.glob("*.csv.gz"), "--out", tmp_path / "recording")
    assert said.exit_code == 0, said.output
    assert "what the payload exerts on the sensor" in said.output
    run(KUKA, "--map", KUKA / "map.toml", "--out", tmp_path / "mapped")
    proposed, mapped = (read_recording(tmp_path / folder) for folder in ("recording", "mapped"))
    assert np.array_equal(proposed.wrench, mapped.wrench)
    assert np.array_equal(proposed.orientation, mapped.orientation)
    again = run(KUKA, "--map", tmp_path / "recording" / "map.toml", "--out", tmp_path / "again")
    assert again.exit_code == 0, again.output


def test_what_no_sample_tells_is_a_question_that_an_option_answers(tmp_path: Path) -> None:
    names = "wrench.csv.gz", "orientations.csv.gz"
    files = [KUKA / name for name in names]
    other = tmp_path / "other.csv.gz"
    other.write_bytes(files[0].read_bytes())
    asked = run(*files, other, "--out", tmp_path / "recording").exception
    assert isinstance(asked, OpenQuestion)
    assert "--set 'wrench.file=other.csv.gz'" in str(asked)
    assert not (tmp_path / "recording").exists()
    said = run(*files, other, "--set", "wrench.file=other.csv.gz", "--out", tmp_path / "recording")
    assert said.exit_code == 0, said.output


def test_on_a_terminal_the_question_is_asked_until_it_is_answered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(import_log, "_can_ask", lambda: True)
    other = tmp_path / "other.csv.gz"
    other.write_bytes((KUKA / "wrench.csv.gz").read_bytes())
    files = [str(KUKA / "wrench.csv.gz"), str(KUKA / "orientations.csv.gz"), str(other)]
    said = CliRunner().invoke(app, ["import", *files, "--out", str(tmp_path / "recording")], input="none\n7\n2\n")
    assert said.exit_code == 0, said.output
    assert 'file = "other.csv.gz"' in (tmp_path / "recording" / "map.toml").read_text()


def test_a_bag_that_was_cut_off_is_refused_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "log.mcap").write_bytes(b"\x89MCAP0\r\n\x01\xff")
    said = run(tmp_path / "log.mcap", "--out", tmp_path / "recording")
    assert isinstance(said.exception, BadRecording)
    assert said.exception.message.code == "bag-broken"
    assert [each.name for each in tmp_path.iterdir()] == ["log.mcap"]


def exported(folder: Path, *, scale: float = 1.0) -> list[str]:
    """A run of the LWR 4+ as somebody else's log: joints in degrees, torque times `scale`."""
    run = run_of(repetitions=1)
    recording = record(run, payload("steel_block"), np.random.default_rng(1))
    poses = RobotModel(recording.robot).sensor_poses(recording.q)
    values = {"time_ms": 1e3 * recording.t}
    values |= {f"force_{axis}": recording.wrench[:, k] for k, axis in enumerate("xyz")}
    values |= {f"torque_{axis}": scale * recording.wrench[:, 3 + k] for k, axis in enumerate("xyz")}
    quaternions = Rotation.from_matrix(poses.rotation).as_quat()
    values |= {f"quat_{axis}": quaternions[:, k] for k, axis in enumerate("xyzw")}
    values |= {f"pos_{axis}": poses.position[:, k] for k, axis in enumerate("xyz")}
    values |= {f"j{k + 1}": np.degrees(recording.q[:, k]) for k in range(7)}
    np.savetxt(folder / "log.csv", np.column_stack(list(values.values())), delimiter=",", header=",".join(values), comments="")
    return [str(folder / "log.csv")]


def test_a_slip_in_a_log_is_named_and_nothing_is_written(tmp_path: Path) -> None:
    said = run(*exported(tmp_path, scale=1000.0), "--out", tmp_path / "recording")
    assert isinstance(said.exception, BadRecording)
    assert said.exception.message.code == "import-contradiction"
    assert "N mm" in str(said.exception)
    assert not (tmp_path / "recording").exists()


def test_what_is_imported_gives_the_payload_that_the_log_was_made_with(tmp_path: Path) -> None:
    said = run(*exported(tmp_path), "--out", tmp_path / "recording")
    assert said.exit_code == 0, said.output
    answer = CliRunner().invoke(app, ["identify", str(tmp_path / "recording"), "--json", str(tmp_path / "answer.json")])
    assert answer.exit_code == 0, answer.output
    estimate = read_result_file(tmp_path / "answer.json").estimate
    assert estimate is not None
    assert estimate.phi[0] == pytest.approx(payload("steel_block").phi[0], rel=2e-3)


def test_joints_come_in_with_the_urdf_beside_the_mapping(tmp_path: Path) -> None:
    exported(tmp_path)
    robot = record(run_of(repetitions=1), payload("steel_block"), np.random.default_rng(1)).robot
    (tmp_path / "arm.urdf").write_text(robot.urdf)
    columns = ", ".join(f'"j{k + 1}"' for k in range(7))
    (tmp_path / "map.toml").write_text(
        '[wrench]\ntime = "time_ms"\ntime_unit = "ms"\nforce = ["force_x", "force_y", "force_z"]\n'
        'torque = ["torque_x", "torque_y", "torque_z"]\n[joints]\ntime = "time_ms"\ntime_unit = "ms"\nangle_unit = "deg"\n'
        f'urdf = "arm.urdf"\nnames = {list(robot.joints)}\nbase_frame = "{robot.base_frame}"\n'
        f'sensor_frame = "{robot.sensor_frame}"\nposition = [{columns}]\n'
    )
    out = tmp_path / "recording"
    said = run(tmp_path / "log.csv", "--map", tmp_path / "map.toml", "--out", out)
    assert said.exit_code == 0, said.output
    made = read_recording(out)
    assert made.robot is not None
    assert made.robot.joints == robot.joints
    assert made.q is not None
    assert made.q.shape[1] == 7


def test_a_folder_that_is_there_and_a_log_that_is_not_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "x.csv").write_text("1,2\n")
    assert isinstance(run(tmp_path / "a" / "x.csv", "--out", tmp_path / "a").exception, BadInput)
    assert isinstance(run(tmp_path / "none.csv", "--out", tmp_path / "o").exception, BadInput)
    assert isinstance(run(KUKA / "wrench.csv.gz", "--set", "wrench.sign", "--out", tmp_path / "o").exception, BadInput)
