"""`heft import`: a log of another program as a recording."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from core.cli.log_argument import LogKnowledge, MapOption, SetOption, UrdfOption
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput, BadRecording
from core.estimation.setup.clock_offset import estimate_clock_offset
from core.estimation.setup.log_choice import ImportedLog, read_log
from core.files.jail import read_inside
from core.recording.folder import write_recording
from core.recording.logs.conversion import MAX_URDF_BYTES, Conversion
from core.recording.logs.mapping import LogPart, Mapping, WrenchPart, write_mapping
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import Log, open_log
from core.words.wording import Wording

app = typer.Typer()

MOST_QUESTIONS = 8
MAPPING = "map.toml"
FRAME = "joints.sensor_frame"
WAYS = {
    "quaternion": "import-quaternion",
    "matrix": "import-matrix",
    "rotation_vector": "import-rotation-vector",
    "roll_pitch_yaw": "import-roll-pitch-yaw",
}


@app.command("import")
def import_command(
    logs: Annotated[
        list[Path],
        typer.Argument(
            metavar="LOG...", help="CSV (also .csv.gz), Parquet, MCAP, a bag of ROS 1 or 2; several belong together. Or a folder."
        ),
    ],
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder to make for the recording.")],
    mapping: MapOption = None,
    urdf: UrdfOption = None,
    changes: SetOption = None,
) -> None:
    """Make a recording of another program's log: show what its columns are taken for, and check that they agree with each other."""
    if out.exists() and not (out.is_dir() and not any(out.iterdir())):
        raise BadInput(str(out), "recording-there-already")
    make_recording(logs, out, LogKnowledge(mapping, urdf, tuple(changes or ())), answers)
    words = find_wording()
    answers.print(words.say("import-written", folder=str(out)), highlight=False, soft_wrap=True)


def make_recording(logs: Sequence[Path], out: Path, known: LogKnowledge, console: Console) -> None:
    """A recording in the folder `out`, its mapping beside it; what the log was taken for is told on a console.

    Raises:
        OpenQuestion: something has to be asked, and nobody sits at a terminal.
        BadInput, BadRecording: the log cannot be used, and why; nothing is written.
    """
    log = open_log(logs)
    if known.urdf is not None:
        log.urdf = read_inside(known.urdf.parent, known.urdf.name, BadInput, max_bytes=MAX_URDF_BYTES)
    elif known.cell is not None:
        log.urdf = known.cell.urdf
    known = known._replace(mapping=known.mapping or _find_mapping(logs))
    made = _import_with_answers(log, known)
    words = find_wording()
    console.print(_tabulate(made, words))
    if made.check.contradiction is not None:
        raise BadRecording(str(known.mapping or log.where), "import-contradiction", contradiction=made.check.contradiction)
    write_recording(made.beginning, out, made.conversion.blocks(len(made.beginning)))
    (out / MAPPING).write_text(write_mapping(made.mapping), encoding="utf-8")
    for remark in made.check.remarks:
        console.print(words.say("result-warning", warning=words.quote(remark)), highlight=False)


def _find_mapping(logs: Sequence[Path]) -> Path | None:
    """The mapping that lies in a folder of logs."""
    inside = logs[0] / MAPPING
    return inside if len(logs) == 1 and inside.is_file() else None


def _import_with_answers(log: Log, known: LogKnowledge) -> ImportedLog:
    """The log, with what the cell knows and a person answers on a terminal; in a pipe a question is an error that names the option."""
    given = _read_changes(known.changes)
    for _ in range(MOST_QUESTIONS):
        try:
            return read_log(log, known.mapping, given)
        except OpenQuestion as question:
            if question.key == FRAME and known.cell is not None and known.urdf is None:
                robot = known.cell.robot
                given |= {"joints.base_frame": robot.base_frame, FRAME: robot.sensor_frame}
            elif _can_ask():
                given[question.key] = _ask(question)
            else:
                raise
    raise BadInput(log.where, "import-too-many-questions")


def _can_ask() -> bool:
    return sys.stdin.isatty() and messages.is_terminal


def _ask(question: OpenQuestion) -> str:
    words = find_wording()
    messages.print(words.quote(question.reason), highlight=False, markup=False)
    for k, choice in enumerate(question.choices, start=1):
        messages.print(f"  {k}  {choice}", highlight=False, markup=False)
    possible = {str(k): choice for k, choice in enumerate(question.choices, start=1)}
    while True:
        given = str(typer.prompt(f"{question.key} [1-{len(possible)}]", err=True)).strip()
        if given in possible:
            return possible[given]


