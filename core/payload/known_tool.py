"""A tool whose inertia is known, wherever it was stated: in the sensor frame, about the sensor origin."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from core.array import Array
from core.payload.inertia import InertialParameters


@dataclass(frozen=True)
class KnownTool:
    """What is bolted between the sensor and the workpiece.

    Args:
        std: (10,), standard deviations of the parameters, independent of each other; NaN where nobody has stated one.
    """

    name: str
    title: str
    parameters: InertialParameters
    std: Array


def add_tools(tools: Iterable[KnownTool], workpiece: InertialParameters) -> InertialParameters:
    """Tools and workpiece as one rigid body: what the sensor feels. About one point the ten parameters of bodies add."""
    return InertialParameters(sum((tool.parameters.phi for tool in tools), start=workpiece.phi))
