"""The `heft` command as a person or a script uses it: what it prints and how it ends."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from pathlib import Path

import pytest

from core.cli.main import main
from core.cli.terminal import answers, messages

ROOT = Path(__file__).parents[3]
LANGUAGE_NAMES = ("HEFT_LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")
"""Variables that say the language."""


def heft(*arguments: str | Path | float, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess[str]:
    """Enters the command in this process, which has the engine imported, with no terminal and nothing to read."""
    out, errors, code = io.StringIO(), io.StringIO(), 0
    on_sigterm = signal.getsignal(signal.SIGTERM)
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(errors), chdir(cwd):
        for name in LANGUAGE_NAMES:
            patch.delenv(name, raising=False)
        for name, value in ({"COLUMNS": "200"} | environment).items():
            patch.setenv(name, value)
        for console in (answers, messages):  # made when they were imported, as wide as the terminal was then
            patch.setattr(console, "width", int(os.environ["COLUMNS"]))
        patch.setattr(sys, "argv", ["heft", *map(str, arguments)])
        patch.setattr(sys, "stdin", io.StringIO())
        try:
            main()
        except SystemExit as end:
            code = end.code or 0
        finally:
            signal.signal(signal.SIGTERM, on_sigterm)
    return subprocess.CompletedProcess(sys.argv, code, out.getvalue(), errors.getvalue())


def heft_process(*arguments: str | Path | float, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess[str]:
    """Runs the command in a process of its own, in a pipe: seconds of imports, for what only a process shows."""
    clean = {name: value for name, value in os.environ.items() if name not in LANGUAGE_NAMES}
    return subprocess.run(
        [sys.executable, "-m", "core.cli", *map(str, arguments)],
        capture_output=True, text=True, cwd=cwd, timeout=300, check=False, stdin=subprocess.DEVNULL,
        env=clean | {"PYTHONPATH": str(ROOT), "COLUMNS": "200", "PYTHONUTF8": "1"} | environment,
    )  # fmt: skip
