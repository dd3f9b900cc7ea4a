"""Reads a URDF as the untrusted file that it is, before Pinocchio or MuJoCo sees it.

`check_urdf` holds for every URDF: it parses, it is one tree, its numbers are numbers. What only a chain of moving joints
needs is asked by `Urdf.chain`, what only a simulated cell needs by `Urdf.check_bodies` and `Urdf.check_meshes`: the URDF
of a recording may name meshes that nobody loads, and may leave out masses that nobody uses.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

import numpy as np

from core.cell.urdf_elements import LIMITS, UrdfJoint, UrdfLink, check_elements, parse, read_joint, read_link
from core.errors import BadRobot
from core.files.jail import find_inside

MAX_MESH_BYTES = 50_000_000
MAX_ANGLE = 4 * np.pi  # rad; a larger joint limit is in degrees
ROUNDING = 1e-6  # relative, of the triangle inequality: values are written with six digits


@dataclass(frozen=True)
class Hinge:
    """A revolute joint with limits: what the procedure can move.

    Args:
        child: the link that it moves.
        lower, upper: rad. velocity: rad/s.
    """

    name: str
    child: str
    lower: float
    upper: float
    velocity: float


@dataclass(frozen=True)
class Urdf:
    """A checked URDF: one tree of links and joints."""

    where: str
    bodies: tuple[UrdfLink, ...]
    joints: tuple[UrdfJoint, ...]
    meshes: tuple[str, ...]

    @property
    def links(self) -> tuple[str, ...]:
        """Names of the links."""
        return tuple(body.name for body in self.bodies)

    def chain(self, base: str, tip: str) -> tuple[str, ...]:
        """Names of the moving joints from link `base` to link `tip`, in order; each is a hinge with limits.

        Raises:
            BadRobot: a frame is unknown, the tip is not reached, or a joint between them is no hinge with limits.
        """
        return tuple(joint.name for joint in self.hinges(base, tip))

    def hinges(self, base: str, tip: str) -> tuple[Hinge, ...]:
        """The joints named by `chain`.

        Raises:
            BadRobot: as `chain`.
        """
        parent_joint = {joint.child: joint for joint in self.joints}
        for frame in (base, tip):
            if frame not in self.links:
                raise BadRobot(f"{self.where}: frame", repr(frame), f"one of the links {list(self.links)}")
        moving: list[UrdfJoint] = []
        link = tip
        while link != base:
            joint = parent_joint.get(link)
            if joint is None:
                raise BadRobot(f"{self.where}: frame {tip!r}", f"no chain of joints from {base!r} to it", "one")
            if joint.kind != "fixed":
                moving.insert(0, joint)
            link = joint.parent
        if not moving:
            raise BadRobot(f"{self.where}: frame {tip!r}", f"no moving joint between {base!r} and it", "at least one")
        return tuple(_hinge(joint, f"{self.where}: joint {joint.name!r}") for joint in moving)

    def check_bodies(self, base: str, tip: str) -> None:
        """Every moving link between the two frames is a body that can exist.

        Raises:
            BadRobot: no mass or zero, an inertia not positive definite or against the triangle inequality.
        """
        bodies = {body.name: body for body in self.bodies}
        for joint in self.hinges(base, tip):
            _check_body(bodies[joint.child], f"{self.where}: link {joint.child!r}")

    def find_moving_links(self, base: str, tip: str) -> tuple[UrdfLink, ...]:
        """The links that the joints of the chain move: those of the chain and all that is carried by them.

        Raises:
            BadRobot: as `hinges`.
        """
        names = set(_descendants(self, self.hinges(base, tip)[0].child))
        return tuple(body for body in self.bodies if body.name in names)

    def check_shapes(self, base: str, tip: str, visual_shapes: Collection[str]) -> None:
        """Every link that moves has a shape that something can run into; links without mass and looks are frames and need none.

        One that has mass and no looks may be inside another that is fixed to it and has a shape.

        Args:
            visual_shapes: links whose looks may count as their shape.

        Raises:
            BadRobot: one has none.
        """
        for body in self.find_moving_links(base, tip):
            if self._has_shaped_neighbour(body.name) and not body.visual:
                continue
            if body.collision or (body.name in visual_shapes and body.visual) or not (body.mass or body.visual):
                continue
            looks = f"<collision>, or {body.name!r} in robot.visual_shapes of cell.toml, where its looks are to count"
            expected = looks if body.visual else "<collision>, or neither mass nor shape where it is only a frame"
            raise BadRobot(f"{self.where}: link {body.name!r}", "a link that moves without a shape for collisions", expected)

    def _has_shaped_neighbour(self, name: str) -> bool:
        """Whether a link that is fixed to this one, directly, has a shape that something can run into."""
        fixed = [joint for joint in self.joints if joint.kind == "fixed" and name in (joint.parent, joint.child)]
        shaped = {body.name for body in self.bodies if body.collision}
        return any({joint.parent, joint.child} & shaped - {name} for joint in fixed)

    def check_meshes(self, folder: Path) -> None:
        """Every mesh is a file inside the folder, named by a relative path.

        Raises:
            BadRobot: an absolute path, a URL such as package://, a path that leads outside, or no such file.
        """
        for name in self.meshes:
            where = f"{self.where}: mesh"
            if "://" in name or "\\" in name or PurePosixPath(name).is_absolute():
                raise BadRobot(where, repr(name), "a path relative to the URDF, inside its folder")
            find_inside(folder, name, BadRobot, max_bytes=MAX_MESH_BYTES, where=where)


def check_urdf(text: str, where: str) -> Urdf:
    """Checks a URDF's text.

    Args:
        where: the file, for the sentence.

    Raises:
        BadRobot: not XML, document types or entities, no tree, duplicate names, malformed
            numbers, negative sizes or masses.
    """
    root = parse(text, where)
    check_elements(root, where)
    bodies = tuple(read_link(link, where) for link in root.findall("link"))
    joints = tuple(read_joint(joint, where) for joint in root.findall("joint"))
    urdf = Urdf(where, bodies, joints, tuple(mesh.get("filename", "") for mesh in root.iter("mesh")))
    for rule in (_names_are_unique, _joints_have_links, _is_one_tree):
        rule(urdf)
    return urdf


def _hinge(joint: UrdfJoint, where: str) -> Hinge:
    """What the procedure needs of every joint that it moves."""
    if joint.kind == "continuous":
        raise BadRobot(where, "a joint without limits (continuous)", "a revolute joint with lower, upper and velocity limits")
    if joint.kind != "revolute" or joint.mimic:
        raise BadRobot(
            where,
            "a joint that mimics another" if joint.mimic else f"the type {joint.kind!r}",
            "a revolute joint of its own",
        )
    if np.linalg.norm(joint.axis) < 1e-6:
        raise BadRobot(f"{where}: axis", str(joint.axis.tolist()), "a direction")
    lower, upper, velocity = joint.lower, joint.upper, joint.velocity
    if lower is None or upper is None or velocity is None or joint.effort is None:
        missing = next(key for key in LIMITS if getattr(joint, key) is None)
        raise BadRobot(f"{where}: limit", f"no {missing}", "lower, upper, velocity and effort limits")
    if not -MAX_ANGLE <= lower < upper <= MAX_ANGLE:
        raise BadRobot(f"{where}: limit", f"lower {lower:g}, upper {upper:g}", f"lower < upper within +-{MAX_ANGLE:.2f} rad")
    if velocity <= 0:
        raise BadRobot(f"{where}: limit", f"velocity {velocity:g}", "a positive velocity in rad/s")
    return Hinge(joint.name, joint.child, lower, upper, velocity)


def _check_body(body: UrdfLink, where: str) -> None:
    if body.mass is None or body.inertia is None:
        raise BadRobot(where, "no inertial", "mass and inertia of a link that moves")
    if body.mass <= 0:
        raise BadRobot(f"{where}: mass", f"{body.mass:g} kg", "a positive mass of a link that moves")
    moments = np.linalg.eigvalsh(body.inertia)
    if moments[0] <= 0:
        raise BadRobot(f"{where}: inertia", f"a principal moment of {moments[0]:.3g} kg m2", "a positive definite inertia")
    if moments[2] > (moments[0] + moments[1]) * (1 + ROUNDING):
        found = f"principal moments {moments[0]:.4g}, {moments[1]:.4g}, {moments[2]:.4g} kg m2"
        raise BadRobot(f"{where}: inertia", found, "none larger than the sum of the other two")


def _names_are_unique(urdf: Urdf) -> None:
    for kind, names in (("link", urdf.links), ("joint", tuple(joint.name for joint in urdf.joints))):
        name, count = Counter(names).most_common(1)[0] if names else ("", 0)
        if count > 1:
            raise BadRobot(f"{urdf.where}: {kind} {name!r}", f"{count} of that name", "one")
        if "" in names:
            raise BadRobot(f"{urdf.where}: {kind}", "one without a name", "a name")


def _joints_have_links(urdf: Urdf) -> None:
    for joint in urdf.joints:
        for key in ("parent", "child"):
            if getattr(joint, key) not in urdf.links:
                raise BadRobot(f"{urdf.where}: joint {joint.name!r}: {key}", repr(getattr(joint, key)), "a link of the URDF")


def _is_one_tree(urdf: Urdf) -> None:
    children = Counter(joint.child for joint in urdf.joints)
    for link, count in children.items():
        if count > 1:
            raise BadRobot(f"{urdf.where}: link {link!r}", f"{count} joints that carry it", "one")
    roots = [link for link in urdf.links if link not in children]
    if len(roots) != 1:
        found = f"the roots {roots}" if roots else "a cycle of joints" if urdf.joints else "no link"
        raise BadRobot(urdf.where, found, "one tree with one root link")
    reached = set(_descendants(urdf, roots[0]))
    lost = [link for link in urdf.links if link not in reached]
    if lost:
        raise BadRobot(f"{urdf.where}: link {lost[0]!r}", "a cycle of joints", f"a chain from the root link {roots[0]!r}")


def _descendants(urdf: Urdf, root: str) -> Iterator[str]:
    open_links = [root]
    below: dict[str, list[str]] = {}
    for joint in urdf.joints:
        below.setdefault(joint.parent, []).append(joint.child)
    while open_links:
        link = open_links.pop()
        yield link
        open_links += below.get(link, [])
