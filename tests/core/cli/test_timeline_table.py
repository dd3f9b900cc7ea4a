"""`heft diagnose A B C`: recordings of one cell over weeks."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from core.cli.main import app
from core.cli.timeline_table import find_leading_parameter
from core.errors import BadInput
from core.gap.timeline import Timeline, trace_effects
from core.recording.folder import write_recording
from tests.core.gap.test_instruction import diagnosis, found
from tests.synthetic import Imperfections, payload, record, run_of

TILT_RAD = 0.02


def written(folder: Path, name: str, **answer: object) -> str:
    file = folder / f"{name}.json"
    file.write_text(diagnosis(**{"verdict": "no_gap", **answer}).model_dump_json())  # type: ignore[arg-type]  # a verdict and other parts
    return str(file)


@pytest.mark.thorough
def test_a_base_that_came_out_of_level_is_told_with_its_size_and_its_time_and_answers_take_the_place_of_recordings(tmp_path: Path) -> None:
    for name, imperfections in (("before", Imperfections()), ("after", Imperfections(tilt_rad=(TILT_RAD, 0.0)))):
        motion = run_of(repetitions=1)
        write_recording(record(motion, payload("steel_block"), np.random.default_rng(1), imperfections), tmp_path / name)
    earlier = written(tmp_path, "earlier")
    answer, report = tmp_path / "answer.json", tmp_path / "report"
    recordings = [earlier, str(tmp_path / "before"), str(tmp_path / "after")]
    said = CliRunner().invoke(app, ["diagnose", *recordings, "--json", str(answer), "--report", str(report)])
    assert said.exit_code == 0, said.output
    assert "Came between before and after: a base that is not level." in said.output
    told = Timeline.model_validate_json(answer.read_bytes())
    tilt = next(effect for effect in told.effects if effect.id == "base_tilt")
    assert [sighting.state for sighting in tilt.sightings] == ["absent", "absent", "present"]
    assert np.hypot(*(value.value for value in tilt.sightings[2].parameters.values())) > 0.9 * TILT_RAD
    assert (report / "timeline.json").read_bytes() == answer.read_bytes()
    # what was diagnosed once need not be again
    again = CliRunner().invoke(app, ["diagnose", str(report / "2" / "diagnosis.json"), str(report / "3" / "diagnosis.json"), "--json", "-"])
    assert Timeline.model_validate_json(again.output).effects[0].onsets[0].by == 1


def test_the_column_of_a_recording_has_the_mark_and_the_most_certain_parameter(tmp_path: Path) -> None:
    late = {"verdict": "explained", "effects": [found("time_delay", slight=0.001, delay_s=0.02)]}
    said = CliRunner().invoke(app, ["diagnose", written(tmp_path, "one"), written(tmp_path, "two", **late)], env={"COLUMNS": "120"})
    row = next(line for line in said.output.splitlines() if "time_delay" in line)
    assert [cell.strip() for cell in row.split("│")[1:4]] == ["time_delay: delay", "–", "✓ 0.0200 ± 0.0010"]


def test_where_nothing_was_fitted_there_is_no_parameter() -> None:
    told = trace_effects(["one", "two"], [diagnosis("no_gap"), diagnosis("explained", effects=[found("time_delay")])])
    assert find_leading_parameter(told.effects[0]) is None


def test_the_leading_parameter_is_the_one_that_any_recording_shows_most_certainly_not_the_one_that_the_last_does() -> None:
    first = diagnosis("explained", effects=[found("time_delay", delay_s=0.02)])
    last = diagnosis("explained", effects=[found("time_delay", delay_s=0.002, slight=0.01)])
    assert find_leading_parameter(trace_effects(["one", "two"], [first, last]).effects[0]) == "delay_s"


def test_an_experiment_continues_one_recording_only(tmp_path: Path) -> None:
    both = [written(tmp_path, "one"), written(tmp_path, "two")]
    said = CliRunner().invoke(app, ["diagnose", *both, "--cell", "lwr4_bench", "--experiment", str(tmp_path / "next.json")])
    assert isinstance(said.exception, BadInput)
    assert said.exception.message.code == "cli-experiment-of-several"
