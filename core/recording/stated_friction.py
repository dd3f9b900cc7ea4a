"""What a cell says of the friction in its robot's joints, for the recordings that are made there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.cell.cell import Cell
from core.recording.recording import FrictionDescription, Recording


def read_friction(cell: Cell) -> FrictionDescription | None:
    """As arrays; None where the cell says nothing of it."""
    friction = cell.robot.friction
    return None if friction is None else FrictionDescription(np.array(friction.coulomb_n_m), np.array(friction.viscous_n_m_s))


def with_cell_friction(recording: Recording, cell: Cell) -> Recording:
    """A recording made in that cell that says nothing of friction, with what the cell says; any other one as it is."""
    n = len(cell.robot.home_rad)
    fits = recording.cell in (None, cell.name) and recording.q is not None and recording.q.shape[1] == n
    return replace(recording, friction=read_friction(cell)) if fits and recording.friction is None else recording
