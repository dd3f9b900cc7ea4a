"""The report of one identification: a single HTML file that needs no network, for an operator and for an engineer."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import Any

import numpy as np

from core.estimation.estimate import Identification
from core.procedure.summary import RunSummary
from core.recording.recording import Recording
from core.report.budget_rows import read_budget
from core.report.charts import distance_chart, rotation_chart, wrench_chart
from core.report.faces import arm_parts
from core.report.html_file import write_html
from core.report.opinion_rows import opinion_table
from core.report.record import Record, render_record
from core.report.requirement_words import requirement_block
from core.report.rows import channel_rows, facts, joint_rows, origin_facts, parameter_rows, sentence, start_lines, unseen_rows
from core.report.scene import scene
from core.report.target_words import target_block
from core.report.workpiece_rows import workpiece_block
from core.requirement.answer import RequirementPart
from core.requirement.target_answer import TargetPart
from core.robot.model import RobotModel
from core.version import code_version
from core.words.catalogue import Language
from core.words.wording import Wording


def write_report(
    file: Path,
    *,
    recording: Recording,
    identification: Identification,
    run: RunSummary | None = None,
    requirement: RequirementPart | None = None,
    target: TargetPart | None = None,
    at: datetime | None = None,
    language: Language = "en",
) -> None:
    """Writes the report; the file appears complete or not at all, and replaces an older one of the same name.

    Args:
        recording: what was identified.
        identification: the answer.
        run: what the guard and the plan saw; None for a recording from elsewhere.
        requirement: whether it is good enough for the cell; None where no cell is known.
        target: how far it meets what was asked for; None where that was nothing.
        at: when it was found; None where nobody says.
        language: of the page.
    """
    words = Wording(language)
    content = _content(recording, identification, run, at, words)
    content["requirement"] = requirement_block(requirement, words)
    content["target"] = target_block(target, words)
    write_html(file, "template.html", content, words)


def _content(
    recording: Recording, identification: Identification, run: RunSummary | None, at: datetime | None, words: Wording
) -> dict[str, Any]:
    rows = parameter_rows(identification, recording.reference_of_whole, words)
    payload = run.payload if run is not None else recording.payload
    return {
        "title": words.say("report-title", payload=payload.replace("_", " ")) if payload else words.say("report-title-unnamed"),
        "subtitle": run.cell.title if run is not None else (recording.cell or words.say("report-from-recording")),
        "verdict": sentence(identification.verdict, words),
        "record": render_record(_make_record(recording, run, at), words),
        "warnings": [sentence(warning, words) for warning in identification.warnings],
        "joints": joint_rows(identification, words),
        "facts": facts(identification, run, words),
        "parameters": rows if any(row.known or row.paper or row.reference for row in rows) else [],
        "has_reference": recording.reference is not None,
        "has_reasons": any(row.reason for row in rows),
        "has_outside": any(row.outside for row in rows),
        "reference_source": recording.source_of_whole,
        "budget": None if identification.estimate is None else read_budget(identification.estimate, words),
        "workpiece": workpiece_block(identification, recording, words),
        "channels": channel_rows(identification.estimate, words)
        if identification.has_wrench and identification.estimate is not None
        else [],
        "unseen": unseen_rows(identification, words),
        "drift": sentence(identification.estimate.drift.description, words) if identification.estimate is not None else "",
        **_charts(identification, words),
        "starts": [] if run is None else _starts(run, words),
        "distance_chart": None if run is None else _distances(run, words),
        "opinion": None if run is None or run.opinion is None else opinion_table(run.opinion, words),
        "origin": origin_facts(recording, run, words),
        "source": recording.source,
        "version": code_version(),
    }


def _make_record(recording: Recording, run: RunSummary | None, at: datetime | None) -> Record:
    """What is known where the report is made; a service puts in who answers for it."""
    return Record(
        at=at,
        cell=recording.cell,
        version=code_version(),
        plan_sha256=None if run is None else run.plan_digest,
        order=recording.order,
    )


def _charts(identification: Identification, words: Wording) -> dict[str, str | None]:
    series, estimate = identification.series, identification.estimate
    if series is None or series.measured is None or series.reconstructed is None or estimate is None:
        return {"wrench_chart": None, "rotation_chart": None}
    t = series.t
    rotating = [part for part in identification.segments if part.phase.startswith("rotate")]
    first_of_axis = {part.axis or "": part for part in reversed(rotating)}
    first = [first_of_axis[axis] for axis in sorted(first_of_axis)]
    turning = rotation_chart(t, series.motion, series.measured, series.reconstructed, first, words) if first else None
    wrench = wrench_chart(t, series.measured, series.reconstructed, estimate.noise_std, rotating, words)
    return {"wrench_chart": wrench, "rotation_chart": turning}


def _starts(run: RunSummary, words: Wording) -> list[dict[str, Any]]:
    robot = RobotModel.of_cell(run.cell)
    parts = arm_parts(run.cell, robot)
    return [
        {
            "scene": scene(run.cell, robot, run.payload_box, start, parts, words),
            "axis": start.axis.replace("-", "−"),
            "lines": start_lines(start, words),
        }
        for start in run.starts
    ]


def _distances(run: RunSummary, words: Wording) -> str | None:
    """None where there is nothing to keep away from."""
    if len(run.t) < 2 or not np.isfinite(run.distance_m).all():
        return None
    return distance_chart(run.t, run.distance_m, run.cell.limits.clearance_m, words)
