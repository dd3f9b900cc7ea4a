"""`heft export` turns the JSON of an answer into what a controller takes, and says what got lost."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cell.folder import find_cell, load_cell
from core.cli.exports import read_result_file
from core.cli.main import app
from core.errors import BadInput
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.core.export.readers import READERS, read_xarm


@pytest.fixture
def written(tmp_path: Path) -> Path:
    file = tmp_path / "result.json"
    file.write_text(answer(cloud(0), "ur5e_line").model_dump_json())
    return file


def test_the_payload_is_given_in_the_frame_of_the_flange(written: Path):
    said = CliRunner().invoke(app, ["export", str(written), "--target", "urdf"])
    assert said.exit_code == 0, said.output
    mount = load_cell(find_cell("ur5e_line")).sensor.mount
    body = cloud(0).moved(mount.rotation, mount.translation)
    m, com, inertia = READERS["urdf"](said.stdout)
    assert m == pytest.approx(body.masses.sum())
    np.testing.assert_allclose(com, body.com, atol=1e-8)
    np.testing.assert_allclose(inertia, body.inertia(body.com), atol=1e-8)
    assert "the flange's frame" in said.stderr


@pytest.fixture
def foreign(tmp_path: Path) -> Path:
    """The answer for a recording that belongs to no cell."""
    file = tmp_path / "foreign.json"
    file.write_text(answer(cloud(0), None).model_dump_json())
    return file


def test_without_a_mount_nothing_is_written(foreign: Path):
    said = CliRunner().invoke(app, ["export", str(foreign), "--target", "xarm"])
    assert said.stdout == ""
    assert isinstance(said.exception, BadInput)
    assert "sensor.mount: found a payload in the sensor's frame" in str(said.exception)
    assert "--mount-xyz" in str(said.exception)


def test_a_mount_that_is_stated_turns_the_payload_to_the_flange(foreign: Path):
    mount = ["--mount-xyz", "0.01", "-0.02", "0.03", "--mount-rpy", "0", "0", "1.5707963267948966"]
    said = CliRunner().invoke(app, ["export", str(foreign), "--target", "xarm", *mount])
    assert said.exit_code == 0, said.stderr
    _, com, _ = read_xarm(said.stdout)
    x, y, z = cloud(0).com
    np.testing.assert_allclose(com, [0.01 - y, -0.02 + x, 0.03 + z], atol=1e-9)
    assert said.stderr.count("has no place for I") == 6


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--mount-rpy", "0", "0", "1"], "--mount-xyz X Y Z as well"),
        (["--mount-xyz", "0", "0", "0", "--cell", "ur5e_line"], "one of the two"),
        (["--mount-xyz", "0", "nan", "0"], "--mount-xyz, --mount-rpy: xyz_m.1"),
        (["--mount-xyz", "0", "0", "0", "--mount-rpy", "0", "0", "90"], "--mount-xyz, --mount-rpy: rpy_rad.2"),
        (["--cell", "nowhere"], "nowhere"),
    ],
)
def test_a_mount_that_is_none_is_refused_in_words(foreign: Path, options: list[str], words: str):
    said = CliRunner().invoke(app, ["export", str(foreign), "--target", "xarm", *options])
    assert said.stdout == ""
    assert isinstance(said.exception, BadInput)
    assert words in str(said.exception)


def test_the_targets_are_listed_where_none_is_named(written: Path):
    said = CliRunner().invoke(app, ["export", str(written)])
    assert "kuka_krl" in said.stdout
    assert "mujoco" in said.stdout


def test_what_is_no_answer_is_refused(tmp_path: Path):
    file = tmp_path / "other.json"
    file.write_text('{"cell": 3}')
    with pytest.raises(BadInput, match=r"other.json: cell"):
        read_result_file(file)
    with pytest.raises(BadInput, match="nothing that can be read"):
        read_result_file(tmp_path / "none.json")


def test_what_a_target_cannot_say_of_the_uncertainty_is_said_beside_it(written: Path):
    said = CliRunner().invoke(app, ["export", str(written), "--target", "kuka_sunrise"])
    assert "no place for the uncertainty" in said.stderr
    assert "mass +- " in said.stderr
    held = CliRunner().invoke(app, ["export", str(written), "--target", "ur"])
    assert "no place for the uncertainty" not in held.stderr
    assert "# mass +- " in held.stdout
