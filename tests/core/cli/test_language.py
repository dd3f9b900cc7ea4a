"""What a terminal prints is in its language; what programs read is the same in every language."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.cli.plan_tables import torque_lines
from core.cli.tables import diagnosis_table
from core.gap.answering import not_enough
from core.planning.summary import PlanTorques
from core.words.message import Message
from tests.core.cli.command import heft, heft_process
from tests.core.export.cloud import cloud
from tests.core.export.known_result import answer
from tests.core.gap.test_instruction import diagnosis, found


@pytest.mark.parametrize(
    ("environment", "words"),
    [
        ({"HEFT_LANGUAGE": "de"}, "gefunden: „piano“, erwartet: eine von steel_block, cylinder"),
        ({"LANG": "de_CH.UTF-8"}, "gefunden: „piano“, erwartet: eine von steel_block, cylinder"),
        ({"LANG": "de_CH.UTF-8", "HEFT_LANGUAGE": "en"}, "found 'piano', expected one of steel_block, cylinder"),
        ({}, "found 'piano', expected one of steel_block, cylinder"),
    ],
    ids=["asked for", "of the system", "asked for against the system", "nothing said"],
)
def test_an_error_is_said_in_the_language_of_the_terminal(environment: dict[str, str], words: str) -> None:
    done = heft("plan", "ur5e_line", "--payload", "piano", **environment)
    assert done.returncode == 2
    assert done.stderr.startswith("heft: ")
    assert words in done.stderr


def test_a_plan_is_printed_in_german_and_its_json_is_what_it_always_is(tmp_path: Path) -> None:
    file = tmp_path / "plan.json"
    done = heft("plan", "ur5e_line", "--axes", "z", "--holds-only", "--json", str(file), HEFT_LANGUAGE="de")
    assert done.returncode == 0, done.stderr
    for words in (
        "Plan (nichts hat sich bewegt)",
        "Gelenke, Grad",
        "Roboterzeit ",
        "Durch Drehungen nicht zu bestimmen",
        "schnellster Punkt",
    ):
        assert words in done.stdout
    assert "Robot time" not in done.stdout
    assert [pose["axis"] for pose in json.loads(file.read_text())["poses"]] == ["z-", "z+"]


def test_the_cells_are_listed_in_german() -> None:
    done = heft_process("cells", HEFT_LANGUAGE="de")
    assert "Schutzzonen" in done.stdout


def test_an_export_says_what_it_lacks_in_german(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HEFT_LANGUAGE", "de")
    file = tmp_path / "result.json"
    file.write_text(answer(cloud(0), None).model_dump_json())
    said = CliRunner().invoke(app, ["export", str(file), "--target", "kuka_sunrise", "--mount-xyz", "0", "0", "0"])
    assert said.stderr.count("hat keinen Platz für I") == 3


def test_tables_and_lines_are_in_german_with_its_decimal_mark(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HEFT_LANGUAGE", "de")
    assert str(diagnosis_table(not_enough(Message.of("text", text="too short"), 0.1)).title).startswith("zu wenig: ")
    late = diagnosis("explained", effects=[found("time_delay", delay_s=0.02, slight=0.01)])
    assert str(next(iter(diagnosis_table(late).columns[4].cells))).splitlines()[0] == "Verzögerung 0,0200 ± 0,0010"
    told = PlanTorques(load="a guessed mass", mass_kg=1.0, largest=None, not_judged=[])
    assert torque_lines(told)[0].startswith("Gelenkmomente mit 1,000 kg")


def test_help_says_how_to_choose_the_language() -> None:
    assert "HEFT_LANGUAGE" in heft("--help", HEFT_LANGUAGE="de").stdout
