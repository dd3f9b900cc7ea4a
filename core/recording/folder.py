"""The recording as a folder: `recording.json`, `samples.parquet` (or `.csv`, `.csv.gz` on import) and the URDF.

Reading turns the wrench into the paper's sign; writing always states sign 1. What is written is complete or not there.
Rows are counted from 1, the first sample.
"""

from __future__ import annotations

import re
import shutil
import uuid
from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from core.array import Array
from core.cell.urdf import check_urdf
from core.cell.urdf_elements import MAX_BYTES as MAX_URDF_BYTES
from core.errors import BadInput, BadRecording
from core.files.jail import find_inside, read_inside
from core.payload.channels import CHANNELS
from core.payload.site import gravity_at
from core.recording.cut_text import cut_text
from core.recording.manifest import FILE as MANIFEST
from core.recording.manifest import RobotPart, manifest_of, read_manifest
from core.recording.order_reference import NO_ORDER
from core.recording.recording import Recording, RobotDescription
from core.recording.samples import FILES as SAMPLES
from core.recording.samples import MAX_BYTES, Samples, SamplesFile, SamplesWriter, name_column
from core.words.message import Message

QUATERNION = ("qx", "qy", "qz", "qw")
POSITION = ("px", "py", "pz")
IN_MEMORY = Message.of("recording-itself")
PHASE = re.compile(r"transfer|hold:[xyz][+-]|hold:free|rotate:[xyz]")


def read_recording(folder: Path) -> Recording:
    """Reads a recording folder.

    Args:
        folder: holds `recording.json`, one samples file and, for joints, the URDF.

    Returns:
        the recording, its wrench in the paper's sign whatever `sensor.sign` says.

    Raises:
        BadRecording: anything that `recording/1` does not allow; it names the file, the key, column and row.
        BadRobot: the URDF is malformed or hostile.
    """
    opened = RecordingFolder(folder)
    return opened.recording_of(opened.samples.read())


class RecordingFolder:
    """A recording's folder with all but its samples read.

    Raises:
        BadRecording, BadRobot: as for `read_recording`.
    """

    def __init__(self, folder: Path) -> None:
        folder = Path(folder)
        if not folder.is_dir():
            raise BadRecording(str(folder), "recording-no-folder")
        self._manifest = read_manifest(folder)
        self._reference = self._manifest.payload_reference
        self._robot = _read_robot(folder, self._manifest.robot) if self._manifest.robot else None
        self.samples = SamplesFile.of_folder(folder)

    def recording_of(self, samples: Samples) -> Recording:
        """What the folder says, with all of its samples or some.

        Raises:
            BadRecording: columns or values that the format does not allow.
        """
        manifest, robot, reference = self._manifest, self._robot, self._reference
        n = len(robot.joints) if robot else 0
        wrench = samples.numbers(*CHANNELS) * manifest.sensor.sign if samples.any_of(CHANNELS) else None
        q = _joint_columns(samples, "q", n, optional=robot is None)
        tau = _joint_columns(samples, "tau", n)
        if wrench is None and tau is None:
            raise BadRecording(samples.where, "recording-neither-wrench-nor-torques")
        return Recording(
            t=_read_time(samples),
            gravity=gravity_at(np.array(manifest.gravity), manifest.site),
            wrench=wrench,
            q=q,
            dq=_joint_columns(samples, "dq", n),
            q_cmd=_joint_columns(samples, "q_cmd", n),
            tau=tau,
            orientation=None if robot else _orientation(samples),
            position=samples.numbers(*POSITION) if robot is None and samples.any_of(POSITION) else None,
            temperature=samples.numbers("temperature")[:, 0] if "temperature" in samples else None,
            phase=_check_phase(samples),
            robot=robot,
            friction=manifest.robot.friction.description if manifest.robot and manifest.robot.friction else None,
            sensor=manifest.sensor.description,
            zero_std_rad=manifest.robot.zero_std_rad if manifest.robot else None,
            encoder_std_rad=manifest.robot.encoder_std_rad if manifest.robot else None,
            torque_gain_std=manifest.robot.torque_gain_std if manifest.robot else None,
            link_mass_std=manifest.robot.link_mass_std if manifest.robot else None,
            site=manifest.site,
            reference=reference.parameters if reference else None,
            reference_source=reference.source if reference else None,
            source=manifest.source,
            cell=manifest.cell,
            payload=manifest.payload,
            tools=tuple(tool.known for tool in manifest.tools or ()),
            order=manifest.order or NO_ORDER,
        )


