"""What a person at a terminal may ask of a plan, for every command that makes one."""

from __future__ import annotations

from typing import Annotated

import typer

from core.errors import BadInput
from core.planning.settings import MAX_EFFORT, Scope

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


TargetOption = Annotated[
    str | None,
    typer.Option(
        metavar="TARGET",
        help="How exactly, half-widths of 95 % intervals: mass=0.1%,com=0.5mm,inertia=1%, or requirement for what the cell's controller "
        "requires. A run ends as soon as it is reached.",
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
