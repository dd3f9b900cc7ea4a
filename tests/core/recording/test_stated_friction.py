"""`core.recording.stated_friction`: the shipped cells state what their virtual robots have, and recordings carry it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.cell.cell import Cell
from core.plant.arm import arm_of_cell
from core.plant.mechanics import NOTHING, Drives, build_model
from core.recording.stated_friction import read_friction, with_cell_friction
from core.robot.model import RobotModel
from core.sessions.sample_log import SampleLog
from core.sessions.simulated import SimulatedSession
from tests.core.recording.small_recording import recording


def test_a_cell_states_the_friction_of_its_virtual_robot(cell: Cell) -> None:
    stated = read_friction(cell)
    machine = build_model(arm_of_cell(cell), NOTHING, cell.gravity, Drives())
    assert stated is not None
    np.testing.assert_allclose(stated.coulomb, machine.dof_frictionloss, rtol=1e-6)
    np.testing.assert_allclose(stated.viscous, machine.dof_damping, rtol=1e-6)


def test_what_is_recorded_in_a_cell_carries_what_it_states(cell: Cell) -> None:
    log = SampleLog(cell, RobotModel.of_cell(cell), payload=None, reference=None)
    with SimulatedSession(cell, next(iter(cell.payloads.values())).parameters) as robot:
        log.extend([robot.state()], "hold:free")
    carried, stated = log.recording().friction, read_friction(cell)
    assert carried is not None and stated is not None
    np.testing.assert_array_equal(carried.coulomb, stated.coulomb)


def test_a_cell_that_says_nothing_of_friction_states_none(cell: Cell) -> None:
    silent = cell.model_copy(update={"robot": cell.robot.model_copy(update={"friction": None})})
    assert read_friction(silent) is None
    assert with_cell_friction(replace(recording(), friction=None), silent).friction is None


def test_a_recording_learns_of_friction_from_its_own_cell_alone(cell: Cell) -> None:
    n = len(cell.robot.home_rad)
    older = replace(recording(), friction=None, cell=cell.name, q=np.zeros((40, n)))
    told = with_cell_friction(older, cell).friction
    assert told is not None
    np.testing.assert_array_equal(told.coulomb, np.array(cell.robot.friction.coulomb_n_m))
    assert with_cell_friction(replace(older, cell="elsewhere"), cell).friction is None
    assert with_cell_friction(replace(older, q=np.zeros((40, n + 1))), cell).friction is None
    own = replace(older, friction=recording().friction)
    assert with_cell_friction(own, cell) is own
