"""`--target` at the terminal: of a recording, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.errors import BadInput
from core.recording.folder import write_recording
from tests.synthetic import payload, record, run_of


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("target") / "recording"
    write_recording(record(run_of("lwr4_bench", period=0.004), payload("steel_block"), np.random.default_rng(0)), folder)
    return folder


def identify(recording: Path, *options: str) -> dict:
    done = CliRunner().invoke(app, ["identify", str(recording), "--json", "-", *options], catch_exceptions=False)
    assert done.exit_code == 0, done.output
    return json.loads(done.stdout)


def test_a_recording_is_held_against_a_target(recording: Path) -> None:
    found = identify(recording, "--target", "mass=5%,inertia=0.5%")["target"]
    assert [(each["quantity"], each["standing"]) for each in found["quantities"]] == [("mass", "reached"), ("inertia", "type_b")]
    assert found["standing"] == "type_b"
    assert found["left_out"] is None
    assert identify(recording)["target"] is None


@pytest.mark.thorough
def test_the_requirement_is_that_of_the_cell_that_is_named(recording: Path) -> None:
    found = identify(recording, "--target", "requirement", "--cell", "lwr4_bench")
    assert found["target"]["standing"] == "reached"
    assert found["requirement"]["adequacy"]["good_enough"]
    assert found["target"]["quantities"][0]["half_width"] == pytest.approx(found["requirement"]["adequacy"]["used"])


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (["identify", "somewhere", "--target", "requirement"], "--cell CELL"),
        (["identify", "somewhere", "--target", "mass=heavy"], "mass=0.1%"),
        (["run", "lwr4_bench", "--target", "0.1%"], "mass=0.1%"),
        (["plan", "lwr4_bench", "--target", "0.1%"], "mass=0.1%"),
        (["run", "lwr4_bench", "--target", "mass=1%", "--experiment", "proposed.json"], "one of them"),
    ],
)
def test_what_is_no_target_is_refused_before_anything_is_read_or_planned(command: list[str], words: str) -> None:
    done = CliRunner().invoke(app, command)
    assert isinstance(done.exception, BadInput), done.output
    assert words in str(done.exception)
