"""The text of a robot's description: a URDF as it is, a xacro file expanded in a process of its own."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

from pydantic import ValidationError

from core.cell.urdf_elements import MAX_BYTES
from core.errors import BadRobot
from core.files.jail import read_inside
from core.new_cell.packages import Packages
from core.words.message import Message

CHILD = Path(__file__).with_name("xacro_child.py")
SECONDS = 30.0
UNWANTED = 3
MOST_LETTERS = 300
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
        raise BadRobot(str(file), "xacro-declaration")
    if file.suffix != ".xacro" and not _IS_XACRO.search(text):
        if arguments:
            raise BadRobot(str(file), "xacro-arguments-of-urdf")
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
        raise BadRobot(str(file), "xacro-too-slow", limit_s=SECONDS) from error
    if done.returncode == UNWANTED:
        raise BadRobot(str(file), "xacro-unwanted", wanted=_read_wanted(done.stderr))
    if done.returncode != 0:
        why = done.stderr.strip().splitlines()
        if not why:
            raise BadRobot(str(file), "xacro-ended", status=done.returncode)
        raise BadRobot(str(file), "xacro-not-expanded", reason=why[-1][:MOST_LETTERS])
    return done.stdout


def _read_wanted(said: str) -> Message:
    """What the process says last: the message that it refused with."""
    last = said.strip().rpartition("\n")[2]
    try:
        return Message.model_validate_json(last)
    except ValidationError:
        return Message.of("text", text=last[:MOST_LETTERS])


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
