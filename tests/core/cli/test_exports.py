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
from tests.core.export.test_exports import READERS


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


def test_without_a_cell_it_stays_in_the_sensors_frame_and_that_is_said(tmp_path: Path):
    file = tmp_path / "result.json"
    file.write_text(answer(cloud(0), None).model_dump_json())
    said = CliRunner().invoke(app, ["export", str(file), "--target", "kuka_sunrise"])
    assert "sensor.mount" in said.stderr
    assert said.stderr.count("has no place for I") == 3


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
