"""The service starts without the engine: that is for the processes that plan, move, fit and draw."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
HEAVY = {"mujoco", "ompl", "pinocchio", "coal", "numba", "viser", "filterpy", "scipy", "alembic", "httpx2", "pyarrow"}


@pytest.mark.parametrize("module", ["server.app", "server.serve", "server.command_line", "core.gap.addition", "core.twin.file"])
def test_nothing_heavy_is_imported(module: str) -> None:
    code = f"import sys, {module}; print(*sorted({{name.partition('.')[0] for name in sys.modules}}))"
    said = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert "numpy" in said or module == "server.command_line", said
    assert not HEAVY & set(said.split())
