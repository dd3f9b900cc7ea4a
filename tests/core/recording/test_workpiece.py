"""The workpiece is the whole without the tools, as uncertain as both together."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from core.payload.inertia import InertialParameters
from core.payload.known_tool import KnownTool, add_tools
from core.payload.uncertain_parameters import UncertainParameters
from core.recording.workpiece import workpiece_alone

lengths = st.floats(-0.2, 0.2)


@st.composite
def bodies(draw: Any) -> InertialParameters:
    """Points with masses: whatever they are, a rigid body."""
    points = draw(arrays(float, (5, 3), elements=lengths)) + 0.01 * np.vstack([np.eye(3), -np.eye(3)[:2]])
    masses = draw(arrays(float, 5, elements=st.floats(0.05, 2.0)))
    inertia = sum(m * (p @ p * np.eye(3) - np.outer(p, p)) for m, p in zip(masses, points, strict=True))
    six = [inertia[0, 0], inertia[0, 1], inertia[0, 2], inertia[1, 1], inertia[1, 2], inertia[2, 2]]
    return InertialParameters(np.array([masses.sum(), *(masses @ points), *six]))


@st.composite
def tools(draw: Any) -> KnownTool:
    std = draw(arrays(float, 10, elements=st.floats(0.0, 0.01)))
    return KnownTool("tool", "A tool", draw(bodies()), std)


@st.composite
def covariances(draw: Any) -> np.ndarray:
    root = draw(arrays(float, (10, 10), elements=st.floats(-0.01, 0.01)))
    return np.asarray(root @ root.T + 1e-8 * np.eye(10))


@settings(max_examples=50, deadline=None)
@given(bodies(), st.lists(tools(), max_size=3), covariances())
def test_the_whole_without_the_tools_is_the_workpiece_and_the_covariance_is_the_sum(
    workpiece: InertialParameters, mounted: list[KnownTool], covariance: np.ndarray
) -> None:
    whole = add_tools(mounted, workpiece)
    found = workpiece_alone(UncertainParameters(whole.phi, covariance), mounted)
    np.testing.assert_allclose(found.phi, workpiece.phi, atol=1e-12)
    expected = covariance.copy()
    for tool in mounted:
        expected += np.diag(tool.std**2)
    np.testing.assert_allclose(found.covariance, expected, atol=1e-15)
    assert (found.std >= np.sqrt(np.diag(covariance)) * (1 - 1e-12)).all()
    assert found.unstated == {}


def test_drawn_tools_and_wholes_scatter_as_the_covariance_says() -> None:
    """Monte Carlo, without the formula: errors of whole and tool drawn, the difference's covariance counted."""
    random = np.random.default_rng(5)
    root = random.normal(size=(10, 10)) * 0.01
    tool = known(np.linspace(0.001, 0.02, 10))
    whole = np.full(10, 3.0)
    drawn = whole + random.normal(size=(200_000, 10)) @ root.T - (tool.parameters.phi + random.normal(size=(200_000, 10)) * tool.std)
    found = workpiece_alone(UncertainParameters(whole, root @ root.T), [tool])
    counted = np.cov(drawn.T)
    np.testing.assert_allclose(counted, found.covariance, atol=0.02 * float(np.abs(counted).max()))


def known(std: np.ndarray) -> KnownTool:
    parameters = InertialParameters.from_com(0.8, [0.0, 0.0, 0.04], np.diag([0.001, 0.001, 0.0008]))
    return KnownTool("gripper", "A gripper", parameters, std)


def test_a_tool_without_a_stated_uncertainty_adds_none_and_is_named() -> None:
    std = np.array([0.002, *[np.nan] * 3, *[1e-5] * 6])
    whole = UncertainParameters(add_tools([known(std)], heavy()).phi, 1e-6 * np.eye(10))
    found = workpiece_alone(whole, [known(std)])
    assert found.unstated == {"gripper": ("first_moment_std_kg_m",)}
    assert found.std[0] == pytest.approx(np.hypot(0.001, 0.002))
    np.testing.assert_allclose(found.std[1:4], 0.001)
    remark = found.remarks[0]
    assert remark.code == "workpiece-tool-without-std"
    assert "tool gripper is unknown (first_moment_std_kg_m not stated)" in remark.text


def heavy() -> InertialParameters:
    return InertialParameters.from_com(2.0, [0.0, 0.01, 0.05], np.diag([0.004, 0.005, 0.003]))


def test_what_is_not_determined_of_the_whole_is_not_of_the_workpiece() -> None:
    phi, covariance = add_tools([known(np.zeros(10))], heavy()).phi.copy(), 1e-6 * np.eye(10)
    phi[5], covariance[5, :], covariance[:, 5] = np.nan, np.nan, np.nan
    found = workpiece_alone(UncertainParameters(phi, covariance), [known(np.zeros(10))])
    assert np.isnan(found.phi).tolist() == [k == 5 for k in range(10)]
    assert np.isnan(found.std).tolist() == [k == 5 for k in range(10)]
    assert found.consistent
    assert found.remarks == ()


def test_it_is_said_where_what_is_left_is_no_body() -> None:
    alone = known(np.zeros(10)).parameters
    found = workpiece_alone(UncertainParameters(alone.phi * 0.9, 1e-6 * np.eye(10)), [known(np.zeros(10))])
    assert not found.consistent
    assert [remark.code for remark in found.remarks] == ["workpiece-no-rigid-body"]
