"""Every figure in bold on the page about the paper, worked out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from bench.coverage import relative_errors, table_2
from core.control.bounds import JointLimits, velocity_bounds
from core.estimation.kinematic_filter import find_bandwidth, pose_noise_std, steady_std
from core.estimation.regression import RecursiveRegression, Thresholds, regress
from core.estimation.segments import ALONG_AXIS
from core.planning.settings import Timing
from core.robot.decoupling import ACCELERATION
from tests.synthetic import NOISE_STD, payload

PAGE = (Path(__file__).parents[2] / "docs" / "paper.md").read_text(encoding="utf-8")
TORQUE_VARIANCE = np.array([7.9e-6, 9.3e-6, 9.2e-6])
FORCE_VARIANCE = np.array([3.0e-3, 2.3e-3, 5.3e-3])
ALPHA_VARIANCE, QUATERNION_VARIANCE = 1.1e-3, 1e-14
"""Table 2."""
REFERENCE = np.array([2.7830, -4.682e-2, 1.015e-1, 6.928e-3, 6.634e-3, 3.326e-3])
IDENTIFIED = np.array([2.7806, -4.662e-2, 1.014e-1, 7.033e-3, 7.407e-3, 3.081e-3])
STATED_STD = np.array([7.9e-4, 1.4e-6, 2.0e-6, 2.6e-4, 1.6e-4, 1.2e-4])
"""Tables 1 and 3, steel block: m, mc_y, mc_z, Ixx, Iyy, Izz."""
BRAKING, DISTANCE, PERIOD = 10.0, 0.1, 1e-3


def bold_on(row: str) -> list[str]:
    """What is printed in bold on the row of the page that begins like this."""
    (line,) = (line for line in PAGE.splitlines() if line.startswith(f"| {row}"))
    return re.findall(r"\*\*([^*]+)\*\*", line)


def numbers_on(row: str) -> list[float]:
    """The first number of each."""
    found = [re.match(r"-?[\d.]+(?:e-\d+)?", text) for text in bold_on(row)]
    return [float(match[0]) for match in found if match]


@pytest.fixture(scope="module")
def filter_std() -> float:
    """Noise of one pose with the encoders of the cells here."""
    return pose_noise_std(2e-6, 7)


def test_swings_are_as_wide_and_as_fast_as_the_page_says() -> None:
    swing = Timing().swing_rad
    # a triangle of angular velocity: half the angle while it rises
    assert numbers_on("swing") == [swing, round(float(np.sqrt(swing * ACCELERATION)), 2)]


def test_an_error_state_and_a_quaternion_differ_in_the_third_order() -> None:
    correction = 1e-4
    # the quaternion [1, d/2], normalised, turns by 2 atan(d/2); its series, since the difference is below rounding
    assert numbers_on("Kalman filter") == [float(f"{correction**3 / 12:.0e}")]


def test_the_bandwidth_that_table_2b_speaks_of_and_ours(filter_std: float) -> None:
    # variances 2 w r of an angle, which is twice the quaternion's component, and 2 w^5 r of its second derivative
    theirs = (ALPHA_VARIANCE / (4.0 * QUATERNION_VARIANCE)) ** 0.25
    ours = find_bandwidth(filter_std, PERIOD)
    assert numbers_on("its process noise") == [round(theirs), round(ours)]
    assert steady_std(PERIOD, position_std=filter_std, orientation_std=filter_std)[1] ** 2 == pytest.approx(ALPHA_VARIANCE, rel=0.05)
    # acceleration over jerk-driven motion is w^3 / (s^3 + 2 w s^2 + 2 w^2 s + w^3): late by 2/w
    assert numbers_on("its lag") == [pytest.approx(2e3 / ours, abs=0.6)]


def test_thresholds_and_samples_that_count() -> None:
    thresholds = Thresholds.of_noise(0.0, 0.0, float(np.sqrt(ALPHA_VARIANCE)))
    assert numbers_on("thresholds") == [round(thresholds.fast, 2), round(thresholds.slow, 2)]
    assert numbers_on("samples that count") == [round(float(np.degrees(np.arccos(ALONG_AXIS))), 1), thresholds.in_place]


def test_offsets_taken_out_of_the_result_are_offsets_taken_out_of_the_samples() -> None:
    rng, offset = np.random.default_rng(0), np.array([3.0, -2.0, 5.0, 0.1, -0.2, 0.05])
    g = 9.81 * np.concatenate((np.eye(3), -np.eye(3)))
    wrench = rng.normal(size=(6, 6))
    still = np.zeros(3)
    both = [RecursiveRegression(Thresholds((1.0, 1.0), 1.0, 1.0), NOISE_STD**2) for _ in range(2)]
    for row, load in zip(g, wrench, strict=True):
        both[0].update(row, still, still, still, load + offset)
        both[1].update(row, still, still, still, load)
    after, before = (
        each.found.parameters(o, torque_std=NOISE_STD[3:], alpha_std=1.0)[0][:4] for each, o in zip(both, (offset, 0 * offset), strict=True)
    )
    np.testing.assert_allclose(after, before, atol=1e-12)
    assert numbers_on("offsets") == [0]


def test_braking_in_steps_needs_a_little_less_speed_than_the_root_says() -> None:
    limits = JointLimits(np.array([-1.0]), np.array([DISTANCE]), np.array([100.0]), np.array([BRAKING]))
    root = float(np.sqrt(2.0 * BRAKING * DISTANCE))
    _, upper = velocity_bounds(np.zeros(1), np.array([root]), limits, PERIOD)
    assert numbers_on("Eq. (7), braking") == [round(root - float(upper[0]), 3)]
    assert numbers_on("Eq. (7), upper bound") == [round(-root, 2)]


def test_with_gravity_itself_as_regressor_a_mass_is_negative() -> None:
    g = 9.81 * np.eye(3)[:, :, None]
    mass = regress(g, -REFERENCE[0] * g, FORCE_VARIANCE)[0]
    assert numbers_on("Algorithm 1") == [pytest.approx(float(mass[0, 0]), abs=5e-4)]


def test_eq_8_as_printed_is_no_covariance() -> None:
    S, r, noise = np.eye(1), np.array([[0.0], [0.0], [-9.81]]), np.diag(FORCE_VARIANCE)
    rows, columns = (S @ r.T @ (r @ S @ r.T + noise)).shape
    assert bold_on("Eq. (8)") == [f"{rows} x {columns}"]


def test_algorithms_7_and_8_as_printed() -> None:
    J, task = np.random.default_rng(1).normal(size=(3, 7)), np.array([0.2, -0.1, 0.3])
    W = -np.eye(7)
    achieved = J @ np.linalg.pinv(J @ W) @ task
    assert numbers_on("Algorithm 7, line 2 ") == [round(float(achieved @ task / (task @ task)))]
    assert numbers_on("Algorithm 7, line 20") == [np.linalg.matrix_rank(J)]
    low, high = -1.0 / -1.0, 1.0 / -1.0  # a joint with a = -1, b = 0 between -1 and 1
    assert low > high
    low = high
    high = low
    assert bold_on("Algorithm 8, lines") == [f"[{low:.0f}, {high:.0f}]"]


def test_table_3_is_not_what_eq_10_says() -> None:
    inertia = REFERENCE[3:]
    relative = np.hypot(np.sqrt(TORQUE_VARIANCE) / (inertia * ACCELERATION), np.sqrt(ALPHA_VARIANCE) / ACCELERATION)
    assert numbers_on("Table 3 against Eq. (10)") == [round(100 * float(v), 1) for v in relative]


def test_table_3_does_not_cover_the_errors_of_table_1() -> None:
    times = np.abs(IDENTIFIED - REFERENCE) / STATED_STD
    assert numbers_on("Table 3 against the errors") == [round(float(times[0]), 1), round(float(times[1])), round(float(times[2]))]
    assert numbers_on("the same: Ixx") == [round(float(v), 1) for v in times[3:]]


@pytest.mark.parametrize(
    ("row", "name"), [("steel block", "steel_block"), pytest.param("cylinder", "cylinder", marks=pytest.mark.thorough)]
)
def test_the_papers_method_errs_by_what_the_page_says(row: str, name: str) -> None:
    errors = np.array([table_2(name, 10 * seed, imperfect=False).paper_error for seed in range(3)])
    found = np.median(relative_errors(errors, payload(name)), axis=0)[[4, 7, 9]]
    (text,) = bold_on(row)
    np.testing.assert_allclose([float(v) for v in text.split(", ")], found, atol=0.06)


def test_no_figure_is_left_without_a_test() -> None:
    source = Path(__file__).read_text(encoding="utf-8")
    asked = set(re.findall(r'_on\("([^"]+)"\)', source)) | {"steel block", "cylinder"}
    for line in _rows():
        assert "**" not in line or any(line.startswith(f"| {row}") for row in asked), line


def _rows() -> Iterator[str]:
    return (line for line in PAGE.splitlines() if line.startswith("| "))
