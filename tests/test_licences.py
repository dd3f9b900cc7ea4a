"""The licences of what ships stand in `docs/licences.md`, and what is imported is declared."""

from __future__ import annotations

import ast
import json
import re
import sys
import tomllib
from importlib import metadata
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TABLE = (ROOT / "docs" / "licences.md").read_text()
STATED = dict(re.findall(r"^\| ([\w@/.-]+) \| (.+) \|$", TABLE, re.MULTILINE))
UNSTATED = {"cmeel-qhull": "Qhull", "xacro": "BSD"}
"""Their metadata name no licence; their licence texts do."""
IMPORTED_AS = {"pin": "pinocchio", "coal": "coal"}
BY_NAME = {"pg8000"}
"""What another library imports when a setting names it: the driver of PostgreSQL."""


def packages() -> list[str]:
    return re.findall(r"^([\w.-]+)==", (ROOT / "requirements.txt").read_text(), re.MULTILINE)


def licence_of(package: str) -> str:
    found = metadata.distribution(package).metadata
    classified = [each.split("::")[-1].strip() for each in found.get_all("Classifier") or [] if each.startswith("License")]
    named = "; ".join(each for each in classified if each != "OSI Approved")
    return UNSTATED.get(package) or found.get("License-Expression") or named or (found.get("License") or "").split("\n")[0]


@pytest.mark.parametrize("package", sorted(set(packages())))
def test_each_package_that_ships_stands_there_with_the_licence_that_it_states(package: str) -> None:
    stated = STATED[package]
    if "not on Linux" not in stated:
        assert stated == licence_of(package)
    assert "GPL" not in stated


def test_what_is_built_into_the_console_stands_there_too() -> None:
    modules = ROOT / "web" / "node_modules"
    if not modules.is_dir():
        pytest.skip("the console's packages are not installed: make check-console")
    for package in json.loads((ROOT / "web" / "package.json").read_text())["dependencies"]:
        assert STATED[package] == json.loads((modules / package / "package.json").read_text())["license"]


def test_the_licence_is_the_one_that_the_package_declares() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert project["license"] == "Apache-2.0"
    assert "Apache License" in (ROOT / "LICENSE").read_text()


def imported() -> set[str]:
    found = set()
    for part in ("core", "server"):
        for file in (ROOT / part).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text())):
                if isinstance(node, ast.Import):
                    found |= {each.name.split(".")[0] for each in node.names}
                elif isinstance(node, ast.ImportFrom) and node.module is not None and node.level == 0:
                    found.add(node.module.split(".")[0])
    return found - set(sys.stdlib_module_names) - {"core", "server"}


def test_what_is_imported_is_declared_and_what_is_declared_is_imported() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    declared = {re.split(r"[=<>\[]", each)[0] for each in project["dependencies"]}
    optional = {
        re.split(r"[=<>\[]", each)[0] for name, extra in project["optional-dependencies"].items() if name != "dev" for each in extra
    }
    of_module = metadata.packages_distributions() | {module: [package] for package, module in IMPORTED_AS.items()}
    used = {module: {package.lower().replace("_", "-") for package in of_module.get(module, [])} for module in imported()}
    assert {module for module, packages in used.items() if not packages & (declared | optional)} == set()
    assert declared - set().union(*used.values()) == BY_NAME
