"""`recording.json`: what was recorded, beside the samples."""

from __future__ import annotations

import difflib
import json
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from core.errors import BadRecording
from core.files.jail import read_inside
from core.files.schema_flaw import schema_flaw
from core.payload.calibration import NOT_STATED, SensorCalibration
from core.payload.inertia import InertialParameters, pseudo_inertia
from core.payload.known_tool import KnownTool
from core.payload.site import Site, gravity_at
from core.recording.cut_text import cut_text
from core.recording.order_reference import OrderReference
from core.recording.recording import FrictionDescription, Recording, SensorDescription
from core.version import release_version

FORMAT: Literal["recording/1"] = "recording/1"
FILE = "recording.json"
MAX_BYTES = 1_000_000

Number = Annotated[float, Field(strict=True)]
Positive = Annotated[float, Field(strict=True, gt=0)]
NotNegative = Annotated[float, Field(strict=True, ge=0)]
Vector3 = tuple[Number, Number, Number]
Six = tuple[Number, Number, Number, Number, Number, Number]
SixPositive = tuple[Positive, Positive, Positive, Positive, Positive, Positive]


class ManifestPart(BaseModel):
    """Keys that the format does not know are left alone, unless they look like a misspelt one that is absent."""

    model_config = ConfigDict(frozen=True, extra="ignore", allow_inf_nan=False)


class FrictionPart(ManifestPart):
    """Friction that the joints are known to have, one value for each."""

    coulomb_n_m: tuple[NotNegative, ...]
    viscous_n_m_s: tuple[NotNegative, ...]

    @property
    def description(self) -> FrictionDescription:
        """The same as arrays."""
        return FrictionDescription(np.array(self.coulomb_n_m), np.array(self.viscous_n_m_s))


class RobotPart(ManifestPart):
    """Nominal kinematics; `urdf` is a path inside the folder."""

    urdf: str
    joints: Annotated[tuple[str, ...], Field(min_length=1, max_length=32)]
    base_frame: str
    sensor_frame: str
    friction: FrictionPart | None = None
    zero_std_rad: NotNegative | None = None
    encoder_std_rad: NotNegative | None = None
    torque_gain_std: NotNegative | None = None
    link_mass_std: NotNegative | None = None


class SensorPart(ManifestPart):
    """The wrist sensor; sign -1 where it states what the payload exerts on it."""

    name: Annotated[str, Field(max_length=200)] | None = None
    sign: Literal[1, -1] = 1
    noise_std: SixPositive | None = None
    range: SixPositive | None = None
    resolution: SixPositive | None = None
    calibration: SensorCalibration | None = None
    mount_std_rad: NotNegative | None = None

    @property
    def description(self) -> SensorDescription:
        """The same as arrays."""
        given = {key: getattr(self, key) for key in ("noise_std", "range", "resolution")}
        arrays = {key: np.array(value) for key, value in given.items() if value is not None}
        return SensorDescription(**arrays, calibration=self.calibration or NOT_STATED, mount_std_rad=self.mount_std_rad, name=self.name)


class PayloadReferencePart(ManifestPart):
    """The payload as somebody else knows it, without the tools; inertia about the sensor origin, Ixx Ixy Ixz Iyy Iyz Izz."""

    mass: Positive
    first_moment: Vector3
    inertia: Six
    source: str | None = None

    @property
    def parameters(self) -> InertialParameters:
        """The same as parameters."""
        return InertialParameters(np.array([self.mass, *self.first_moment, *self.inertia]))


class KnownToolPart(ManifestPart):
    """A known body between sensor and payload; inertia about the sensor origin, Ixx Ixy Ixz Iyy Iyz Izz; `std` where stated."""

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9_-]{1,64}$")]
    title: Annotated[str, Field(min_length=1, max_length=200)]
    mass: Positive
    first_moment: Vector3
    inertia: Six
    mass_std: NotNegative | None = None
    first_moment_std: tuple[NotNegative, NotNegative, NotNegative] | None = None
    inertia_std: tuple[NotNegative, NotNegative, NotNegative, NotNegative, NotNegative, NotNegative] | None = None

    @property
    def known(self) -> KnownTool:
        """The same as arrays."""
        mass_std = np.nan if self.mass_std is None else self.mass_std
        std = [mass_std, *(self.first_moment_std or [np.nan] * 3), *(self.inertia_std or [np.nan] * 6)]
        parameters = InertialParameters(np.array([self.mass, *self.first_moment, *self.inertia]))
        return KnownTool(self.name, self.title, parameters, np.array(std))


class Manifest(ManifestPart):
    """The whole file; `cell`, `payload`, `order` and `software` are written by our own runs."""

    format: Literal["recording/1"] = FORMAT
    gravity: Vector3
    site: Site | None = None
    robot: RobotPart | None = None
    sensor: SensorPart = SensorPart()
    payload_reference: PayloadReferencePart | None = None
    tools: Annotated[tuple[KnownToolPart, ...], Field(max_length=32)] | None = None
    source: str | None = None
    cell: str | None = None
    payload: str | None = None
    order: OrderReference | None = None
    software: str | None = None


PARTS: dict[str, type[BaseModel]] = {
    "robot": RobotPart, "sensor": SensorPart, "site": Site, "payload_reference": PayloadReferencePart, "order": OrderReference,
}  # fmt: skip


