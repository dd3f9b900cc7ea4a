"""The robot's meshes, copied into the cell: each file once, under a name of its own, named by a relative path."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from core.cell.urdf import MAX_MESH_BYTES
from core.errors import BadRobot
from core.new_cell.packages import Packages
from core.new_cell.robot_tree import RobotTree
from core.words.message import Message

FOLDER = "meshes"
SUFFIXES = (".stl", ".dae", ".obj", ".ply")


def choose_shapes(tree: RobotTree, notes: list[Message]) -> tuple[str, ...]:
    """Leaves of each link the shapes that are checked: those for collisions, or its visual ones where it has no other.

    Returns:
        Names of the links that are taken from their visual shapes.
    """
    visual = []
    for link in tree.checked.links:
        shown = tree.shapes(link, "visual")
        if not shown:
            continue
        if tree.shapes(link, "collision"):
            for shape in shown:
                tree.link(link).remove(shape)
        else:
            visual.append(link)
            notes.append(Message.of("newcell-visual-taken", link=link))
    return tuple(visual)


def copy_meshes(tree: RobotTree, packages: Packages, cell: Path) -> None:
    """Copies every mesh that the description still names into `cell`/meshes and names it by that path.

    Raises:
        BadRobot: a mesh that is not found, lies where nothing may be read, or is of another kind.
    """
    copied: dict[Path, str] = {}
    for link, mesh in tree.meshes():
        name = mesh.get("filename", "")
        where = f"{tree.where}: link {link!r}: mesh"
        if Path(name).suffix.lower() not in SUFFIXES:
            raise BadRobot(where, "newcell-no-mesh", name=name, suffixes=SUFFIXES)
        file = packages.file(name, where, MAX_MESH_BYTES)
        if file not in copied:
            copied[file] = f"{FOLDER}/{_free_name(name, set(copied.values()))}"
            (cell / FOLDER).mkdir(exist_ok=True)
            shutil.copyfile(file, cell / copied[file])
        mesh.set("filename", copied[file])


def _free_name(name: str, taken: set[str]) -> str:
    """A plain name that no other mesh has, also where capitals do not count."""
    plain = Path(name.rpartition("/")[2])
    stem = re.sub(r"[^A-Za-z0-9_-]+", "_", plain.stem)[:60] or "mesh"
    lower = {each.lower() for each in taken}
    for count in range(1, len(taken) + 2):
        found = f"{stem}{'' if count == 1 else f'_{count}'}{plain.suffix.lower()}"
        if f"{FOLDER}/{found}".lower() not in lower:
            return found
    raise AssertionError("more names than meshes")
