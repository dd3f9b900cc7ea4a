"""`bench.stranger` and `bench.second_stranger`: what makes the recordings shares no code with what is tried on them."""

from __future__ import annotations

import ast
from pathlib import Path
from types import ModuleType

import pytest

import bench.second_stranger
import bench.stranger

TRIES = ("diagnosing", "sets", "__main__")
"""Of `bench.stranger`: what diagnoses, and the command."""


def list_imports(path: Path) -> set[str]:
    nodes = list(ast.walk(ast.parse(path.read_text())))
    named = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return named | {node.module or "." for node in nodes if isinstance(node, ast.ImportFrom)}


@pytest.mark.parametrize("package", [bench.stranger, bench.second_stranger], ids=lambda package: package.__name__)
def test_nothing_of_this_project_but_the_folder_itself_takes_part_in_making_recordings(package: ModuleType) -> None:
    tries = {f"bench.stranger.{name}" for name in TRIES}
    for path in Path(str(package.__file__)).parent.rglob("*.py"):
        if f"{package.__name__}.{path.stem}" not in tries:
            ours = {name for name in list_imports(path) if name.split(".")[0] in ("core", "server", "tests", "bench", ".")}
            assert all(name.startswith(f"{package.__name__}.") and name not in tries for name in ours), path
