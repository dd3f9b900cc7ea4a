"""What goes through the pipe between the server and the process that controls the robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from core.cell.cell import Box, Cell, Payload
from core.errors import Lateness
from core.estimation.result import Result
from core.events import Event
from core.payload.shapes import StandingShape
from core.planning.settings import WHOLE, Planner, Scope, Timing
from core.planning.stop import Stop
from core.recording.order_reference import NO_ORDER, OrderReference
from core.requirement.target import Target
from core.sessions.leased import Renewal
from core.words.message import Message
from server.runner.live_schemas import LiveBatch
from server.runner.plan_schemas import RunPlan

Pace = Literal["real_time", "as_fast_as_possible"]
Evidence = Literal["wrist_sensor", "joint_torques"]


@dataclass(frozen=True)
class Continuation:
    """A motion whose samples are appended to the recording in a folder.

    Args:
        stops: of an experiment; None for the procedure.
        done: steps that are finished already and not made again, of a run that ended where the recording ends; None for something new, from
            home.
    """

    recording: Path
    stops: tuple[Stop, ...] | None
    done: int | None = None


@dataclass(frozen=True)
class Order:
    """Everything that a control process needs to know when it starts.

    Args:
        run: identifier.
        cell: with its zones where they are now.
        payload: its name.
        known: what is known of it: the simulated robot carries it, and the result is compared with it. None where it is its box alone: then
            the simulated robot carries `mass_guess_kg`, spread evenly over `payload_box`.
        payload_box: what certainly contains it, sensor frame.
        folder: of the run; exists. Samples go there as they come, the recording in the end.
        continues: what the run goes on with; None for a procedure from its beginning.
        scope: what of the procedure is wanted.
        effort: how much is searched before a plan is refused.
        start_rad: where the robot stands when a procedure begins; at home where None.
        reference: what the plant calls it.
        target: how exactly the payload is wanted to be known; None for the whole plan.
        identify_from: what the motions are to show the payload to.
        empty: whether the robot makes them without the payload.
        without: folder of such a recording, which the torques of this one are compared with; None for none.
    """

    run: str
    cell: Cell
    payload: str
    known: Payload | None
    payload_box: Box
    timing: Timing
    planner: Planner
    seed: int
    mass_guess_kg: float
    pace: Pace
    folder: Path
    continues: Continuation | None = None
    scope: Scope = WHOLE
    effort: int = 1
    start_rad: tuple[float, ...] | None = None
    reference: OrderReference = NO_ORDER
    target: Target | None = None
    identify_from: Evidence = "wrist_sensor"
    empty: bool = False
    without: Path | None = None


@dataclass(frozen=True)
class Release:
    """The operator lets the shown plan begin."""

    plan_sha256: str


@dataclass(frozen=True)
class Beat:
    """The service lives; `service` is the number of its process."""

    stamp_s: float
    service: int


@dataclass(frozen=True)
class PageLate:
    """The console's page answers no more, though its connection does; for so long."""

    late_s: float


@dataclass(frozen=True)
class Hold:
    """Pause; `lateness` where nobody asked for it."""

    lateness: Lateness | None = None


@dataclass(frozen=True)
class Resume:
    """Go on after a hold."""


@dataclass(frozen=True)
class End:
    """Stop for good, and why."""

    reason: Message


@dataclass(frozen=True)
class ZoneChanged:
    """A protected zone is this now (world frame); None: there is none of that name any more."""

    zone: str
    shape: StandingShape | None


ToChild = Renewal | Beat | PageLate | Release | Hold | Resume | End | ZoneChanged


@dataclass(frozen=True)
class Ready:
    """The plan that waits for its release."""

    plan: RunPlan


@dataclass(frozen=True)
class Happened:
    """An event of the procedure."""

    event: Event


@dataclass(frozen=True)
class Sampled:
    """Newest samples, for those who watch."""

    batch: LiveBatch


@dataclass(frozen=True)
class MotionEnded:
    """The robot is back home and stands; what follows is arithmetic."""


@dataclass(frozen=True)
class Paced:
    """How the control loop kept its time while the robot moved.

    Args:
        ticks: of the loop; `late` of them came more than `LATE_S` after their time, the latest by `latest_s`, half of them by `median_s`.
    """

    ticks: int
    late: int
    latest_s: float
    median_s: float


@dataclass(frozen=True)
class Done:
    """The run came through."""

    result: Result


@dataclass(frozen=True)
class Failed:
    """The run did not come through; the robot stands.

    Args:
        error: name of the error in `core.errors`.
        message: what it says.
        in_the_way: name of the obstacle, zone or link that was nearest, where planning knows it.
        lateness: what was late, where that was it.
    """

    error: str
    message: Message
    in_the_way: str | None = None
    lateness: Lateness | None = None


FromChild = Ready | Happened | Sampled | MotionEnded | Paced | Done | Failed


@dataclass(frozen=True)
class Advanced:
    """Work in the background has come so far.

    Args:
        done: share, 0 to 1.
        told: JSON of what may be known before the work is done; None where that is what it was.
    """

    done: float
    told: str | None = None


@dataclass(frozen=True)
class Answered:
    """Work in the background is done; its answer as JSON."""

    text: str


@dataclass(frozen=True)
class Recovered:
    """So many samples of a run without a recording were made into one."""

    samples: int


FromWork = Advanced | Answered | Recovered | Failed
