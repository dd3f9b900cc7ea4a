"""A cable that hangs slack within its length, and a hose that is twisted by the last joint."""

from __future__ import annotations

import numpy as np
import pytest

from core.effects.cable_drag import CableDrag
from tests.core.effects import mechanical_truth as brisk
from tests.core.effects.plain_fit import fitted
from tests.core.effects.synthetic_scene import scene

RUN = scene(seconds=9.0)
K = 30.0
GRIP = np.array([0.02, -0.03, 0.05])
PLACE = RUN.position + np.einsum("nij,j->ni", RUN.rotation, GRIP)
ANCHOR = PLACE[0] + [0.3, -0.2, 0.4]
FREE = float(np.median(np.linalg.norm(ANCHOR - PLACE, axis=1)))
"""m; the cable is taut in half of the run."""


def reading(**values: float) -> np.ndarray:
    theta = [values.get(p.name, p.absent) for p in CableDrag().parameters(RUN)]
    return CableDrag().wrench(RUN, RUN.nominal, np.array(theta))


def test_a_cable_pulls_by_what_it_is_stretched_beyond_its_length() -> None:
    expected = RUN.nominal.copy()
    for row, (place, R) in enumerate(zip(PLACE, RUN.rotation, strict=True)):
        length = np.linalg.norm(ANCHOR - place)
        if length > FREE:
            f = R.T @ (K * (length - FREE) * (ANCHOR - place) / length)
            expected[row] -= np.concatenate([f, np.cross(GRIP, f)])
    pull = dict(zip(("pull_x_n", "pull_y_n", "pull_z_n"), K * (ANCHOR - PLACE[0]), strict=True))
    at = dict(zip(("at_x_m", "at_y_m", "at_z_m"), GRIP, strict=True))
    np.testing.assert_allclose(reading(stiffness_n_per_m=K, slack_n=K * FREE, **pull, **at), expected, atol=1e-9)


def test_a_reel_pulls_more_while_it_is_paid_out_and_less_while_it_winds_up() -> None:
    away = ANCHOR - PLACE
    length = np.linalg.norm(away, axis=1)
    towards, quick = away / length[:, None], np.gradient(length, RUN.t)
    pull = dict(zip(("pull_x_n", "pull_y_n", "pull_z_n"), K * away[0], strict=True))
    at = dict(zip(("at_x_m", "at_y_m", "at_z_m"), GRIP, strict=True))
    change = reading(stiffness_n_per_m=K, winding_friction_share=0.3, **pull, **at) - RUN.nominal
    force = -np.einsum("nij,nj,ni->n", RUN.rotation, change[:, :3], towards) / (K * length)
    clear = np.abs(quick) > 0.05
    assert (quick[clear] > 0).any()
    assert (quick[clear] < 0).any()
    np.testing.assert_allclose(force[clear], 1.0 + 0.3 * np.sign(quick[clear]), atol=0.01)


def test_a_hose_resists_the_turning_of_the_last_joint() -> None:
    turn = RUN.q[:, -1] - RUN.q[0, -1]
    axis = RUN.jacobian[:, 3:, -1]
    change = reading(twist_linear_nm=0.4, twist_cube_nm=0.05) - RUN.nominal
    np.testing.assert_allclose(change[:, 3:], (0.4 * turn + 0.05 * turn**3)[:, None] * axis, atol=1e-12)
    np.testing.assert_array_equal(change[:, :3], 0.0)


def test_a_hose_keeps_a_twist_up_to_its_friction_where_the_joint_comes_back() -> None:
    change = reading(twist_friction_nm=0.2) - RUN.nominal
    torque = np.einsum("ni,ni->n", change[:, 3:], RUN.jacobian[:, 3:, -1])
    turn = np.diff(RUN.q[:, -1], prepend=RUN.q[0, -1])
    assert np.abs(torque).max() <= 0.2 + 1e-12
    full = np.abs(np.abs(torque) - 0.2) < 1e-9
    slipping, resting = full & (np.abs(turn) > 1e-6), np.abs(turn) < 1e-12
    assert slipping.any()
    np.testing.assert_array_equal(np.sign(torque[slipping]), np.sign(turn[slipping]))
    assert (np.abs(torque[resting]) > 0.1).any(), "a stop does not untwist it"


def test_a_search_before_the_fit_finds_a_cable_with_slack_on_the_right_side() -> None:
    pull = dict(zip(("pull_x_n", "pull_y_n", "pull_z_n"), K * (ANCHOR - PLACE[0]), strict=True))
    residual = reading(stiffness_n_per_m=K, slack_n=K * FREE, **pull) - RUN.nominal
    starts = CableDrag().starts(RUN, (residual - residual.mean(axis=0)) / [0.1, 0.1, 0.1, 0.005, 0.005, 0.005])
    along = [start[1:4] @ (ANCHOR - PLACE[0]) / np.linalg.norm(start[1:4]) / np.linalg.norm(ANCHOR - PLACE[0]) for start in starts[1:]]
    assert max(along) > 0.8


@pytest.mark.parametrize("anchor", [[0.3, -0.6, 1.4], [0.9, 0.3, 0.5]])
def test_a_reel_that_pulls_alike_at_any_distance_is_a_cable_of_negative_length(anchor: list[float]) -> None:
    run = brisk.scene()
    away = np.array(anchor) - run.position - np.einsum("nij,j->ni", run.rotation, GRIP)
    f = np.einsum("nij,ni->nj", run.rotation, 3.0 * away / np.linalg.norm(away, axis=1, keepdims=True))
    fit = fitted(CableDrag(), run.nominal - np.hstack([f, np.cross(GRIP, f)]), 0.0)
    assert fit.closure > 0.999
    assert fit.theta[8] == pytest.approx(-3.0, abs=0.1)
