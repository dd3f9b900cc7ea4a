"""`heft export-recording`: a recording as other programs open it."""

from __future__ import annotations

import uuid
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import pyarrow as pa
import pyarrow.csv as pa_csv
import typer

from core.cli.options import check_new
from core.cli.terminal import answers, find_wording
from core.errors import BadInput
from core.recording.bags.mcap_export import write_mcap
from core.recording.folder import columns_of, read_recording
from core.recording.recording import Recording
from core.robot.model import RobotModel

app = typer.Typer()


class Format(StrEnum):
    """What can be written."""

    MCAP = "mcap"
    CSV = "csv"


@app.command("export-recording")
def export_recording_command(
    recording: Annotated[Path, typer.Argument(metavar="RECORDING", help="Folder of a recording.")],
    kind: Annotated[Format, typer.Option("--format", help="mcap: ROS 2 messages. csv: the columns of the recording.")] = Format.MCAP,
    out: Annotated[Path | None, typer.Option(metavar="FILE", help="[default: the recording's name, here]")] = None,
) -> None:
    """Write a recording as PlotJuggler, Foxglove and `ros2 bag` open it: MCAP with messages of ROS 2, or CSV."""
    file = out or Path(f"{recording.resolve().name}.{kind}")
    check_new(file, str(file))
    loaded = read_recording(recording)
    partial = file.with_name(f".{file.name}.{uuid.uuid4().hex[:8]}.partial")
    try:
        _write(loaded, partial, kind)
        partial.replace(file)
    except OSError as error:
        raise BadInput(str(file), "import-not-written", reason=str(error.strerror)) from error
    finally:
        partial.unlink(missing_ok=True)
    answers.print(find_wording().say("import-exported", file=str(file), rows=len(loaded)), highlight=False, soft_wrap=True)


def _write(recording: Recording, file: Path, kind: Format) -> None:
    if kind == Format.CSV:
        pa_csv.write_csv(pa.table({name: pa.array(values) for name, values in columns_of(recording).items()}), file)
        return
    orientation, position = recording.orientation, recording.position
    if recording.robot is not None and recording.q is not None:
        poses = RobotModel(recording.robot).sensor_poses(recording.q)
        orientation, position = poses.rotation, poses.position
    write_mcap(recording, file, orientation, position)
