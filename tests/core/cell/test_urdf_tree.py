"""Links of a URDF as bodies, read from its XML."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

from core.cell.urdf_tree import UrdfTree, without_inertia
from core.payload.inertia import PINOCCHIO_ORDER
from tests.core.handed import HAND

URDF = (
    '<robot name="handed"><link name="base"/><link name="wrist"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>'
    '<link name="ft"/><joint name="turn" type="revolute"><parent link="base"/><child link="wrist"/><origin xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
    '<joint name="mount" type="fixed"><parent link="wrist"/><child link="ft"/><origin xyz="0.1 0 0" rpy="0.3 0.2 0.1"/></joint>'
    + HAND.format(parent="ft")
    + "</robot>"
)


def test_what_hangs_behind_a_link_is_all_below_it_and_not_the_link() -> None:
    tree = UrdfTree(URDF)
    assert tree.behind("ft") == ("hand", "finger", "grasp")
    assert tree.behind("hand") == ("finger", "grasp")
    assert tree.behind("grasp") == ()
    assert tree.behind("base") == ("wrist", "ft", "hand", "finger", "grasp")


def test_a_link_with_a_mass_or_a_shape_is_a_body() -> None:
    tree = UrdfTree(URDF)
    assert [link for link in tree.links if tree.has_body(link)] == ["wrist", "hand", "finger"]


@pytest.mark.parametrize("links", [("hand",), ("finger",), ("hand", "finger")])
def test_links_seen_from_a_frame_have_the_inertia_that_pinocchio_has(links: tuple[str, ...]) -> None:
    behind = '<robot name="behind"><link name="ft"/>' + HAND.format(parent="ft") + "</robot>"
    full = pin.buildModelFromXML(without_inertia(behind, {"hand", "finger"} - set(links)), pin.JointModelFreeFlyer())
    one = pin.buildReducedModel(full, [full.getJointId("slide")], pin.neutral(full))
    expected = one.inertias[1].toDynamicParameters()
    found = UrdfTree(URDF).merge_links("ft", links)
    np.testing.assert_allclose(found.phi, expected[PINOCCHIO_ORDER], atol=1e-12)
    assert found.mass > 0


def test_links_can_be_made_massless_and_the_rest_stays() -> None:
    bare = UrdfTree(without_inertia(URDF, ["hand"]))
    assert bare.merge_links("ft", ["hand"]).mass == 0.0
    assert bare.merge_links("ft", ["finger"]).mass == 0.05
    assert bare.has_body("hand")
    assert without_inertia(URDF, []) is URDF
