"""What to measure next: motions that may tell two explanations apart, as stops. Which one does is predicted, not listed."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

import numpy as np
from pydantic import Field

from core.array import Array
from core.estimation.segments import Segment
from core.payload.shapes import Model
from core.planning.stop import AXES, Direction, Stop, Swings, Wave
from core.recording.recording import Recording
from core.words.message import Message

TILT_RAD = 0.6
"""Between an attitude and the ones from whose sides it is approached."""
SECOND_PAYLOAD = "second_payload"


class CandidateMotion(Model):
    """A candidate: its identifier, what it is, and its stops; no stops for what is no motion."""

    id: Annotated[str, Field(max_length=64)]
    sentence: Message
    stops: Annotated[tuple[Stop, ...], Field(max_length=12)]


def candidates(recording: Recording, segments: tuple[Segment, ...], g: Array) -> Iterator[CandidateMotion]:
    """Motions that may be worth their time after a recording.

    Args:
        segments: of the recording.
        g: (N, 3), gravity in the sensor frame.
    """
    first = next((part for part in segments if part.is_hold), None)
    down = _unit(g[0] if first is None else g[first.rows].mean(axis=0))
    for about in (0, 1, 2):
        yield _swings(about, (about + 1) % 3)
    yield CandidateMotion(id="tilted_holds", sentence=Message.of("experiment-tilted-holds"), stops=_diagonals())
    yield CandidateMotion(id="revisit", sentence=Message.of("experiment-revisit"), stops=(Stop(down=down),))
    yield CandidateMotion(id="both_sides", sentence=Message.of("experiment-both-sides"), stops=_both_sides(down))
    for name, low, high, seconds in (("slow", 0.3, 5.0, 10.0), ("fast", 5.0, 15.0, 20.0)):
        wave = Wave(lowest_hz=low, highest_hz=high, seconds=seconds)
        sentence = Message.of("experiment-wide-band", lowest_hz=low, highest_hz=high)
        yield CandidateMotion(id=f"wide_band_{name}", sentence=sentence, stops=(Stop(down=_diagonal(1, 1), wave=wave),))
    if recording.q is not None:
        q = recording.q[0 if first is None else first.stop - 1]
        elsewhere = Stop(down=down, away_from_rad=tuple(q.tolist()))
        yield CandidateMotion(id="other_posture", sentence=Message.of("experiment-other-posture"), stops=(elsewhere,))


def second_payload(best_sigma: float) -> CandidateMotion:
    """What is left where no motion tells two explanations apart: the best one reaches `best_sigma`."""
    return CandidateMotion(id=SECOND_PAYLOAD, sentence=Message.of("experiment-second-payload", best_sigma=best_sigma), stops=())


def _swings(about: int, vertical: int) -> CandidateMotion:
    """Rotation about a horizontal axis: gravity sweeps through the sensor."""
    axis, down = AXES[about], AXES[vertical]
    return CandidateMotion(
        id=f"swings_about_horizontal_{axis}",
        sentence=Message.of("experiment-swings", axis=axis, down=down),
        stops=(Stop(down=_unit(np.eye(3)[vertical]), swings=Swings(about=axis)),),
    )


def _diagonals() -> tuple[Stop, ...]:
    return tuple(Stop(down=_diagonal(x, y)) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1)))


def _diagonal(x: int, y: int) -> Direction:
    return _unit(np.array([x, y, 1.0]))


def _both_sides(down: Direction) -> tuple[Stop, ...]:
    """Tilted one way, upright, tilted the other way, upright."""
    across = np.cross(down, np.eye(3)[int(np.argmin(np.abs(down)))])
    sides = [_unit(np.cos(TILT_RAD) * np.array(down) + sign * np.sin(TILT_RAD) * across / np.linalg.norm(across)) for sign in (1, -1)]
    return tuple(Stop(down=direction) for direction in (sides[0], down, sides[1], down))


def _unit(x: Array) -> Direction:
    unit = x / np.linalg.norm(x)
    nearest = int(np.argmax(np.abs(unit)))
    if abs(unit[nearest]) > np.cos(np.radians(1.0)):  # an axis that is held along gravity is meant to be exactly there
        unit = np.sign(unit[nearest]) * np.eye(3)[nearest]
    return float(unit[0]), float(unit[1]), float(unit[2])
