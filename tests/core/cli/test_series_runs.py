"""`heft compare` and `heft fuse` on answers that are written already."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.errors import BadInput
from core.estimation.result import ReferencePart, Result
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer


def written(folder: Path, name: str, seed: int, *, scatter: float = 1.0, reference: bool = False) -> Path:
    """The answer of one run of the same body, off by its own uncertainty times `scatter`."""
    known = answer(cloud(0), "ur5e_line")
    assert known.estimate is not None
    covariance, truth = np.array(known.estimate.covariance, dtype=float), np.array(known.estimate.phi, dtype=float)
    phi = np.random.default_rng(seed).multivariate_normal(truth, scatter**2 * covariance, method="cholesky")
    update: dict[str, object] = {"estimate": known.estimate.model_copy(update={"phi": phi.tolist()})}
    if reference:
        update["reference"] = ReferencePart(phi=truth.tolist(), source="CAD")
    file = folder / name / "result.json"
    file.parent.mkdir()
    file.write_text(Result.model_validate(known.model_copy(update=update).model_dump()).model_dump_json())
    return file.parent


@pytest.fixture
def english(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HEFT_LANGUAGE", "en")


def call(*arguments: object) -> str:
    said = CliRunner().invoke(app, [str(each) for each in arguments])
    assert said.exit_code == 0, said.output
    return " ".join(said.stdout.split())


@pytest.mark.usefixtures("english")
def test_runs_of_one_payload_agree_and_are_named(tmp_path: Path) -> None:
    folders = [written(tmp_path, f"run-{k}", k) for k in range(4)]
    said = call("compare", *folders)
    assert "The 4 runs agree" in said and "1: run-0" in said and "count as made under one condition" in said


@pytest.mark.usefixtures("english")
def test_runs_that_scatter_more_are_told_and_conditions_give_the_reproducibility(tmp_path: Path) -> None:
    folders = [written(tmp_path, f"run-{k}", k, scatter=6.0) for k in range(6)]
    target = tmp_path / "series.json"
    said = call("compare", *folders, "--conditions", "a,a,b,b,c,c", "--json", target)
    assert "scatter by more than they state" in said
    series = json.loads(target.read_text())
    mass = series["parameters"][0]
    assert mass["reproducibility_std"] >= mass["repeatability_std"] > 0.0
    assert series["differ"] and len(series["pairs"]) == 15


@pytest.mark.usefixtures("english")
def test_a_prior_has_a_share_in_the_answer_and_the_shares_add_up(tmp_path: Path) -> None:
    folders = [written(tmp_path, f"run-{k}", k, reference=True) for k in range(3)]
    series = json.loads(call("fuse", *folders, "--prior", "0.1", "--json", "-"))
    assert series["prior"] == "CAD" and series["prior_used"]
    for row in series["parameters"]:
        assert row["name"] != "m" or 0.0 < row["prior_weight"] < 1.0
    mass = series["parameters"][0]
    assert sum(mass["weights"]) + mass["prior_weight"] == pytest.approx(1.0)


@pytest.mark.usefixtures("english")
@pytest.mark.parametrize(("arguments", "said"), [(["--prior", "1"], "no reference in any of the runs"), ([], "neither result.json nor")])
def test_what_is_not_there_is_said(tmp_path: Path, arguments: list[str], said: str) -> None:
    from core.errors import BadInput

    folder = written(tmp_path, "run", 0) if arguments else tmp_path
    ended = CliRunner().invoke(app, ["fuse", str(folder), *arguments])
    assert isinstance(ended.exception, BadInput) and said in str(ended.exception)


def test_the_answer_is_said_in_german(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HEFT_LANGUAGE", "de")
    said = call("fuse", *(written(tmp_path, f"run-{k}", k) for k in range(2)))
    assert "Die 2 Läufe stimmen überein" in said and "Anteil jedes Laufs" in said


@pytest.mark.usefixtures("english")
@pytest.mark.parametrize("command", ["compare", "fuse"])
def test_a_run_that_is_named_twice_is_refused(tmp_path: Path, command: str) -> None:
    one, other = written(tmp_path, "one", 1), written(tmp_path, "other", 2)
    copy = tmp_path / "copy.json"
    copy.write_text((one / "result.json").read_text())
    said = CliRunner().invoke(app, [command, str(one), str(other), str(copy)])
    assert isinstance(said.exception, BadInput)
    assert "in every digit" in str(said.exception)
