"""Where the files are that a robot's description names: in ROS packages and beside it, and nowhere else.

What may be read are the description's own folder, the folders that were given, and ROS packages beside or above the description. A
description is untrusted: its names choose among these folders and never lead beyond them. `package://etc/passwd` finds nothing, since
what was not given is a package only if it has a `package.xml` or is one of the folders right above the description.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from core.errors import BadRobot
from core.files.jail import find_inside
from core.words.message import Message

PACKAGE = re.compile(r"[A-Za-z0-9_.-]{1,128}", re.ASCII)
SCHEMES = ("package://", "model://")
NEAR = 3
"""Folders above a description's own that may be its package without saying so."""


class Packages:
    """Files that a description names.

    Args:
        description: the URDF or xacro file.
        given: folders with packages, or packages themselves.
    """

    def __init__(self, description: Path, given: tuple[Path, ...] = ()) -> None:
        self.description = description
        self.beside = description.resolve().parent
        self._given = tuple(path.resolve() for path in given)
        self._found: dict[str, Path] = {}

    @property
    def open_folders(self) -> tuple[Path, ...]:
        """All that may be read: the description's folder, the given ones, the packages found so far."""
        return tuple(dict.fromkeys((self.beside, *self._given, *self._found.values())))

    def folder(self, name: str) -> Path:
        """Folder of a package.

        Raises:
            BadRobot: no such package in the given folders or on the way up from the description.
        """
        if name not in self._found:
            where = Message.of("newcell-package", file=str(self.description), name=name)
            if not PACKAGE.fullmatch(name) or set(name) == {"."}:
                raise BadRobot(where, "newcell-no-package-name")
            found = next(self._places(name), None)
            if found is None:
                raise BadRobot(where, "newcell-no-such-package", folders=[str(path) for path in (*self._given, self.beside)])
            self._found[name] = found.resolve()
        return self._found[name]

    def _places(self, name: str) -> Iterator[Path]:
        for given in self._given:
            yield from (place for place in (given / name, given) if place.name == name and place.is_dir())
        above = (self.beside, *self.beside.parents)
        for level, folder in enumerate(above[:-2]):  # neither the root of all files nor what lies directly in it
            if folder.name == name and (level <= NEAR or (folder / "package.xml").is_file()):
                yield folder
            if (folder / name / "package.xml").is_file():
                yield folder / name

    def file(self, name: str, where: str, max_bytes: int) -> Path:
        """The file that a description names: `package://`, relative to the description, or inside a folder that may be read.

        Raises:
            BadRobot: it leads outside those folders, is no file, or is too large.
        """
        scheme = next((scheme for scheme in SCHEMES if name.startswith(scheme)), None)
        if scheme is not None:
            package, _, inside = unquote(name.removeprefix(scheme)).partition("/")
            return find_inside(self.folder(package), inside, BadRobot, max_bytes=max_bytes, where=where)
        plain = unquote(name.removeprefix("file://")) if name.startswith("file://") else name
        if "://" in plain or "\\" in plain or "\0" in plain:
            raise BadRobot(where, "newcell-mesh-address", name=name)
        path = (self.beside / plain).resolve()
        for folder in self.open_folders:
            if path.is_relative_to(folder):
                return find_inside(folder, str(path.relative_to(folder)), BadRobot, max_bytes=max_bytes, where=where)
        raise BadRobot(where, "newcell-mesh-outside", name=name)
