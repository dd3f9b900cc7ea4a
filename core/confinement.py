"""What reads files from outside runs in a process of its own, with limits on time and memory: nothing in a file ends the program.

Such a reader is a module with a function `answer` and, for the process, `if __name__ == "__main__": serve(answer)`.
"""

from __future__ import annotations

import io
import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.errors import BadRobot

SECONDS = 60
"""Of computing time, for all orders of one process."""
WAITED_S = 600.0
"""However busy the machine is."""
MEMORY = 1_500_000_000  # bytes of private data

Order = dict[str, Any]
Arrays = list[NDArray[Any]]
Reader = Callable[[Order], Arrays]

_confined = False


def stay_here() -> None:
    """From now on readers answer in this process, which is one of those with limits."""
    global _confined  # noqa: PLW0603  # a property of the process, as its limits are
    _confined = True


def ask(answer: Reader, orders: Sequence[Order]) -> list[Arrays]:
    """A reader's answers, from a process of its own.

    Args:
        answer: takes an order, which JSON can hold, with `where`, the file and key for the sentence.

    Raises:
        BadRobot: what the reader refuses, or an order that takes too much time or memory.
    """
    if _confined or not orders:
        return [answer(order) for order in orders]
    said = _said(answer.__module__, orders)
    return [_arrays(said, order["where"]) for order in orders]


def _said(module: str, orders: Sequence[Order]) -> io.BytesIO:
    """What the process wrote before it ended, in whatever way."""
    one_thread = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    process = subprocess.Popen(
        [sys.executable, "-m", module],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=os.environ | one_thread,
        cwd=Path(__file__).parents[1],
    )
    try:
        said, _ = process.communicate("".join(json.dumps(order) + "\n" for order in orders).encode(), timeout=WAITED_S)
    except subprocess.TimeoutExpired:
        process.kill()
        said, _ = process.communicate()
    return io.BytesIO(said)


def _arrays(said: io.BytesIO, where: str) -> Arrays:
    """The next answer."""
    try:
        head = json.loads(said.readline())
        if "found" not in head:
            return [np.load(said, allow_pickle=False) for _ in range(head["arrays"])]
    except (ValueError, EOFError) as error:
        limits = f"{SECONDS} s of computing time and {MEMORY / 1e9:g} GB"
        raise BadRobot(where, f"a file on which its reader ended, at most {limits} allowed", "a mesh of ordinary size") from error
    raise BadRobot(where, head["found"], head["expected"])


def serve(answer: Reader) -> None:
    """Answers the orders on standard input, one a line, on standard output; the process has limits from here on."""
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for line in sys.stdin:
        whole = io.BytesIO()
        try:
            arrays = answer(json.loads(line))
        except BadRobot as flaw:
            whole.write(json.dumps({"found": flaw.found, "expected": flaw.expected}).encode() + b"\n")
        else:
            whole.write(json.dumps({"arrays": len(arrays)}).encode() + b"\n")
            for array in arrays:
                np.save(whole, array, allow_pickle=False)
        sys.stdout.buffer.write(whole.getvalue())
        sys.stdout.buffer.flush()
