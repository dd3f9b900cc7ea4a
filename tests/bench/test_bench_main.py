"""`make bench`: all benches that stand in the figures."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest

from bench import __main__ as every

ROOT = Path(__file__).parents[2]


def test_every_bench_of_the_figures_that_fills_no_folder_is_run() -> None:
    told = re.findall(r"`python -m bench\.([a-z_.]+)([^`]*)`", (ROOT / "docs" / "figures.md").read_text(encoding="utf-8"))
    wanted = {name for name, options in told if "FOLDER" not in options or "--keep FOLDER" in options}
    assert len(wanted) > 30
    assert wanted <= {bench.split()[0] for bench in every.BENCHES}
    assert all((ROOT / "bench" / f"{bench.split()[0]}.py").exists() for bench in every.BENCHES)


def test_one_that_fails_does_not_keep_the_others_from_running(monkeypatch: pytest.MonkeyPatch) -> None:
    ran: list[str] = []

    def run(command: list[str], *, check: bool) -> SimpleNamespace:
        assert not check
        ran.append(command[2])
        return SimpleNamespace(returncode=int(command[2] == "bench.clocks"))

    monkeypatch.setattr(subprocess, "run", run)
    with pytest.raises(SystemExit, match="failed: clocks"):
        every.main()
    assert len(ran) == len(every.BENCHES)
