"""A cell made of a robot's description, step by step: what was sent, what the robot is made of, the cell as it would be, its import."""

from __future__ import annotations

import re
from collections.abc import AsyncIterator
from datetime import datetime
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Depends, Query, Request, Response
from fastapi.responses import FileResponse
from pydantic import Field

from core.errors import BadRobot
from core.new_cell.order import Behind, CellOrder
from core.new_cell.outline import RobotOutline
from core.new_cell.values import CellValues
from core.payload.shapes import Pose
from core.words.catalogue import Language
from server.cells.archive import UPLOAD
from server.cells.drafts import DESCRIPTIONS, LASTS, MADE, PICTURE, Draft, DraftsDep, list_descriptions, make_draft, pack_cell, read_robot
from server.cells.drafts import receive_robot as unpack_draft
from server.cells.folder import CellsDep
from server.cells.routes import CellVersion
from server.cells.uploads import CheckerDep, import_cell, upload_folder
from server.http.dependencies import MetricsDep, NowDep, StoreDep
from server.http.errors import Conflict
from server.http.parameters import DraftPath
from server.http.schemas import Answer, Name, RequestBody
from server.http.zip_body import FILE_OR_ZIP, check_is_upload, write_body
from server.http.zip_file import UPLOADED
from server.people.auth import CallerDep
from server.runner.draft_schemas import DraftCellPublic

router = APIRouter(prefix="/api/drafts", tags=["cells"])

FILE_NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,63}", re.ASCII)


class ArgumentPublic(Answer):
    """An argument that a xacro file declares."""

    name: str = Field(description="Its name.", examples=["ur_type"])
    default: str = Field(description="What it is where nobody says; empty where there is no default.", examples=["ur5e"])


class DescriptionPublic(Answer):
    """A file that may describe a robot."""

    file: str = Field(description="Its path in what was sent.", examples=["robot/arm_description/urdf/arm.urdf.xacro"])
    arguments: list[ArgumentPublic] = Field(description="What a xacro file lets one choose.")


class DraftPublic(Answer):
    """A cell that is being made; it is gone when it is imported or deleted, or when nobody has asked for it for some time."""

    draft: str = Field(description="Identifier of the draft.", examples=["9f86d081884c7d659a2feaa0"])
    descriptions: list[DescriptionPublic] = Field(description="Files that may describe the robot, the likeliest first.")
    expires_at: datetime = Field(description="When it is gone unless somebody asks for it.", examples=["2026-03-01T10:00:00Z"])


class DraftRobotCreate(RequestBody):
    """Which file describes the robot."""

    file: str = Field(max_length=1000, description="One of the draft's descriptions.", examples=["robot/arm.urdf"])
    arguments: dict[str, Annotated[str, Field(max_length=200)]] = Field(
        default_factory=dict, description="Arguments of a xacro file, by name.", examples=[{"ur_type": "ur5e"}]
    )


class DraftCellUpdate(RequestBody):
    """What is known of the cell; whatever is absent is taken, and told."""

    name: Name = Field(description="Name of the cell.", examples=["line3"])
    base_frame: str = Field(max_length=200, description="Link that the arm begins with.", examples=["base"])
    sensor_frame: str | None = Field(
        default=None, max_length=200, description="Link in whose frame the sensor measures; null where `mount` says.", examples=["flange"]
    )
    mount: str | None = Field(
        default=None, max_length=200, description="Link that the sensor is fixed to, as a new link `ft_sensor`.", examples=["flange"]
    )
    mount_pose: Pose = Field(default=Pose(), description="The sensor frame in `mount`.")
    behind: Behind | None = Field(
        default=None, description="What the links behind the sensor frame are: carried by it (tool), or in front of it (robot)."
    )
    values: CellValues = Field(default=CellValues(), description="What is known better than the description has it.")


class DraftImportCreate(RequestBody):
    """The cell that is to be imported."""

    name: Name = Field(description="Name with which it was made.", examples=["line3"])


async def _receive_robot(
    request: Request,
    drafts: DraftsDep,
    now: NowDep,
    name: Annotated[
        str | None, Query(max_length=64, description="Name of a single file, where no zip is sent.", examples=["arm.urdf"])
    ] = None,
) -> AsyncIterator[tuple[Draft, str | None]]:
    """A new draft with the request's body in it."""
    is_file = check_is_upload(request, "robot")
    if is_file and (name is None or not FILE_NAME.fullmatch(name) or Path(name).suffix not in DESCRIPTIONS):
        raise BadRobot(UPLOADED, "drafts-no-description", kinds=DESCRIPTIONS)
    with drafts.begin(now) as draft:
        await write_body(request, draft.folder / UPLOAD)
        yield draft, name if is_file else None


