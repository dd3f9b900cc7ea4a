"""How well a motion that was left out is predicted by all the rest, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.array import Array
from core.report.motions import name_motion
from core.words.wording import ENGLISH, Wording

HOLDS_UP_TO = 1.5
"""Times what is expected. Eight windows of six channels alone make a ratio uncertain by 0.1, so this is no chance."""


def verification_sentence(
    phase: str, rms: Sequence[float] | Array, expected: Sequence[float] | Array, ratio: float, words: Wording = ENGLISH
) -> str:
    """What was predicted, how far off it was, and whether the result holds on it.

    Args:
        phase: `rotate:x`.
        rms, expected: (6,), of measured minus predicted, as it is and as noise and the prediction's uncertainty make it; N and N m.
        ratio: of the two, over all channels.
    """
    kind, _, axis = phase.partition(":")
    motion = words.say("report-rotation-about", axis=axis) if kind == "rotate" else name_motion(phase, words)
    seen, likely = _say_sizes(rms, words), _say_sizes(expected, words)
    if ratio <= HOLDS_UP_TO:
        return words.say("report-unseen-holds", motion=motion, rms=seen, expected=likely, ratio=ratio)
    return words.say("report-unseen-fails", motion=motion, rms=seen, expected=likely, ratio=ratio)


def _say_sizes(wrench: Sequence[float] | Array, words: Wording) -> str:
    """Force and torque of (6,), rms over their axes."""
    force, torque = np.sqrt(np.mean(np.reshape(wrench, (2, 3)) ** 2, axis=1))
    return words.say("report-force-and-torque", force_n=float(force), torque_n_m=float(torque))
