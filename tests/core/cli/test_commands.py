"""The list of commands is made without them, and says what they say."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module

import pytest
from typer.main import get_command

from core.cli.commands import COMMANDS
from core.version import code_version

SLOW_PARTS = ("scipy.optimize", "scipy.interpolate", "scipy.spatial", "scipy.stats", "scipy.signal")
"""Of SciPy: half a second of processor time together, which only some recordings need."""
HEAVY = ("numba", "pinocchio", "mujoco", "ompl", "matplotlib", "scipy")


@pytest.mark.parametrize("name", COMMANDS)
def test_each_command_is_where_the_list_says_and_says_what_the_list_says(name: str) -> None:
    command = get_command(import_module(COMMANDS[name].module).app)
    assert command.help is not None
    assert " ".join(command.help.split()) == COMMANDS[name].summary


def test_an_ordinary_recording_is_identified_without_optimisers_and_the_rotations_of_scipy() -> None:
    code = f"import sys, core.cli.identify; print(*(name for name in {SLOW_PARTS!r} if name in sys.modules))"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == ""


@pytest.mark.parametrize("arguments", [["--help"], ["cells"], ["--version"]])
def test_what_needs_no_engine_imports_none(arguments: list[str]) -> None:
    code = f"""
import sys
from core.cli.main import main
sys.argv = ["heft", *{arguments!r}]
try:
    main()
except SystemExit as end:
    assert not end.code, end.code
print(*(name for name in {HEAVY!r} if name in sys.modules), file=sys.stderr)
"""
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ended.stderr.strip() == ""
    assert ended.stdout.strip()


def test_the_version_is_that_of_the_code() -> None:
    ended = subprocess.run([sys.executable, "-m", "core.cli", "--version"], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == code_version()


def test_a_command_that_is_not_there_is_told_with_those_that_are_like_it() -> None:
    ended = subprocess.run([sys.executable, "-m", "core.cli", "identfy"], capture_output=True, text=True, check=False)
    assert ended.returncode == 2
    assert "identify" in ended.stderr
