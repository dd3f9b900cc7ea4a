"""The sides on which something can be seen beside the wrench that the twin predicts; known without the engine."""

from __future__ import annotations

from typing import Literal

Side = Literal["joints", "reading", "reference"]
