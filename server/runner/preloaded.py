"""What the server that processes are forked from has ready for all of them: the engine is imported, what is compiled is loaded."""

from __future__ import annotations

import server.runner.control  # noqa: F401 - imported for those that are forked
from core.robot.compiled import load_kinematics

load_kinematics()
