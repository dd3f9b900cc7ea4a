"""What a person may ask of a plan."""

from __future__ import annotations

import pytest

from core.errors import BadInput
from core.planning.options import scope_of
from core.planning.settings import Scope


@pytest.mark.parametrize(("said", "axes"), [("x,y", "xy"), ("z, x", "xz"), ("XYZ", "xyz"), ("y", "y"), ("x,x", "x")])
def test_axes_are_read_in_any_order(said: str, axes: str) -> None:
    assert scope_of(said, holds_only=False) == Scope(axes)


def test_holds_only_leaves_the_rotations_out() -> None:
    assert scope_of("xyz", holds_only=True) == Scope("xyz", rotations=False)


@pytest.mark.parametrize("said", ["", ",", "w", "x+", "x;y", "1"])
def test_what_is_no_axis_is_refused(said: str) -> None:
    with pytest.raises(BadInput, match=r"--axes: .* some of x, y and z"):
        scope_of(said, holds_only=False)