def write_recording(recording: Recording, folder: Path, more: Iterable[Recording] = ()) -> None:
    """Writes a recording as a new folder; it appears under its name complete, or not at all.

    Args:
        more: the rows that follow, of the same columns and later in time; with them a recording need not be in memory as a whole.

    Raises:
        BadInput: the folder exists and is not empty; a recording is never overwritten.
        BadRecording: columns of different lengths, values that are not finite, or time that does not increase.
    """
    folder = Path(folder)
    if folder.exists() and not (folder.is_dir() and not any(folder.iterdir())):
        raise BadInput(str(folder), "recording-there-already")
    columns = columns_of(recording)
    manifest = manifest_of(recording).model_dump_json(indent=1, exclude_none=True)
    partial = folder.with_name(f".{folder.name}.{uuid.uuid4().hex[:8]}.partial")
    folder.parent.mkdir(parents=True, exist_ok=True)
    try:
        partial.mkdir()
        with SamplesWriter(partial / "samples.parquet") as samples:
            samples.write(columns)
            for each in more:
                samples.write(columns_of(each))
        if recording.robot:
            (partial / "robot.urdf").write_text(recording.robot.urdf, encoding="utf-8")
        (partial / MANIFEST).write_text(manifest + "\n", encoding="utf-8")
        try:
            partial.rename(folder)
        except OSError as error:
            raise BadInput(str(folder), "recording-folder-not-made", reason=str(error.strerror)) from error
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def recording_sha256(folder: Path) -> str:
    """SHA-256 of what a recording consists of: manifest, samples and URDF, whatever else lies beside them.

    Raises:
        BadRecording: no readable recording is there.
    """
    folder = Path(folder)
    if not folder.is_dir():
        raise BadRecording(str(folder), "recording-no-folder")
    manifest = read_manifest(folder)
    names = [MANIFEST, *(name for name in SAMPLES if (folder / name).exists()), *([manifest.robot.urdf] if manifest.robot else [])]
    digest = sha256()
    for name in names:
        digest.update(f"{name}\n".encode())
        digest.update(find_inside(folder, name, BadRecording, max_bytes=MAX_BYTES).read_bytes())
    return digest.hexdigest()


# reading


def _read_robot(folder: Path, robot: RobotPart) -> RobotDescription:
    where = f"{folder / MANIFEST}: robot.urdf"
    text = read_inside(folder, robot.urdf, BadRecording, max_bytes=MAX_URDF_BYTES, where=where)
    urdf = check_urdf(text, str(folder / robot.urdf))
    known = [joint.name for joint in urdf.joints]
    unknown = [name for name in robot.joints if name not in known]
    if unknown:
        raise BadRecording(f"{folder / MANIFEST}: robot.joints", "recording-unknown-joint", joint=cut_text(unknown[0]), joints=known)
    for key in ("base_frame", "sensor_frame"):
        if getattr(robot, key) not in urdf.links:
            where = f"{folder / MANIFEST}: robot.{key}"
            raise BadRecording(where, "recording-unknown-link", link=cut_text(getattr(robot, key)), links=list(urdf.links))
    chain = urdf.chain(robot.base_frame, robot.sensor_frame)
    if robot.joints != chain:
        raise BadRecording(f"{folder / MANIFEST}: robot.joints", "recording-other-chain", joints=robot.joints, chain=chain)
    return RobotDescription(text, chain, robot.base_frame, robot.sensor_frame)


def _names(prefix: str, n: int) -> list[str]:
    return [f"{prefix}_{j + 1}" for j in range(n)]


