"""What a person at a terminal may ask of a plan, for every command that makes one."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

import typer

from core.errors import BadInput
from core.planning.settings import MAX_EFFORT, Scope
from core.planning.stops import Stops
from core.requirement.target import Target

FromOption = Annotated[
    str | None,
    typer.Option(
        "--from",
        metavar="WHERE",
        help='Where the robot stands: "q1,q2,..." in rad, a recording (its end), or a JSON file with "q_rad". [default: home]',
    ),
]
AxesOption = Annotated[
    str, typer.Option(metavar="AXES", help="Sensor axes to hold along gravity and to turn about, where not all have room: x,y for example.")
]
HoldsOnlyOption = Annotated[
    bool,
    typer.Option(
        "--holds-only",
        help="No rotations: for mass and centre of mass, in less room and time; the inertia only as far as transfers show it.",
    ),
]
SpeedOption = Annotated[
    float | None,
    typer.Option(
        metavar="M_S", help="No point moves faster than this, m/s: 0.1 for a slow first run. [default: the cell's limit, the most]"
    ),
]
EffortOption = Annotated[
    int,
    typer.Option(
        min=1, max=MAX_EFFORT, help="So many times the candidates and iterations before a plan is refused; what less finds stays."
    ),
]


class Purpose(StrEnum):
    """What a payload is to be identified from."""

    wrist_sensor = "wrist-sensor"
    joint_torques = "joint-torques"


PurposeOption = Annotated[
    Purpose,
    typer.Option(
        "--for",
        help="What the payload is to be identified from: the wrist sensor, or the torques of the joints, which the same motions without it "
        "are compared with.",
    ),
]


def scope_of(axes: str, *, holds_only: bool) -> Scope:
    """What of the procedure is asked for.

    Args:
        axes: letters, with commas or spaces between them or not, in any order.

    Raises:
        BadInput: no axes, or one that there is not.
    """
    letters = axes.replace(",", "").replace(" ", "").lower()
    if not letters or set(letters) - set("xyz"):
        raise BadInput("--axes", "planning-axes-unknown", axes=axes)
    return Scope(axes="".join(axis for axis in "xyz" if axis in letters), rotations=not holds_only)


def stops_for(purpose: Purpose, scope: Scope, target: Target | None = None) -> Stops:
    """What the robot is to go through.

    Raises:
        BadInput: for the joints' torques it does not turn about sensor axes, and ends when it has come through.
    """
    if purpose == Purpose.wrist_sensor:
        return Stops.of_procedure(scope, target=target)
    if not scope.rotations or target is not None:
        raise BadInput("--for", "planning-torques-whole", option="--target" if target is not None else "--holds-only")
    return Stops.of_joint_torques(scope.axes)
