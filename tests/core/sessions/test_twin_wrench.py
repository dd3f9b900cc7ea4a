"""What the simulated session shows of a cell's twin, against the true wrench of the virtual robot."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

from core.cell.folder import load_cell
from core.effects.library import library
from core.sessions.simulated import SimulatedSession
from core.twin.model import make_home_scene
from core.twin.twin import NOMINAL, Twin
from tests.twin_entries import entry

CELLS = {name: load_cell(Path(__file__).parents[3] / "cells" / name) for name in ("lwr4_bench", "ur5e_line")}
TICKS = 400
PERIOD = 1e-3


def readings(cell: str, twin: Twin = NOMINAL) -> tuple[np.ndarray, np.ndarray]:
    """The sensor's reading and the true wrench, (N, 6) each, of an arm that starts to move."""
    loaded = CELLS[cell]
    session = SimulatedSession(loaded, next(iter(loaded.payloads.values())).parameters, seed=3, twin=twin)
    speed = 0.5 * np.linspace(1, -0.6, len(session.plant.home))
    read, true = [], []
    with session:
        q = session.state().q_cmd
        for k in range(TICKS):
            q = q + PERIOD * speed * min(1.0, k / 200)
            session.command(q)
            read.append(session.state().wrench)
            true.append(session.plant.truth.wrench)
    return np.array(read), np.array(true)


@cache
def nominal(cell: str) -> tuple[np.ndarray, np.ndarray]:
    """The same without anything added."""
    return readings(cell)


def added(cell: str, twin: Twin) -> np.ndarray:
    """(N, 6), what the twin changes in the reading; noise and offset are the same with and without it."""
    return readings(cell, twin)[0] - nominal(cell)[0]


@pytest.mark.parametrize("cell", CELLS)
def test_a_gain_is_that_share_of_the_true_wrench(cell: str) -> None:
    twin = Twin(effects=(entry(CELLS[cell], "sensor_gain", fx_gain_error_share=0.1, tz_gain_error_share=-0.2),))
    true = nominal(cell)[1]
    np.testing.assert_allclose(added(cell, twin), true * [0.1, 0, 0, 0, 0, -0.2], atol=2e-4)


@pytest.mark.parametrize("cell", CELLS)
def test_a_delay_shows_the_true_wrench_of_before(cell: str) -> None:
    late = 13
    twin = Twin(effects=(entry(CELLS[cell], "time_delay", delay_s=late * PERIOD),))
    true = nominal(cell)[1]
    wanted = true[:-late] - true[late:]
    assert np.abs(wanted[200:]).max() > 0.05
    np.testing.assert_allclose(added(cell, twin)[late:], wanted, atol=1e-3)


def test_a_jump_of_the_offset_comes_when_the_twin_says() -> None:
    twin = Twin(effects=(entry(CELLS["lwr4_bench"], "sensor_offset_step", fz_step_n=2.0, step_time_s=0.2),))
    change = added("lwr4_bench", twin)[:, 2]
    assert np.abs(change[:198]).max() < 1e-9
    np.testing.assert_allclose(change[203:], 2.0, atol=1e-9)


@pytest.mark.parametrize("effect", library(), ids=lambda effect: effect.id)
def test_every_effect_of_the_library_can_be_shown_live(effect) -> None:
    cell = CELLS["lwr4_bench"]
    sizes = {p.name: min(p.upper, p.absent + 0.1 * p.scale) for p in effect.parameters(make_home_scene(cell)) if not p.name.endswith("_s")}
    change = added("lwr4_bench", Twin(effects=(entry(cell, effect.id, **sizes),)))
    assert np.isfinite(change).all()
