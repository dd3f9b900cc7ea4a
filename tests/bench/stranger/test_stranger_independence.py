"""`bench.stranger` and the four after it: what makes the recordings shares no code with what is tried on them."""

from __future__ import annotations

import ast
from pathlib import Path
from types import ModuleType

import pytest

import bench.fifth_stranger
import bench.fourth_stranger
import bench.second_stranger
import bench.stranger
import bench.third_stranger

TRIES = ("diagnosing", "sets", "__main__")
"""Of `bench.stranger`: what diagnoses, and the command."""
BORROWS_FROM = {
    "bench.third_stranger": ("bench.second_stranger.",),
    "bench.fourth_stranger": ("bench.second_stranger.",),
    "bench.fifth_stranger": ("bench.second_stranger.", "bench.fourth_stranger."),
}
"""Whose bodies, kinematics and measures a stranger has as well."""


def list_imports(path: Path) -> set[str]:
    nodes = list(ast.walk(ast.parse(path.read_text())))
    named = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return named | {node.module or "." for node in nodes if isinstance(node, ast.ImportFrom)}


STRANGERS = (bench.stranger, bench.second_stranger, bench.third_stranger, bench.fourth_stranger, bench.fifth_stranger)


@pytest.mark.parametrize("package", STRANGERS, ids=lambda package: package.__name__)
def test_nothing_of_this_project_but_the_strangers_takes_part_in_making_recordings(package: ModuleType) -> None:
    own = (f"{package.__name__}.", *BORROWS_FROM.get(package.__name__, ()))
    tries = {f"bench.stranger.{name}" for name in TRIES}
    for path in Path(str(package.__file__)).parent.rglob("*.py"):
        if f"{package.__name__}.{path.stem}" not in tries:
            ours = {name for name in list_imports(path) if name.split(".")[0] in ("core", "server", "tests", "bench", ".")}
            assert all(name.startswith(own) and name not in tries for name in ours), path
