"""A cell that is being made of a robot's description, as it is answered: what was made of it, and what somebody has to look at."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from core.cell.cell import Cell
from core.words.message import Message
from server.http.schemas import Answer


class DraftJoint(Answer):
    """A joint of the arm with its limits, as stated, as the description has them, or as they were taken."""

    name: str = Field(description="Name of the joint.", examples=["joint_3"])
    lower_rad: float | None = Field(description="Lower limit of its position, rad.", examples=[-2.97])
    upper_rad: float | None = Field(description="Upper limit of its position, rad.", examples=[2.97])
    velocity_rad_s: float | None = Field(description="Its greatest speed, rad/s.", examples=[1.9])
    effort_n_m: float | None = Field(description="Its greatest torque, N m.", examples=[176.0])
    acceleration_rad_s2: float = Field(description="Its greatest acceleration, rad/s2.", examples=[10.0])


class DraftLink(Answer):
    """A link that a joint of the arm moves."""

    name: str = Field(description="Name of the link.", examples=["link_3"])
    mass_kg: float = Field(description="Its mass, kg.", examples=[2.7])


class DraftPair(Answer):
    """Two links that overlap wherever they were looked at, or that somebody has left out."""

    first: str = Field(description="Name of a link.", examples=["link_3"])
    second: str = Field(description="Name of the other.", examples=["link_1"])
    is_left_out: bool = Field(description="Whether no distance between them is watched.")
    why: Message = Field(description="What speaks for that, or that nothing does but somebody's word.")


class DraftFinding(Answer):
    """Something that is wrong or doubtful in the cell."""

    severity: Literal["wrong", "doubtful"] = Field(description="Wrong keeps the cell from being planned in; doubtful may be as it should.")
    message: Message = Field(description="Where it is, what is there, and what is right or usual.")


class DraftCellPublic(Answer):
    """The cell as it would be imported now."""

    cell: Cell = Field(description="The cell.")
    joints: list[DraftJoint] = Field(description="The arm's joints, from base to sensor.")
    links: list[DraftLink] = Field(description="The links that they move, in the same order.")
    pairs: list[DraftPair] = Field(description="Pairs of links that are left out or could be: `values.adjacent` says which are.")
    notes: list[Message] = Field(description="What was chosen, taken or left out, since the description does not say.")
    findings: list[DraftFinding] = Field(description="What is wrong or doubtful, what is wrong first.")