def read_manifest(folder: Path) -> Manifest:
    """Reads and validates `recording.json`.

    Raises:
        BadRecording: it is missing, too large, no JSON in UTF-8, or a key is missing or has an impossible value.
    """
    where = str(folder / FILE)
    content = _json_object(read_inside(folder, FILE, BadRecording, max_bytes=MAX_BYTES), where)
    if "format" not in content:
        raise BadRecording(f"{where}: format", "recording-no-format", known=FORMAT)
    if content["format"] != FORMAT:
        raise BadRecording(f"{where}: format", "recording-unknown-format", format=cut_text(content["format"]), known=FORMAT)
    _refuse_misspelt(content, Manifest, where)
    for key, part in PARTS.items():
        if isinstance(content.get(key), dict):
            _refuse_misspelt(content[key], part, f"{where}: {key}")
    for tool in content["tools"] if isinstance(content.get("tools"), list) else []:
        if isinstance(tool, dict):
            _refuse_misspelt(tool, KnownToolPart, f"{where}: tools")
    if isinstance(content.get("robot"), dict) and isinstance(friction := content["robot"].get("friction"), dict):
        _refuse_misspelt(friction, FrictionPart, f"{where}: robot.friction")
    try:
        manifest = Manifest.model_validate(content)
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadRecording, where) from error
    strength = float(np.linalg.norm(gravity_at(np.array(manifest.gravity), manifest.site))) if any(manifest.gravity) else 0.0
    if not 9.0 < strength < 10.5:
        raise BadRecording(f"{where}: gravity", "recording-gravity-not-of-the-earth", gravity_m_s2=manifest.gravity)
    if manifest.robot and manifest.robot.friction:
        _check_friction(manifest.robot.friction, len(manifest.robot.joints), f"{where}: robot.friction")
    if manifest.payload_reference:
        _check_reference(manifest.payload_reference.parameters, f"{where}: payload_reference")
    for tool in manifest.tools or ():
        _check_reference(tool.known.parameters, f"{where}: tools: {tool.name}")
    return manifest


def manifest_of(recording: Recording) -> Manifest:
    """The manifest of a recording in memory; its wrench has the paper's sign."""
    robot, reference, sensor, friction = recording.robot, recording.reference, recording.sensor, recording.friction
    content: dict[str, Any] = {
        "gravity": recording.gravity.tolist(),
        "site": recording.site,
        "robot": robot
        and {
            "urdf": "robot.urdf",
            "joints": robot.joints,
            "base_frame": robot.base_frame,
            "sensor_frame": robot.sensor_frame,
            "zero_std_rad": recording.zero_std_rad,
            "encoder_std_rad": recording.encoder_std_rad,
            "torque_gain_std": recording.torque_gain_std,
            "link_mass_std": recording.link_mass_std,
            "friction": friction and {"coulomb_n_m": tuple(friction.coulomb.tolist()), "viscous_n_m_s": tuple(friction.viscous.tolist())},
        },
        "sensor": {
            key: None if getattr(sensor, key) is None else tuple(getattr(sensor, key).tolist())
            for key in ("noise_std", "range", "resolution")
        }
        | {
            "calibration": None if sensor.calibration == NOT_STATED else sensor.calibration,
            "mount_std_rad": sensor.mount_std_rad,
            "name": sensor.name,
        },
        "payload_reference": reference
        and {
            "mass": reference.mass,
            "first_moment": tuple(reference.first_moment.tolist()),
            "inertia": tuple(reference.phi[4:].tolist()),
            "source": recording.reference_source,
        },
        "tools": tuple(_tool_content(tool) for tool in recording.tools) or None,
        "source": recording.source,
        "cell": recording.cell,
        "payload": recording.payload,
        "order": recording.order or None,
        "software": f"heft {release_version()}",
    }
    try:
        return Manifest.model_validate(content)
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadRecording, "recording") from error


def _tool_content(tool: KnownTool) -> dict[str, Any]:
    phi, std = tool.parameters.phi.tolist(), tool.std.tolist()
    content = {"name": tool.name, "title": tool.title, "mass": phi[0], "first_moment": tuple(phi[1:4]), "inertia": tuple(phi[4:])}
    rows = {"mass_std": std[0], "first_moment_std": tuple(std[1:4]), "inertia_std": tuple(std[4:])}
    return content | {key: value for key, value in rows.items() if np.isfinite(value).all()}


def _json_object(text: str, where: str) -> dict[str, Any]:
    try:
        content = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise BadRecording(where, "recording-broken-json", reason=str(error)[:120]) from error
    if not isinstance(content, dict):
        raise BadRecording(where, "recording-no-json-object")
    return content


def _refuse_misspelt(content: dict[str, Any], part: type[BaseModel], where: str) -> None:
    absent = [name for name in part.model_fields if name not in content]
    for key in content:
        close = difflib.get_close_matches(key, absent, n=1, cutoff=0.75) if key not in part.model_fields else []
        if close:
            raise BadRecording(f"{where}: {key}", "recording-misspelt-key", meant=close[0])


def _check_friction(friction: FrictionPart, n: int, where: str) -> None:
    for key, values in friction:
        if len(values) != n:
            raise BadRecording(f"{where}.{key}", "recording-friction-of-other-joints", count=len(values), joints=n)


def _check_reference(reference: InertialParameters, where: str) -> None:
    """Consistent but for the rounding of a CAD value."""
    P = pseudo_inertia(reference.phi)
    scale = np.sqrt(np.maximum(np.diag(P), 1e-12))
    if np.linalg.eigvalsh(P / np.outer(scale, scale))[0] < -0.01:
        raise BadRecording(where, "recording-no-rigid-body", phi=reference.phi.tolist())
