"""The formula -> code -> test table of the README is kept true."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
ROW = re.compile(r"^\| (?P<what>[^|]+) \| (?P<code>`core/[^|]+) \| (?P<test>`tests/[^|]+) \|$", re.MULTILINE)
PLACE = re.compile(r"`([\w/.]+):(\w+)`")
ROWS = [match.groupdict() for match in ROW.finditer((ROOT / "README.md").read_text(encoding="utf-8"))]


def names_in(file: Path) -> set[str]:
    """Functions, classes, methods and module constants of a file."""
    names: set[str] = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.Assign):
            names |= {target.id for target in node.targets if isinstance(target, ast.Name)}
    return names


@pytest.mark.parametrize("row", ROWS, ids=[row["what"] for row in ROWS])
def test_every_formula_points_to_code_and_tests_that_exist(row):
    for column in ("code", "test"):
        places = PLACE.findall(row[column])
        assert places, f"{row['what']}: no place in {row[column]!r}"
        for path, name in places:
            assert name in names_in(ROOT / path), f"{path} has no {name}"


def test_no_equation_algorithm_or_table_of_the_paper_is_left_out():
    text = " ".join(row["what"] for row in ROWS)
    numbers = {kind: set(map(int, re.findall(rf"{kind} (\d+)", text))) for kind in ("Eq.", "Algorithm", "Table")}
    assert numbers["Eq."] == set(range(1, 11))
    assert numbers["Algorithm"] == set(range(1, 9))
    assert numbers["Table"] == {1, 2, 3}
