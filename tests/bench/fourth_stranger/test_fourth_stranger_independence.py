"""`bench.fourth_stranger`: what makes the recordings shares no code with what is tried on them."""

from __future__ import annotations

import ast
from pathlib import Path

import bench.fourth_stranger

MAY_IMPORT = ("bench.fourth_stranger.", "bench.second_stranger.")


def list_imports(path: Path) -> set[str]:
    nodes = list(ast.walk(ast.parse(path.read_text())))
    named = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return named | {node.module or "." for node in nodes if isinstance(node, ast.ImportFrom)}


def test_nothing_of_this_project_but_the_strangers_takes_part_in_making_recordings() -> None:
    for path in Path(str(bench.fourth_stranger.__file__)).parent.rglob("*.py"):
        ours = {name for name in list_imports(path) if name.split(".")[0] in ("core", "server", "tests", "bench", ".")}
        assert all(f"{name}.".startswith(MAY_IMPORT) for name in ours), path
