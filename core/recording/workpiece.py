"""The workpiece alone: what was identified without the tools that are known to be bolted on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from core.cell.tool import STD
from core.payload.inertia import is_consistent
from core.payload.known_tool import KnownTool
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

_STATED_ROWS = dict(zip(STD, (slice(0, 1), slice(1, 4), slice(4, 10)), strict=True))


@dataclass(frozen=True)
class Workpiece(UncertainParameters):
    """The ten parameters without the tools, sensor frame, inertia about the sensor origin.

    Args:
        tools: what was taken off.
    """

    tools: tuple[KnownTool, ...]

    @property
    def consistent(self) -> bool:
        """Whether a rigid body can have these parameters; of what is not determined nothing is said."""
        return bool(np.isnan(self.phi).any()) or is_consistent(self.phi)

    @property
    def unstated(self) -> dict[str, tuple[str, ...]]:
        """The standard deviations that tools do not state, by the names of these tools."""
        missing = {tool.name: tuple(key for key, rows in _STATED_ROWS.items() if np.isnan(tool.std[rows]).any()) for tool in self.tools}
        return {name: keys for name, keys in missing.items() if keys}

    @property
    def remarks(self) -> tuple[Message, ...]:
        """What has to be known of the numbers."""
        found = [Message.of("workpiece-tool-without-std", tool=name, keys=keys) for name, keys in self.unstated.items()]
        if not self.consistent:
            found.append(Message.of("workpiece-no-rigid-body"))
        return tuple(found)


def workpiece_alone(whole: UncertainParameters, tools: Sequence[KnownTool]) -> Workpiece:
    """Takes tools off the whole that the sensor feels.

    About one point the ten parameters of bodies add: the workpiece's are the difference, and what is uncertain in the whole and in the
    tools, which know nothing of each other, adds as covariance. A tool whose standard deviation nobody has stated adds none.

    Args:
        whole: sensor frame; NaN where not determined, which then is not determined of the workpiece either.
    """
    phi = whole.phi - sum((tool.parameters.phi for tool in tools), start=np.zeros(10))
    variance = sum((np.nan_to_num(tool.std) ** 2 for tool in tools), start=np.zeros(10))
    return Workpiece(phi, whole.covariance + np.diag(variance), tuple(tools))
