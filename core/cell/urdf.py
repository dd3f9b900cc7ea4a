"""Reads a URDF as the untrusted file that it is, before Pinocchio or MuJoCo sees it.

`check_urdf` holds for every URDF: it parses, it is one tree, its numbers are numbers. What only a chain of moving joints
needs is asked by `Urdf.chain`, what only a simulated cell needs by `Urdf.check_bodies` and `Urdf.check_meshes`: the URDF
of a recording may name meshes that nobody loads, and may leave out masses that nobody uses.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePosixPath

import numpy as np

from core.cell.urdf_elements import LIMITS, UrdfJoint, UrdfLink, check_elements, parse, read_joint, read_link
from core.errors import BadInput, BadRobot
from core.files.jail import find_inside
from core.words.message import Message

MAX_MESH_BYTES = 50_000_000
MAX_LINKS = 1000  # a humanoid with hands has some hundred
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
                raise BadRobot(Message.of("description-frame", file=self.where), "description-unknown-frame", frame=frame, links=self.links)
        where = Message.of("description-named-frame", file=self.where, frame=tip)
        moving: list[UrdfJoint] = []
        link = tip
        while link != base:
            joint = parent_joint.get(link)
            if joint is None:
                raise BadRobot(where, "description-no-chain", base=base)
            if joint.kind != "fixed":
                moving.insert(0, joint)
            link = joint.parent
        if not moving:
            raise BadRobot(where, "description-no-moving-joint", base=base)
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
            where = f"{self.where}: link {body.name!r}"
            if body.visual:
                raise BadRobot(where, "description-link-only-looks", link=body.name)
            raise BadRobot(where, "description-link-without-shape")

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
            check_mesh_file(folder, name, f"{self.where}: mesh", BadRobot)


def check_mesh_file(folder: Path, name: str, where: str, refusal: type[BadInput]) -> None:
    """A mesh is a file inside the folder, named by a relative path.

    Raises:
        BadInput: of the given kind: it is not.
    """
    if "://" in name or "\\" in name or PurePosixPath(name).is_absolute():
        raise refusal(where, "description-mesh-elsewhere", name=name)
    find_inside(folder, name, refusal, max_bytes=MAX_MESH_BYTES, where=where)


@lru_cache(maxsize=8)
def check_urdf(text: str, where: str) -> Urdf:
    """Checks a URDF's text.

    Args:
        where: the file, for the sentence.

    Raises:
        BadRobot: not XML, document types or entities, no tree, duplicate names, malformed
            numbers, negative sizes or masses, more than `MAX_LINKS` links.
    """
    root = parse(text, where)
    links = root.findall("link")
    if len(links) > MAX_LINKS:
        raise BadRobot(where, "description-too-many-links", links=len(links), most=MAX_LINKS)
    check_elements(root, where)
    bodies = tuple(read_link(link, where) for link in links)
    joints = tuple(read_joint(joint, where) for joint in root.findall("joint"))
    urdf = Urdf(where, bodies, joints, tuple(mesh.get("filename", "") for mesh in root.iter("mesh")))
    for rule in (_names_are_unique, _joints_have_links, _is_one_tree):
        rule(urdf)
    return urdf


def _hinge(joint: UrdfJoint, where: str) -> Hinge:
    """What the procedure needs of every joint that it moves."""
    if joint.kind == "continuous":
        raise BadRobot(where, "description-joint-without-limits")
    if joint.mimic:
        raise BadRobot(where, "description-joint-mimics")
    if joint.kind != "revolute":
        raise BadRobot(where, "description-joint-not-revolute", type=joint.kind)
    if np.linalg.norm(joint.axis) < 1e-6:
        raise BadRobot(f"{where}: axis", "description-axis", axis=joint.axis.tolist())
    lower, upper, velocity = joint.lower, joint.upper, joint.velocity
    if lower is None or upper is None or velocity is None or joint.effort is None:
        missing = next(key for key in LIMITS if getattr(joint, key) is None)
        raise BadRobot(f"{where}: limit", "description-limit-missing", key=missing, keys=LIMITS)
    if not -MAX_ANGLE <= lower < upper <= MAX_ANGLE:
        raise BadRobot(f"{where}: limit", "description-limits", lower_rad=lower, upper_rad=upper, most_rad=MAX_ANGLE)
    if velocity <= 0:
        raise BadRobot(f"{where}: limit", "description-velocity", velocity_rad_s=velocity)
    return Hinge(joint.name, joint.child, lower, upper, velocity)


def _check_body(body: UrdfLink, where: str) -> None:
    if body.mass is None or body.inertia is None:
        raise BadRobot(where, "description-without-inertial")
    if body.mass <= 0:
        raise BadRobot(f"{where}: mass", "description-massless", mass_kg=body.mass)
    moments = np.linalg.eigvalsh(body.inertia)
    if moments[0] <= 0:
        raise BadRobot(f"{where}: inertia", "description-inertia-not-definite", moment_kg_m2=moments[0])
    if moments[2] > (moments[0] + moments[1]) * (1 + ROUNDING):
        least, middle, most = moments
        raise BadRobot(f"{where}: inertia", "description-inertia-of-none", least_kg_m2=least, middle_kg_m2=middle, most_kg_m2=most)


def _names_are_unique(urdf: Urdf) -> None:
    for kind, names in (("link", urdf.links), ("joint", tuple(joint.name for joint in urdf.joints))):
        name, count = Counter(names).most_common(1)[0] if names else ("", 0)
        if count > 1:
            raise BadRobot(f"{urdf.where}: {kind} {name!r}", "description-name-twice", count=count)
        if "" in names:
            raise BadRobot(f"{urdf.where}: {kind}", "description-nameless")


def _joints_have_links(urdf: Urdf) -> None:
    links = set(urdf.links)
    for joint in urdf.joints:
        for key in ("parent", "child"):
            if getattr(joint, key) not in links:
                raise BadRobot(f"{urdf.where}: joint {joint.name!r}: {key}", "description-unknown-link", link=getattr(joint, key))


def _is_one_tree(urdf: Urdf) -> None:
    children = Counter(joint.child for joint in urdf.joints)
    for link, count in children.items():
        if count > 1:
            raise BadRobot(f"{urdf.where}: link {link!r}", "description-carried-twice", count=count)
    roots = [link for link in urdf.links if link not in children]
    if len(roots) > 1:
        raise BadRobot(urdf.where, "description-several-roots", roots=roots)
    if not roots:
        raise BadRobot(urdf.where, "description-all-a-cycle" if urdf.joints else "description-without-links")
    reached = set(_descendants(urdf, roots[0]))
    lost = [link for link in urdf.links if link not in reached]
    if lost:
        raise BadRobot(f"{urdf.where}: link {lost[0]!r}", "description-link-in-cycle", root=roots[0])


def _descendants(urdf: Urdf, root: str) -> Iterator[str]:
    open_links = [root]
    below: dict[str, list[str]] = {}
    for joint in urdf.joints:
        below.setdefault(joint.parent, []).append(joint.child)
    while open_links:
        link = open_links.pop()
        yield link
        open_links += below.get(link, [])
