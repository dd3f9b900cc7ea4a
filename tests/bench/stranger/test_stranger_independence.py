"""`bench.stranger`: what makes the recordings shares no code with what is tried on them."""

from __future__ import annotations

import ast
from pathlib import Path

import bench.stranger

FOLDER = Path(str(bench.stranger.__file__)).parent
TRIES = {"diagnosing.py", "__main__.py"}
"""What diagnoses, and the command."""


def list_imports(path: Path) -> set[str]:
    nodes = list(ast.walk(ast.parse(path.read_text())))
    named = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return named | {node.module or "." for node in nodes if isinstance(node, ast.ImportFrom)}


def test_nothing_of_this_project_but_the_folder_itself_takes_part_in_making_recordings() -> None:
    for path in FOLDER.rglob("*.py"):
        if path.name not in TRIES:
            ours = {name for name in list_imports(path) if name.split(".")[0] in ("core", "server", "tests", "bench", ".")}
            assert all(name.startswith("bench.stranger.") and name != "bench.stranger.diagnosing" for name in ours), path
