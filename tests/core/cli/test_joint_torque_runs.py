"""The payload through the joints at the command line: the same motions with it and without it, then the answer from both."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cli.answer_file import read_result_file
from core.cli.main import app
from core.errors import BadInput
from core.payload.inertia import PHI_NAMES


def run(*arguments: object) -> str:
    said = CliRunner().invoke(app, list(map(str, arguments)))
    assert said.exit_code == 0, said.output
    return said.output


@pytest.mark.thorough
def test_the_same_motions_with_the_payload_and_without_it_tell_what_it_is(tmp_path: Path) -> None:
    loaded, empty = tmp_path / "loaded", tmp_path / "empty"
    motions = ("run", "lwr4_bench", "--payload", "steel_block", "--for", "joint-torques", "--axes", "x")
    run(*motions, "--empty", "--out", empty)
    run(*motions, "--without", empty, "--out", loaded)
    with_it, without_it = (read_result_file(folder / "result.json") for folder in (loaded, empty))
    assert with_it.plan_sha256 == without_it.plan_sha256
    assert (with_it.payload, without_it.payload, without_it.reference) == ("steel_block", None, None)
    run("identify", loaded, "--without", empty, "--json", tmp_path / "both.json")
    found = read_result_file(tmp_path / "both.json")
    assert found.estimate is not None and found.reference is not None
    assert with_it.estimate == found.estimate, "the run has answered from both already"
    assert found.estimate.determined[:4] == [True] * 4
    known = [k for k in range(10) if found.estimate.determined[k]]
    z = {
        PHI_NAMES[k]: ((found.estimate.phi[k] or 0.0) - (found.reference.phi[k] or 0.0)) / (found.estimate.std[k] or np.nan) for k in known
    }
    assert max(map(abs, z.values())) < 3.0, z


def test_joint_torques_go_with_neither_holds_alone_nor_a_target() -> None:
    for option in (("--holds-only",), ("--target", "mass=1%")):
        refused = CliRunner().invoke(app, ["plan", "lwr4_bench", "--for", "joint-torques", *option]).exception
        assert isinstance(refused, BadInput)
        assert option[0] in str(refused)


def test_what_is_compared_is_a_whole_run_with_the_payload() -> None:
    for option in (("--empty",), ("--target", "mass=1%")):
        refused = CliRunner().invoke(app, ["run", "lwr4_bench", "--without", "alone", *option]).exception
        assert isinstance(refused, BadInput)
        assert (refused.message.code, option[0] in str(refused)) == ("torques-without-beside", True)


def test_an_experiment_is_made_as_it_is() -> None:
    refused = CliRunner().invoke(app, ["run", "lwr4_bench", "--experiment", "motion.json", "--for", "joint-torques"]).exception
    assert isinstance(refused, BadInput)
    assert refused.message.code == "cli-experiment-beside-others"
