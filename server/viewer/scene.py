"""What viser shows of a cell to all: robot, payload box, obstacles, zones, starts, path, where the load would fly, what is nearest."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import viser
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from viser import _messages as messages

from core.array import Array
from core.cell.cell import Box, Cell
from core.cell.tools import tool_boxes
from core.report.faces import Faces, Part, arm_parts, joint_poses, shape_faces, standing_faces
from core.robot.model import RobotModel
from server.runner.live_schemas import NearestPart
from server.runner.plan_schemas import RunPlan, ThrowPart
from server.viewer.first_look import FIELD_OF_VIEW_RAD, first_look, select_points
from server.viewer.wakened import wake_pages

Colour = tuple[int, int, int]

STEEL, LOAD, SOLID, ZONE, GHOST, PATH, NEAR, THROW = (
    (120, 126, 132), (70, 110, 150), (168, 172, 176), (214, 164, 40), (150, 156, 162), (60, 90, 130), (190, 120, 20), (176, 70, 40),
)  # fmt: skip
"""Grey ground; colour for what is to be minded."""
INK: Colour = (20, 24, 27)
SKY, GROUND, LAMP = (255, 255, 255), (120, 126, 132), (1.5, -3.0, 4.0)
LOAD_OPACITY, ZONE_OPACITY = 0.6, 0.35
ARROW_S = 1.5
"""Length of the arrow that shows where the load would fly, as time at its speed."""


def open_server() -> viser.ViserServer:
    """A viser server that nobody outside reaches, and that cannot be asked for a public tunnel."""
    wake_pages()
    server = viser.ViserServer(host="127.0.0.1", port=0, label="Heft", verbose=False)
    for message in (messages.ShareUrlRequest, messages.ShareUrlDisconnect):
        server._websock_server.unregister_handler(message)
    server.scene.set_up_direction("+z")
    # light from an environment takes a tablet without a graphics card seconds to work out, and with shadows each frame four times as long
    server.scene.configure_environment_map(None)
    server.scene.configure_default_lights(enabled=False)
    server.scene.add_light_hemisphere("/lights/sky", sky_color=SKY, ground_color=GROUND, intensity=2.6)
    server.scene.add_light_directional("/lights/lamp", intensity=1.4, cast_shadow=False, position=LAMP)
    server.gui.configure_theme(control_width="small", show_logo=False, show_share_button=False)
    server.gui.main_panel.minimize()
    return server


class Thing(NamedTuple):
    """What stands in the cell as it is drawn.

    Args:
        node: its name in the scene.
    """

    node: str
    faces: Faces
    colour: Colour
    opacity: float


def _parts(group: str, name: str, standing: dict[str, list[Faces]]) -> list[tuple[str, Faces]]:
    """Node and faces of each body of something that stands there: of a mesh several, none of them in another."""
    return [(f"/{group}/{name}{f'.{k}' if k else ''}", faces) for k, faces in enumerate(standing[name])]


class ViewerScene:
    """One cell on one viser server."""

    def __init__(self, server: viser.ViserServer, cell: Cell) -> None:
        self._server, self.cell = server, cell
        self.robot = RobotModel.of_cell(cell)
        self._parts = arm_parts(cell, self.robot)
        self._corners = [(joint, np.concatenate(faces)) for joint, faces in self._parts if faces]
        self._q = np.array(cell.robot.home_rad)
        self._planned: list[Array] = []
        server.scene.add_grid("/floor", width=4.0, height=4.0, position=(0.0, 0.0, cell.floor_z_m))
        self._bodies: dict[str, viser.MeshHandle] = {}
        standing = standing_faces(cell)
        self._obstacles = [Thing(*each, SOLID, 1.0) for item in cell.obstacles for each in _parts("obstacles", item.name, standing)]
        for obstacle in self._obstacles:
            self._mesh(*obstacle)
        self.things = self._obstacles
        self.show_zones(cell)
        self._frames = self.draw_arm(server.scene, "/robot", STEEL, 1.0)
        for name, box in tool_boxes(cell).items():
            self._mesh(f"{self.last_joint}/tool-{name}", self.carry(box), STEEL, LOAD_OPACITY)
        self.show_payload_box(cell.payload_box)
        self.move(self._q, None)
        server.initial_camera.position, server.initial_camera.look_at = first_look(cell, self.robot)
        server.initial_camera.fov = FIELD_OF_VIEW_RAD

    @property
    def last_joint(self) -> str:
        """The name in the scene of what carries the payload."""
        return f"/robot/{self.robot.n}"

    def show_zones(self, cell: Cell) -> None:
        """The protected zones as they are now."""
        self.cell = cell
        standing = standing_faces(cell)
        zones = [Thing(*each, ZONE, ZONE_OPACITY) for zone in cell.zones for each in _parts("zones", zone.name, standing)]
        for gone in {thing.node for thing in self.things[len(self._obstacles) :]} - {zone.node for zone in zones}:
            self._bodies.pop(gone).remove()
        for zone in zones:
            self._mesh(*zone)
        self.things = [*self._obstacles, *zones]

    def show_payload_box(self, box: Box) -> None:
        """What certainly contains the payload."""
        self.payload_box = box
        self._mesh(f"{self.last_joint}/payload", self.carry(box), LOAD, LOAD_OPACITY)

    def carry(self, box: Box) -> Faces:
        """The faces of a box in the sensor frame, in the frame of the last joint."""
        home = np.array(self.cell.robot.home_rad)
        sensor = self.robot.sensor_pose(home)
        rotation, position = joint_poses(self.robot, home)[-1]
        return [(face @ sensor.rotation.T + sensor.position - position) @ rotation for face in shape_faces(box)]

    def show_plan(self, plan: RunPlan | None) -> None:
        """Start configurations as ghosts, and the way of the sensor between them; nothing of any plan where there is none."""
        self._server.scene.remove_by_name("/plan")
        self._planned = [] if plan is None else [np.array(pose.q_rad) for pose in plan.summary.poses]
        if plan is None:
            return
        for pose in plan.summary.poses:
            if pose.rotation_s is not None:
                self.place(self.draw_arm(self._server.scene, f"/plan/{pose.axis[0]}", GHOST, 0.2), np.array(pose.q_rad))
        ways = [self.robot.sensor_poses(np.array(path.q_rad)).position for path in plan.paths]
        segments = np.concatenate([np.stack(pair) for way in ways for pair in pairwise(way)]).reshape(-1, 2, 3)
        self._server.scene.add_line_segments("/plan/path", segments, PATH, thickness=0.004)
        for throw in plan.throws:
            self._show_throw(throw)

    def move(self, q: Array, nearest: NearestPart | None) -> None:
        """The robot at q (n,), and the line of the smallest distance, where that is known."""
        self._q = q
        with self._server.atomic():
            self.place(self._frames, q)
            if nearest is None:
                self._server.scene.remove_by_name("/nearest")
                return
            ends = np.array([[nearest.point_first_m, nearest.point_second_m]])
            self._server.scene.add_line_segments("/nearest/line", ends, NEAR, thickness=0.006)
            self._server.scene.add_label("/nearest/label", nearest.second, position=tuple(ends[0].mean(axis=0)))

    def find_points(self, q: Array | None = None) -> Array:
        """Corners (k, 3) of the arm where it is, or at q (n,), world frame."""
        poses = joint_poses(self.robot, self._q if q is None else q)
        placed = [corners @ poses[joint][0].T + poses[joint][1] for joint, corners in self._corners]
        return select_points(np.concatenate(placed))

    def find_room(self, box: Box) -> Array:
        """Corners (k, 3) of all that is drawn of the robot with a box: where it is, and where the plan has it stand, world frame."""
        places = [self._q, *self._planned]
        return np.concatenate([points for q in places for points in (self.find_points(q), self.find_box_corners(box, q))])

    def find_box_corners(self, box: Box, q: Array | None = None) -> Array:
        """Corners (8, 3) of a box in the sensor frame where the robot is, or at q (n,), world frame."""
        sensor = self.robot.sensor_pose(self._q if q is None else q)
        return np.asarray(box.corners @ sensor.rotation.T + sensor.position)

    def _show_throw(self, throw: ThrowPart) -> None:
        """An arrow from where the load would fly off to where it would be some seconds later without gravity; past which zone."""
        begin = np.array(throw.point_m)
        end = begin + ARROW_S * np.array(throw.velocity_m_s)
        name = f"/plan/throw/{throw.axis[0]}"
        if throw.speed_m_s > 0.0:
            self._server.scene.add_arrows(
                f"{name}/arrow", np.array([[begin, end]]), THROW, shaft_radius=0.006, head_radius=0.016, head_length=0.04
            )
        self._server.scene.add_label(f"{name}/label", f"{throw.axis} → {throw.zone}", position=tuple(end))

    def draw_arm(self, scene: viser.SceneApi, root: str, colour: Colour, opacity: float) -> list[viser.FrameHandle]:
        """Frames of the joints with the bodies in them; the frames are what moves."""
        return draw_parts(scene, root, self._parts, self.robot.n, colour, opacity)

    def place(self, frames: Sequence[viser.FrameHandle], q: Array) -> None:
        """Moves the frames of an arm to q (n,)."""
        for frame, (rotation, position) in zip(frames, joint_poses(self.robot, q), strict=True):
            frame.wxyz = Rotation.from_matrix(rotation).as_quat(scalar_first=True)
            frame.position = position

    def set_visible(self, node: str, *, visible: bool) -> None:
        """Whether an obstacle or a zone is seen."""
        for name, body in self._bodies.items():
            if name == node or name.startswith(f"{node}."):
                body.visible = visible

    def _mesh(self, name: str, faces: Faces, colour: Colour, opacity: float = 1.0) -> None:
        self._bodies[name] = add_body(self._server.scene, name, faces, colour, opacity)


def draw_parts(
    scene: viser.SceneApi, root: str, parts: Sequence[Part], joints: int, colour: Colour, opacity: float
) -> list[viser.FrameHandle]:
    """Bodies of the robot in frames of their joints, the base's among them."""
    frames = [scene.add_frame(f"{root}/{joint}", show_axes=False) for joint in range(joints + 1)]
    for k, (joint, faces) in enumerate(parts):
        add_body(scene, f"{root}/{joint}/body{k}", faces, colour, opacity)
    return frames


def add_body(scene: viser.SceneApi, name: str, faces: Faces, colour: Colour, opacity: float = 1.0) -> viser.MeshHandle:
    """A body of convex faces, or another one in place of that of the same name."""
    corners, triangles = triangles_of(faces)
    shown = None if opacity == 1.0 else opacity
    return scene.add_mesh_simple(name, corners, triangles, color=colour, opacity=shown, flat_shading=True, side="double")


def triangles_of(faces: Faces) -> tuple[Array, NDArray[np.int32]]:
    """Corners (k, 3) and triangles (m, 3) of convex faces."""
    starts = np.cumsum([0, *(len(face) for face in faces)])
    fans = [[start, start + i, start + i + 1] for start, face in zip(starts, faces, strict=False) for i in range(1, len(face) - 1)]
    return np.concatenate(faces), np.array(fans, dtype=np.int32)
