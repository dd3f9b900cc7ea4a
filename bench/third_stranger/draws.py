"""Draws that several causes have in common."""

from __future__ import annotations

import numpy as np

from bench.second_stranger.motions import Stretch
from bench.second_stranger.rig import Rig


def list_pauses(rig: Rig) -> list[float]:
    """Times, s, in the middle of each pause of the recorder; the middle of the recording where it makes none."""
    ends = [stretch.end_s for stretch in rig.stretches if stretch.label == "pause"]
    begins = [stretch.begin_s for stretch in rig.stretches if stretch.label == "pause"]
    firsts = [begin for begin in begins if begin not in ends]
    lasts = [end for end in ends if end not in begins]
    return [(begin + end) / 2 for begin, end in zip(firsts, lasts, strict=True)] or [rig.seconds / 2]


def draw_moment(rng: np.random.Generator, rig: Rig, low: float, high: float, doing: str) -> float:
    """A time, s, within a stretch whose label begins so and whose middle lies between shares of the recording."""
    fitting = [each for each in rig.stretches if each.label.startswith(doing) and low < _find_share(each, rig) < high]
    stretch = fitting[int(rng.integers(len(fitting)))]
    return float(stretch.begin_s + (stretch.end_s - stretch.begin_s) * rng.uniform(0.3, 0.6))


def _find_share(stretch: Stretch, rig: Rig) -> float:
    return (stretch.begin_s + stretch.end_s) / 2 / rig.seconds
