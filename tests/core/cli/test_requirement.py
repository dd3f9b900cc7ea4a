"""`heft requirement` from end to end."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cell.folder import load_cell
from core.cli.main import app
from core.errors import BadInput
from core.estimation.result import EstimatePart, PaperPart, Result, SecondsPart
from core.words.message import Message

CELL = Path(__file__).parents[3] / "cells" / "lwr4_bench"
STD = [0.003, *[0.0003] * 3, *[0.00008] * 6]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two seconds away from home and back, so that a test need not wait for brisk ones."""
    home = np.array(load_cell(CELL).robot.home_rad)
    file = tmp_path_factory.mktemp("program") / "program.csv"
    rows = [(0.0, home), (1.0, home + 0.3), (2.0, home)]
    file.write_text("t_s" + ",q_rad" * len(home) + "\n" + "".join(f"{t},{','.join(map(str, q))}\n" for t, q in rows))
    return file


def answer(folder: Path, *, widened: float = 1.0, determined: bool = True) -> Path:
    """A file as --json writes it."""
    phi = load_cell(CELL).payloads["steel_block"].parameters.phi
    std = widened * np.array(STD)
    estimate = EstimatePart(
        phi=phi.tolist(), std=std.tolist(), covariance=np.diag(std**2).tolist(), determined=[determined] * 10, reasons={}, offset=[0.0] * 6,
        offset_std=[0.0] * 6, com_m=[0.0] * 3, com_std_m=[0.0] * 3, inertia_com_kg_m2=[0.0] * 6, inertia_com_std_kg_m2=[0.0] * 6,
        consistent=True, base_tilt_rad=None, base_tilt_std_rad=None, delay_s=None, delay_std_s=None,
    )  # fmt: skip
    result = Result(
        cell="lwr4_bench", payload=None, verdict=Message.of("text", text="made up"), warnings=[], reference=None,
        paper=PaperPart(phi=[], std=[]), estimate=estimate, residual=None, safety=None, seconds=SecondsPart(robot=60.0, estimate=1.0),
        recording=None,
    )  # fmt: skip
    file = folder / "answer.json"
    file.write_text(result.model_dump_json())
    return file


def told(*arguments: str) -> dict:
    said = CliRunner().invoke(app, ["requirement", "lwr4_bench", *arguments, "--json", "-"])
    assert said.exit_code == 0, said.output
    return json.loads(said.stdout)


def test_what_may_be_off_is_said_for_mass_centre_of_mass_and_inertia(program: Path) -> None:
    said = CliRunner().invoke(app, ["requirement", "lwr4_bench", "--program", str(program)], env={"HEFT_LANGUAGE": "en"})
    assert said.exit_code == 0, said.output
    assert "centre of mass" in said.output
    assert "[thresholds] in cell.toml" in said.output
    assert "No answer to judge" in said.output


def test_an_answer_is_good_enough_until_its_uncertainty_grows_by_the_margin(program: Path, tmp_path: Path) -> None:
    first = told("--program", str(program), "--result", str(answer(tmp_path)))["adequacy"]
    assert first["good_enough"]
    wider = told("--program", str(program), "--result", str(answer(tmp_path, widened=1.02 * first["margin"])))
    assert not wider["adequacy"]["good_enough"]
    assert wider["message"]["code"] == "requirement-not-good-enough"
    assert wider["adequacy"]["used"] == pytest.approx(1.02, rel=0.01)


def test_an_answer_in_which_something_is_not_determined_is_not_judged(program: Path, tmp_path: Path) -> None:
    found = told("--program", str(program), "--result", str(answer(tmp_path, determined=False)))
    assert found["adequacy"] is None
    assert found["message"]["code"] == "requirement-not-determined"


def test_a_program_of_another_robot_is_refused(tmp_path: Path) -> None:
    (tmp_path / "program.csv").write_text("t,q\n0,0,0\n1,0,0\n")
    said = CliRunner().invoke(app, ["requirement", "lwr4_bench", "--program", str(tmp_path / "program.csv")])
    assert isinstance(said.exception, BadInput)