def _joint_columns(samples: Samples, prefix: str, n: int, *, optional: bool = True) -> Array | None:
    """Columns (N, n) of the n joints; all of them, or none where they are optional."""
    extra = f"{prefix}_{n + 1}"
    if n and extra in samples:
        where = name_column(samples.where, extra)
        raise BadRecording(where, "recording-more-columns-than-joints", first=f"{prefix}_1", last=f"{prefix}_{n}")
    names = _names(prefix, n)
    return None if optional and not samples.any_of(names) else samples.numbers(*names)


def _read_time(samples: Samples) -> Array:
    t = samples.numbers("t")[:, 0]
    _check_time(t, samples.where, samples.row(0))
    return t


def _check_time(t: Array, where: str | Message, first_row: int = 1) -> None:
    late = np.flatnonzero(np.diff(t) <= 0)
    if len(late):
        k = int(late[0]) + 1
        raise BadRecording(
            name_column(where, "t", first_row + k), "recording-time-not-increasing", time_s=float(t[k]), before_s=float(t[k - 1])
        )


def _orientation(samples: Samples) -> Array:
    """Rotation matrices (N, 3, 3) of the quaternions, normalised."""
    if not samples.any_of(QUATERNION):
        raise BadRecording(samples.where, "recording-joints-without-robot" if "q_1" in samples else "recording-neither-joints-nor-poses")
    from scipy.spatial.transform import Rotation  # noqa: PLC0415 - half of SciPy, for recordings of attitudes

    quaternions = samples.numbers(*QUATERNION)
    norms = np.linalg.norm(quaternions, axis=1)
    wrong = np.flatnonzero(np.abs(norms - 1.0) > 0.01)
    if len(wrong):
        k = int(wrong[0])
        where = name_column(samples.where, " ".join(QUATERNION), samples.row(k))
        raise BadRecording(where, "recording-no-unit-quaternion", norm=float(norms[k]))
    return np.asarray(Rotation.from_quat(quaternions).as_matrix())


def _check_phase(samples: Samples) -> NDArray[np.str_] | None:
    if "phase" not in samples:
        return None
    phase = samples.texts("phase")
    for label in np.unique(phase):
        if not PHASE.fullmatch(str(label)):
            where = name_column(samples.where, "phase", samples.row(int(np.flatnonzero(phase == label)[0])))
            raise BadRecording(where, "recording-unknown-phase", phase=cut_text(label, 60))
    return phase


# writing


def columns_of(recording: Recording) -> dict[str, Array | NDArray[np.str_]]:
    """Columns of the samples, checked.

    Raises:
        BadRecording: columns of different lengths, values that are not finite, or time that does not increase.
    """
    columns: dict[str, Array | NDArray[np.str_]] = {"t": np.asarray(recording.t, dtype=float)}
    for prefix in ("q", "dq", "q_cmd", "tau"):
        values = getattr(recording, prefix)
        if values is not None:
            columns |= dict(zip(_names(prefix, values.shape[1]), np.asarray(values, dtype=float).T, strict=True))
    if recording.orientation is not None:
        from scipy.spatial.transform import Rotation  # noqa: PLC0415 - as above

        columns |= dict(zip(QUATERNION, Rotation.from_matrix(recording.orientation).as_quat().T, strict=True))
    if recording.position is not None:
        columns |= dict(zip(POSITION, recording.position.T, strict=True))
    if recording.wrench is not None:
        columns |= dict(zip(CHANNELS, recording.wrench.T, strict=True))
    if recording.temperature is not None:
        columns["temperature"] = recording.temperature
    for name, values in columns.items():
        if len(values) != len(recording.t):
            raise BadRecording(name_column(IN_MEMORY, name), "recording-other-length", count=len(values), times=len(recording.t))
        bad = np.flatnonzero(~np.isfinite(values))
        if len(bad):
            raise BadRecording(name_column(IN_MEMORY, name, int(bad[0]) + 1), "recording-not-finite", value=str(values[bad[0]]))
    _check_time(recording.t, IN_MEMORY)
    if recording.phase is not None:
        columns["phase"] = np.asarray(recording.phase, dtype=np.str_)
    return columns
