"""What a person may ask of a plan."""

from __future__ import annotations

import pytest

from core.errors import BadInput
from core.planning.options import Purpose, scope_of, stops_for
from core.planning.settings import Scope
from core.planning.stops import Stops
from core.requirement.target import parse_target


@pytest.mark.parametrize(("said", "axes"), [("x,y", "xy"), ("z, x", "xz"), ("XYZ", "xyz"), ("y", "y"), ("x,x", "x")])
def test_axes_are_read_in_any_order(said: str, axes: str) -> None:
    assert scope_of(said, holds_only=False) == Scope(axes)


def test_holds_only_leaves_the_rotations_out() -> None:
    assert scope_of("xyz", holds_only=True) == Scope("xyz", rotations=False)


@pytest.mark.parametrize("said", ["", ",", "w", "x+", "x;y", "1"])
def test_what_is_no_axis_is_refused(said: str) -> None:
    with pytest.raises(BadInput, match=r"--axes: .* some of x, y and z"):
        scope_of(said, holds_only=False)


def test_for_the_joints_torques_there_is_a_wave_of_all_joints_at_each_axis() -> None:
    stops = stops_for(Purpose.joint_torques, Scope("xz"))
    assert stops.labels == ("x+", "z+")
    assert all(stop.wave is not None and stop.wave.wrist is None and stop.swings is None for stop in stops.stops)


def test_for_the_wrist_sensor_they_are_those_of_the_procedure() -> None:
    assert stops_for(Purpose.wrist_sensor, Scope()) == Stops.of_procedure()


def test_what_only_rotations_know_is_refused_beside_joint_torques() -> None:
    with pytest.raises(BadInput, match=r"--for: .*--holds-only"):
        stops_for(Purpose.joint_torques, Scope(rotations=False))
    with pytest.raises(BadInput, match=r"--for: .*--target"):
        stops_for(Purpose.joint_torques, Scope(), parse_target("mass=1%"))
