"""What viser shows of a cell: robot, payload box, obstacles, zones, starts, path, where the load would fly, what is nearest."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import viser
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from viser import _messages as messages

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import tool_boxes
from core.report.faces import Faces, arm_parts, joint_poses, shape_faces
from core.robot.model import RobotModel
from server.runner.live_schemas import NearestPart
from server.runner.plan_schemas import RunPlan, ThrowPart
from server.viewer.first_look import first_look

Colour = tuple[int, int, int]

STEEL, LOAD, SOLID, ZONE, GHOST, PATH, NEAR, THROW = (
    (120, 126, 132), (70, 110, 150), (168, 172, 176), (214, 164, 40), (150, 156, 162), (60, 90, 130), (190, 120, 20), (176, 70, 40),
)  # fmt: skip
"""Grey ground; colour for what is to be minded."""
INK: Colour = (20, 24, 27)
FIELD_OF_VIEW_RAD = 0.8
ARROW_S = 1.5
"""Length of the arrow that shows where the load would fly, as time at its speed."""


def open_server() -> viser.ViserServer:
    """A viser server that nobody outside reaches, and that cannot be asked for a public tunnel."""
    server = viser.ViserServer(host="127.0.0.1", port=0, label="Heft", verbose=False)
    for message in (messages.ShareUrlRequest, messages.ShareUrlDisconnect):
        server._websock_server.unregister_handler(message)
    server.scene.set_up_direction("+z")
    server.gui.configure_theme(control_width="small", show_logo=False, show_share_button=False)
    server.gui.main_panel.minimize()
    return server


class ViewerScene:
    """One cell on one viser server."""

    def __init__(self, server: viser.ViserServer, cell: Cell) -> None:
        self._server, self._cell = server, cell
        self._robot = RobotModel.of_cell(cell)
        self._parts = arm_parts(cell, self._robot)
        server.scene.add_grid("/floor", width=4.0, height=4.0, position=(0.0, 0.0, cell.floor_z_m))
        for obstacle in cell.obstacles:
            self._mesh(f"/obstacles/{obstacle.name}", shape_faces(obstacle.shape), SOLID)
        self.show_zones(cell)
        self._frames = self._arm("/robot", STEEL, 1.0)
        for name, box in tool_boxes(cell).items():
            self._show_carried(f"tool-{name}", box, STEEL)
        self.show_payload_box(cell.payload_box)
        self.move(np.array(cell.robot.home_rad), None)
        server.initial_camera.position, server.initial_camera.look_at = first_look(cell, self._robot)
        server.initial_camera.fov = FIELD_OF_VIEW_RAD

    def show_zones(self, cell: Cell) -> None:
        """The protected zones where they are now."""
        for zone in cell.zones:
            self._mesh(f"/zones/{zone.name}", shape_faces(zone.shape), ZONE, 0.35)

    def show_payload_box(self, box: Box) -> None:
        """What certainly contains the payload."""
        self._show_carried("payload", box, LOAD)

    def _show_carried(self, name: str, box: Box, colour: Colour) -> None:
        """A box in the sensor frame."""
        sensor = self._robot.sensor_pose(np.array(self._cell.robot.home_rad))
        rotation, position = joint_poses(self._robot, np.array(self._cell.robot.home_rad))[-1]
        faces = [(face @ sensor.rotation.T + sensor.position - position) @ rotation for face in shape_faces(box)]
        self._mesh(f"/robot/{self._robot.n}/{name}", faces, colour, 0.6)

    def show_plan(self, plan: RunPlan) -> None:
        """Start configurations as ghosts, and the way of the sensor between them."""
        for pose in plan.summary.poses:
            if pose.rotation_s is not None:
                self._place(self._arm(f"/plan/{pose.axis[0]}", GHOST, 0.2), np.array(pose.q_rad))
        ways = [self._robot.sensor_poses(np.array(path.q_rad)).position for path in plan.paths]
        segments = np.concatenate([np.stack(pair) for way in ways for pair in pairwise(way)]).reshape(-1, 2, 3)
        self._server.scene.add_line_segments("/plan/path", segments, PATH, thickness=0.004)
        for throw in plan.throws:
            self._show_throw(throw)

    def move(self, q: Array, nearest: NearestPart | None) -> None:
        """The robot at q (n,), and the line of the smallest distance."""
        with self._server.atomic():
            self._place(self._frames, q)
            if nearest is not None:
                ends = np.array([[nearest.point_first_m, nearest.point_second_m]])
                self._server.scene.add_line_segments("/nearest/line", ends, NEAR, thickness=0.006)
                text = f"{nearest.second}: {nearest.distance_m:.3f} m"
                self._server.scene.add_label("/nearest/label", text, position=tuple(ends[0].mean(axis=0)))

    def _show_throw(self, throw: ThrowPart) -> None:
        """An arrow from where the load would fly off to where it would be some seconds later without gravity; how far from which zone."""
        begin = np.array(throw.point_m)
        end = begin + ARROW_S * np.array(throw.velocity_m_s)
        name = f"/plan/throw/{throw.axis[0]}"
        if throw.speed_m_s > 0.0:
            self._server.scene.add_arrows(
                f"{name}/arrow", np.array([[begin, end]]), THROW, shaft_radius=0.006, head_radius=0.016, head_length=0.04
            )
        text = f"{throw.axis} → {throw.zone}: {throw.distance_m:.2f} m"
        self._server.scene.add_label(f"{name}/label", text, position=tuple(end))

    def _arm(self, root: str, colour: Colour, opacity: float) -> list[viser.FrameHandle]:
        """Frames of the joints with the bodies in them; the frames are what moves."""
        frames = [self._server.scene.add_frame(f"{root}/{joint}", show_axes=False) for joint in range(self._robot.n + 1)]
        for k, (joint, faces) in enumerate(self._parts):
            self._mesh(f"{root}/{joint}/body{k}", faces, colour, opacity)
        return frames

    def _place(self, frames: list[viser.FrameHandle], q: Array) -> None:
        for frame, (rotation, position) in zip(frames, joint_poses(self._robot, q), strict=True):
            frame.wxyz = Rotation.from_matrix(rotation).as_quat(scalar_first=True)
            frame.position = position

    def _mesh(self, name: str, faces: Faces, colour: Colour, opacity: float = 1.0) -> None:
        add_body(self._server.scene, name, faces, colour, opacity)


def add_body(scene: viser.SceneApi, name: str, faces: Faces, colour: Colour, opacity: float = 1.0) -> None:
    """A body of convex faces, or another one in place of that of the same name."""
    corners, triangles = triangles_of(faces)
    shown = None if opacity == 1.0 else opacity
    scene.add_mesh_simple(name, corners, triangles, color=colour, opacity=shown, flat_shading=True, side="double")


def triangles_of(faces: Faces) -> tuple[Array, NDArray[np.int32]]:
    """Corners (k, 3) and triangles (m, 3) of convex faces."""
    starts = np.cumsum([0, *(len(face) for face in faces)])
    fans = [[start, start + i, start + i + 1] for start, face in zip(starts, faces, strict=False) for i in range(1, len(face) - 1)]
    return np.concatenate(faces), np.array(fans, dtype=np.int32)
