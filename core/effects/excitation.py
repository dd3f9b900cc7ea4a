"""What a run must contain for timing to show."""

from __future__ import annotations

import numpy as np

from core.effects.scene import Scene
from core.words.message import Message

STILL = 0.02
"""rad/s; slower than this, gravity and inertia change too little for milliseconds to show."""


def stillness(scene: Scene) -> Message | None:
    """Why timing does not show in a run, None where the sensor turns or is accelerated."""
    motion = scene.motion
    if np.abs(motion.omega).max() > STILL or np.abs(motion.a).max() > STILL * float(np.linalg.norm(scene.gravity)):
        return None
    return Message.of("effect-sensor-still", rate_rad_s=STILL)
