"""How well a motion that was left out is predicted by all the rest, in words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

HOLDS_UP_TO = 1.5
"""Times what is expected. Eight windows of six channels alone make a ratio uncertain by 0.1, so this is no chance."""


def verification_sentence(phase: str, rms: Sequence[float] | Array, expected: Sequence[float] | Array, ratio: float) -> str:
    """What was predicted, how far off it was, and whether the result holds on it.

    Args:
        phase: `rotate:x`.
        rms, expected: (6,), of measured minus predicted, as it is and as noise and the prediction's uncertainty make it; N and N m.
        ratio: of the two, over all channels.
    """
    motion = phase.replace("rotate:", "rotation about ")
    holds = "the result holds on it" if ratio <= HOLDS_UP_TO else "the result does not hold on it, something acts that the model leaves out"
    return (
        f"A {motion} that was left out is predicted to {_sizes(rms)} (rms), {ratio:.2f} times the {_sizes(expected)} "
        f"that noise and the prediction's own uncertainty make one expect: {holds}."
    )


def _sizes(wrench: Sequence[float] | Array) -> str:
    """Force and torque of (6,), rms over their axes."""
    force, torque = np.sqrt(np.mean(np.reshape(wrench, (2, 3)) ** 2, axis=1))
    return f"{force:.2g} N and {torque:.2g} N m"
