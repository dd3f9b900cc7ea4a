"""The text of a robot's description: a URDF as it is, a xacro file expanded in a process of its own."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

from core.cell.urdf_elements import MAX_BYTES
from core.errors import BadRobot
from core.files.jail import read_inside
from core.new_cell.packages import Packages

CHILD = Path(__file__).with_name("xacro_child.py")
SECONDS = 30.0
UNWANTED = 3
MOST_FILES = 1000
"""Of a package that are looked through for further packages."""

_FIND = re.compile(r"\$\(find\s+([^)\s]+)\s*\)|package://([^/\"'\s]+)")
_IS_XACRO = re.compile(r"<xacro:|xmlns:xacro\s*=")


def description_text(packages: Packages, arguments: dict[str, str]) -> str:
    """The URDF's text, expanded where it is xacro.

    Raises:
        BadRobot: it cannot be read, or a xacro file that does not expand or wants what it may not have.
    """
    file = packages.description
    text = read_inside(packages.beside, file.name, BadRobot, max_bytes=MAX_BYTES, where=str(file))
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise BadRobot(str(file), "a document type or an entity", "a URDF or xacro file without them")
    if file.suffix != ".xacro" and not _IS_XACRO.search(text):
        if arguments:
            raise BadRobot(str(file), "a plain URDF with --xacro-arg", "a xacro file, or none of these arguments")
        return text
    return _expand(packages, arguments)


def _expand(packages: Packages, arguments: dict[str, str]) -> str:
    file = packages.description
    order = {
        "file": str(packages.beside / file.name),
        "packages": {name: str(packages.folder(name)) for name in _find_named_packages(packages)},
        "arguments": arguments,
        "folders": [str(folder) for folder in packages.open_folders],
    }
    command = [sys.executable, "-I", "-B", str(CHILD)]
    try:
        done = subprocess.run(command, input=json.dumps(order), capture_output=True, text=True, timeout=SECONDS, env={}, check=False)
    except subprocess.TimeoutExpired as error:
        raise BadRobot(str(file), f"xacro that is not expanded after {SECONDS:.0f} s", "a xacro file that ends") from error
    if done.returncode == UNWANTED:
        raise BadRobot(str(file), f"xacro that wants {done.stderr}", "no $(eval ...); files in its folder or a --package-path DIR")
    if done.returncode != 0:
        why = done.stderr.strip().splitlines()[-1:] or [f"the process ended with {done.returncode}: time or memory"]
        raise BadRobot(str(file), f"xacro that does not expand ({why[0][:300]})", "xacro, its arguments given as --xacro-arg NAME:=VALUE")
    return done.stdout


def _find_named_packages(packages: Packages) -> list[str]:
    """Packages that the file and what lies in the packages found so far name; unknown ones are left to whoever uses them."""
    known: list[str] = []
    read: set[Path] = set()
    waiting = [packages.beside / packages.description.name]
    while waiting:
        file = waiting.pop()
        read.add(file)
        try:
            text = file.read_text(encoding="utf-8") if file.stat().st_size <= MAX_BYTES else ""
        except (OSError, UnicodeDecodeError):
            text = ""  # not a file to be looked through; xacro says so where it includes it
        for name in {first or second for first, second in _FIND.findall(text)} - set(known):
            if name.startswith("$"):
                continue
            try:
                folder = packages.folder(name)
            except BadRobot:
                continue
            known.append(name)
            files = (each.resolve() for each in sorted(folder.rglob("*.xacro"))[:MOST_FILES])
            waiting += [each for each in files if each not in read and each.is_relative_to(folder)]
    return known