@router.post("", status_code=201, openapi_extra=FILE_OR_ZIP)
def create_draft(received: Annotated[tuple[Draft, str | None], Depends(_receive_robot)], now: NowDep, response: Response) -> DraftPublic:
    """Begins a cell with a robot's description: a zip of it with its meshes, or one URDF or xacro file."""
    draft, name = received
    unpack_draft(draft, name)
    found = _answer(draft, now)
    if not found.descriptions:
        raise BadRobot(UPLOADED, "drafts-no-description", kinds=DESCRIPTIONS)
    response.headers["Location"] = f"/api/drafts/{draft.id}"
    return found


@router.get("/{draft}")
def read_draft(draft: DraftPath, drafts: DraftsDep, now: NowDep) -> DraftPublic:
    """What was sent."""
    return _answer(drafts.find(draft, now), now)


@router.delete("/{draft}", status_code=204)
def delete_draft(draft: DraftPath, drafts: DraftsDep, now: NowDep) -> None:
    """Leaves it; nothing of it stays."""
    drafts.remove(drafts.find(draft, now))


@router.post("/{draft}/robot")
def read_draft_robot(draft: DraftPath, body: DraftRobotCreate, drafts: DraftsDep, now: NowDep) -> RobotOutline:
    """Reads one of the descriptions: the links and joints that there are to choose from."""
    return RobotOutline.model_validate(read_robot(drafts.find(draft, now), body.file, body.arguments))


@router.put("/{draft}/cell")
def make_draft_cell(
    draft: DraftPath,
    body: DraftCellUpdate,
    drafts: DraftsDep,
    now: NowDep,
    language: Annotated[Language, Query(description="Language of the picture.")] = "en",
) -> DraftCellPublic:
    """Makes the cell anew, with what is wrong and doubtful in it; nothing is imported."""
    found = drafts.find(draft, now)
    if found.description is None:
        raise Conflict("drafts-not-read", draft=draft)
    order = CellOrder(
        name=body.name,
        urdf=Path(found.description),
        into=Path(MADE),
        package_paths=tuple(map(Path, found.packages)),
        base_frame=body.base_frame,
        sensor_frame=body.sensor_frame,
        mount=body.mount,
        mount_xyz=body.mount_pose.xyz_m,
        mount_rpy=body.mount_pose.rpy_rad,
        behind=body.behind,
        values=body.values,
    )
    return DraftCellPublic.model_validate(make_draft(found, order, language))


@router.get("/{draft}/picture", response_class=FileResponse, responses={200: {"content": {"image/png": {}}}})
def read_draft_picture(draft: DraftPath, drafts: DraftsDep, now: NowDep) -> FileResponse:
    """The robot at the home of the cell that was made last, also where that was refused for this home."""
    file = drafts.find(draft, now).folder / PICTURE
    if not file.is_file():
        raise Conflict("drafts-no-picture", draft=draft)
    return FileResponse(file, media_type="image/png")


@router.post("/{draft}/import", status_code=201)
def import_draft(
    draft: DraftPath,
    body: DraftImportCreate,
    drafts: DraftsDep,
    store: StoreDep,
    cells: CellsDep,
    metrics: MetricsDep,
    checker: CheckerDep,
    caller: CallerDep,
    now: NowDep,
    response: Response,
) -> CellVersion:
    """Takes the cell in that was made last, checked as an upload is; the draft is gone then."""
    found = drafts.find(draft, now)
    with upload_folder(cells) as folder:
        pack_cell(found, body.name, folder / UPLOAD)
        name, sha256 = import_cell(store, cells, metrics, checker, folder, None, caller.who, now)
    drafts.remove(found)
    response.headers["Location"] = f"/api/cells/{name}"
    return CellVersion(name=name, sha256=sha256)


def _answer(draft: Draft, now: datetime) -> DraftPublic:
    return DraftPublic(
        draft=draft.id,
        descriptions=[
            DescriptionPublic(file=file, arguments=[ArgumentPublic(name=name, default=default) for name, default in arguments])
            for file, arguments in list_descriptions(draft).items()
        ],
        expires_at=now + LASTS,
    )
