"""The tree in CONTRIBUTING.md is the one on the disk."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[1]
PARTS = ("core", "server", "web/src")


def folders_on_disk() -> set[str]:
    listed = subprocess.run(["git", "ls-files", *PARTS], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    inner = {str(folder) for file in listed for folder in Path(file).parents if len(folder.parts) > 1} - {"web/src"}
    return {folder for folder in inner if not re.search(r"templates|versions|words/(en|de)", folder)}


def folders_in_the_tree() -> set[str]:
    tree = (ROOT / "CONTRIBUTING.md").read_text().split("```")[1]
    found, above = set(), {0: ""}
    for line in tree.splitlines():
        match = re.match(r"( *)([\w/-]+)/(?= |$)", line)
        if match:
            depth, name = len(match.group(1)), match.group(2)
            above[depth] = f"{above[depth - 2]}/{name}".lstrip("/") if depth else name
            found.add(above[depth])
    return {folder for folder in found if folder.startswith(PARTS)} - set(PARTS)


def test_every_folder_stands_in_the_tree_and_every_folder_of_the_tree_is_there() -> None:
    assert folders_in_the_tree() == folders_on_disk()


def test_the_roots_hold_little() -> None:
    assert len(list((ROOT / "core").glob("*.py"))) <= 5
    assert len(list((ROOT / "server").glob("*.py"))) <= 8


def test_a_test_that_has_a_modules_name_stands_where_the_module_does() -> None:
    modules = {
        f"{path.relative_to(ROOT).with_name('test_' + path.name)}" for part in ("core", "server") for path in (ROOT / part).rglob("*.py")
    }
    names = {Path(module).name for module in modules}
    misplaced = [
        str(test)
        for test in (ROOT / "tests").rglob("test_*.py")
        if test.relative_to(ROOT / "tests").parts[0] in ("core", "server")
        and test.name in names
        and str(test.relative_to(ROOT / "tests")) not in modules
    ]
    assert misplaced == []