def _read_changes(changes: Sequence[str]) -> dict[str, str]:
    for change in changes:
        if "=" not in change:
            raise BadInput(f"--set {change}", "import-no-equals")
    return {key.strip(): value.strip() for key, _, value in (change.partition("=") for change in changes)}


def _tabulate(made: ImportedLog, words: Wording) -> Table:
    """What the log was taken for."""
    mapping, conversion = made.mapping, made.conversion
    table = Table(title=words.say("import-title"), show_header=False)
    rows = (
        *_describe_rows(conversion, words),
        *(() if mapping.wrench is None else _describe_wrench(mapping.wrench, words)),
        *_describe_motion(mapping, words),
        *_describe_clocks(made, words),
        *_describe_payload(made, words),
    )
    for name, said in rows:
        table.add_row(name, escape(said))
    return table


def _describe_rows(conversion: Conversion, words: Wording) -> Iterator[tuple[str, str]]:
    t = conversion.t
    rate_hz, lasts_s = 1.0 / float(np.median(np.diff(t))), float(t[-1])
    code = "import-poses-kept" if conversion.mapping.rows.time is None else "import-rows-kept"
    yield words.say("import-rows"), words.say(code, kept=len(t), read=conversion.read, rate_hz=rate_hz, lasts_s=lasts_s)
    if conversion.repeated or conversion.outside:
        yield "", words.say("import-rows-left-out", repeated=conversion.repeated, outside=conversion.outside)


def _describe_wrench(wrench: WrenchPart, words: Wording) -> Iterator[tuple[str, str]]:
    sign = words.say("import-sign-on-payload" if wrench.sign == 1 else "import-sign-on-sensor")
    axes = words.say("import-axes-sensor" if wrench.axes == "sensor" else "import-axes-base")
    yield words.say("import-force"), f"{_name(wrench.force)} [{wrench.force_unit}]"
    yield words.say("import-torque"), f"{_name(wrench.torque)} [{wrench.torque_unit}]"
    yield words.say("import-meaning"), f"{sign}; {axes}"
    if wrench.is_compensated:
        yield "", words.say("import-compensated")
    if wrench.time is not None:
        yield words.say("import-time"), _clock(wrench)


def _describe_motion(mapping: Mapping, words: Wording) -> Iterator[tuple[str, str]]:
    joints, pose = mapping.joints, mapping.pose
    if joints is not None:
        yield words.say("import-joints"), f"{_name(joints.position)} [{joints.angle_unit}]; {_clock(joints)}"
        if joints.torque is not None:
            yield words.say("import-joint-torques"), f"{_name(joints.torque)} [N m]"
        yield words.say("import-frames"), f"{joints.base_frame} → {joints.sensor_frame}"
    elif pose is not None:
        (way,) = pose.rotations
        kind = words.say(WAYS[way])
        clock = "" if pose.time is None else f"; {_clock(pose)}"
        yield words.say("import-attitude"), f"{kind}: {_name(getattr(pose, way))}{clock}"
        at = words.say("import-no-position") if pose.position is None else f"{_name(pose.position)} [{pose.position_unit}]"
        yield words.say("import-position"), at


def _describe_clocks(made: ImportedLog, words: Wording) -> Iterator[tuple[str, str]]:
    if made.conversion.moved_hz is None:
        return
    yield words.say("import-clocks"), words.say("import-resampled", rate_hz=made.conversion.moved_hz)
    offset = None if made.check.contradiction is not None else estimate_clock_offset(made.beginning)
    if offset is None:
        yield "", words.say("import-offset-unknown")
    else:
        yield "", words.say("import-offset", late_s=offset.late_s, std_s=offset.std_s)


def _describe_payload(made: ImportedLog, words: Wording) -> Iterator[tuple[str, str]]:
    weighed = made.check.weighed
    if weighed is not None and weighed.upright:
        yield words.say("import-weighs"), words.say("import-mass", mass_kg=weighed.mass, std_kg=weighed.mass_std)


def _name(columns: tuple[str, ...]) -> str:
    return " ".join(columns) if len(columns) <= 4 else f"{columns[0]} … {columns[-1]}"


def _clock(part: LogPart) -> str:
    file = "" if part.file is None else f"{part.file}: "
    shift = "" if part.begins_s == 0.0 else f" + {part.begins_s:.3f} s"
    return f"{file}{part.time} [{part.time_unit}]{shift}"
