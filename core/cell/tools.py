"""A cell's tools as bodies: what they weigh and what room they take."""

from __future__ import annotations

import numpy as np

from core.cell.cell import Box, Cell
from core.cell.tool_checks import tool_parameters
from core.payload.inertia import InertialParameters
from core.payload.known_tool import KnownTool, add_tools


def find_tools(cell: Cell) -> tuple[KnownTool, ...]:
    """The cell's tools, in the order of cell.toml."""
    parameters = tool_parameters(cell)
    found = []
    for name, tool in cell.tools.items():
        mass = np.nan if tool.mass_std_kg is None else tool.mass_std_kg
        first_moment, inertia = tool.first_moment_std_kg_m or (np.nan,) * 3, tool.inertia_std_kg_m2 or (np.nan,) * 6
        found.append(KnownTool(name, tool.title, parameters[name], np.array([mass, *first_moment, *inertia])))
    return tuple(found)


def add_cell_tools(cell: Cell, workpiece: InertialParameters) -> InertialParameters:
    """What the cell's sensor feels where the robot carries a workpiece: the tools with it."""
    return add_tools(find_tools(cell), workpiece)


def tool_boxes(cell: Cell) -> dict[str, Box]:
    """The boxes that tools state, by the names of the tools; those of links are in the URDF."""
    return {name: tool.box for name, tool in cell.tools.items() if tool.box is not None}


def widest_box(cell: Cell, payload_box: Box) -> Box:
    """Of payload and tools the box with the corner farthest from the sensor origin: it limits how fast the sensor may turn."""
    return max((payload_box, *tool_boxes(cell).values()), key=lambda box: float(np.linalg.norm(box.corners, axis=1).max()))
