"""An independent opinion on distances: python-fcl, bodies as boxes, Pinocchio's own placements of a freshly read URDF.

python-fcl puts a few pairs of boxes in ten thousand, nearly parallel ones, centimetres too far away. Its answer counts where the boxes are
that far apart along the direction of its own nearest points; elsewhere the certified distance of the tests does.
"""

from __future__ import annotations

import os
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import fcl
import numpy as np
import pinocchio as pin
import pytest
from hypothesis import settings
from scipy.spatial.transform import Rotation

from core.cell.cell import Box, Cell
from core.cell.folder import load_cell
from tests.convex_distance import Convex
from tests.convex_distance import box as box_of_size
from tests.convex_distance import distance as certified_distance

settings.register_profile("no_deadline", deadline=None)  # the first example compiles
settings.load_profile("no_deadline")

os.environ["HEFT_LANGUAGE"] = "en"  # whatever the machine speaks, here and in the commands that tests start

ROOT = Path(__file__).parents[2]
CELLS = ("lwr4_bench", "ur5e_line")

FclDistances = Callable[[np.ndarray], dict[tuple[str, str], float]]


CERTIFIED_M = 1e-7


class PlacedBox:
    """A box in the world, for python-fcl and as its corners."""

    def __init__(self, size: object, rotation: np.ndarray, translation: np.ndarray) -> None:
        sides = np.array(size, dtype=float)
        self.fcl = fcl.CollisionObject(fcl.Box(*sides), fcl.Transform(rotation, translation))
        self.hull = Convex(box_of_size(sides).points @ rotation.T + translation)


class FclScene:
    """Distances of all links and the payload box to everything in the cell that is a box (a sphere as a tiny box less its radius)."""

    def __init__(self, cell: Cell, payload_box: Box) -> None:
        self.cell = cell
        self.model = pin.buildModelFromXML(cell.urdf)
        self.data = self.model.createData()
        self.world = pin.SE3(cell.robot.base.rotation, cell.robot.base.translation)
        self.bodies: list[tuple[str, str, object, pin.SE3]] = []
        for link in ET.fromstring(cell.urdf).iter("link"):
            for body in link.iter("collision"):
                origin, box = body.find("origin"), body.find("geometry/box")
                xyz = [float(x) for x in origin.get("xyz").split()]
                rpy = [float(x) for x in origin.get("rpy", "0 0 0").split()]
                local = pin.SE3(Rotation.from_euler("xyz", rpy).as_matrix(), np.array(xyz))
                self.bodies.append((link.get("name"), link.get("name"), [float(x) for x in box.get("size").split()], local))
        local = pin.SE3(payload_box.pose.rotation, payload_box.pose.translation)
        self.bodies.append(("payload", cell.robot.sensor_frame, payload_box.size_m, local))

    def _placed(self, q: np.ndarray) -> dict[str, PlacedBox]:
        pin.framesForwardKinematics(self.model, self.data, q)
        placed = {}
        for name, frame, size, local in self.bodies:
            T = self.world * self.data.oMf[self.model.getFrameId(frame)] * local
            placed[name] = PlacedBox(size, T.rotation, T.translation)
        return placed

    def to_environment(self, q: np.ndarray) -> dict[tuple[str, str], float]:
        """Distance of every body to every obstacle, zone and the floor; negative or 0 where they touch."""
        distances = {}
        for item in (*self.cell.obstacles, *self.cell.zones):
            size, radius = (item.shape.size_m, 0.0) if item.shape.kind == "box" else ((1e-9,) * 3, item.shape.radius_m)
            thing = PlacedBox(size, item.shape.pose.rotation, item.shape.pose.translation)
            for name, body in self._placed(q).items():
                distances[name, item.name] = _distance(body, thing) - radius
        distances |= {(name, "floor"): height - self.cell.floor_z_m for name, height in self._lowest(q).items()}
        return distances

    def _lowest(self, q: np.ndarray) -> dict[str, float]:
        """Height of the lowest corner of every body."""
        pin.framesForwardKinematics(self.model, self.data, q)
        found = {}
        for name, frame, size, local in self.bodies:
            T = self.world * self.data.oMf[self.model.getFrameId(frame)] * local
            found[name] = float(T.translation[2] - 0.5 * np.abs(T.rotation[2]) @ np.array(size, dtype=float))
        return found

    def between(self, q: np.ndarray, first: str, second: str) -> float:
        placed = self._placed(q)
        return _distance(placed[first], placed[second])


def _distance(first: PlacedBox, second: PlacedBox) -> float:
    request, result = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True), fcl.DistanceResult()
    found = float(fcl.distance(first.fcl, second.fcl, request, result))
    if found <= 0.0:
        return found
    direction = np.subtract(*result.nearest_points) / np.linalg.norm(np.subtract(*result.nearest_points))
    gap = (first.hull.points @ direction).min() - (second.hull.points @ direction).max()
    return found if gap > found - CERTIFIED_M else certified_distance(first.hull, second.hull)


@pytest.fixture(scope="session")
def fcl_scene() -> Callable[[Cell, Box], FclScene]:
    return FclScene


@pytest.fixture(scope="session", params=CELLS)
def cell(request: pytest.FixtureRequest) -> Cell:
    return load_cell(ROOT / "cells" / request.param)
