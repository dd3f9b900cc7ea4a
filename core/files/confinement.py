"""What reads files from outside runs in a process of its own, with limits on time and memory: nothing in a file ends the program.

What has been read of a file is known by its content, so that each is read once.

Such a reader is a module with a function `answer` and, for the process, `if __name__ == "__main__": serve(answer)`.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import resource
import subprocess
import sys
from collections.abc import Callable, Sequence
from math import ceil
from pathlib import Path
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from core.errors import BadRobot
from core.words.message import Message

SECONDS = 60
"""Of computing time, for each order."""
WAITED_S = 600.0
"""For all orders of one process, however busy the machine is."""
MEMORY = 1_500_000_000  # bytes of private data

Order = dict[str, Any]
Arrays = list[NDArray[Any]]
Reader = Callable[[Order], Arrays]
T = TypeVar("T")

MOST_KNOWN = 500

_confined = False


def stay_here() -> None:
    """From now on readers answer in this process, which is one of those with limits."""
    global _confined  # noqa: PLW0603  # a property of the process, as its limits are
    _confined = True


class KnownFiles(Generic[T]):
    """Files that a reader has read, each known by its content and by what was asked of it.

    Args:
        answer: the reader; its orders have `file`, the path.
        make: what is kept of its answer.
    """

    def __init__(self, answer: Reader, make: Callable[[Arrays], T]) -> None:
        self._answer, self._make = answer, make
        self._known: dict[str, T] = {}

    def read(self, orders: Sequence[Order]) -> list[T]:
        """One for each order; those that are not known yet are read by one process.

        Raises:
            BadRobot: see `ask`, or a file that cannot be read.
        """
        digests = [_digest(order) for order in orders]
        new = {digest: order for digest, order in zip(digests, orders, strict=True) if digest not in self._known}
        found = self._known | dict(zip(new, map(self._make, ask(self._answer, list(new.values()))), strict=True))
        if len(found) <= MOST_KNOWN:
            self._known.update(found)
        else:
            self._known.clear()
        return [found[digest] for digest in digests]


def _digest(order: Order) -> str:
    """Of the content, the kind of the file and what is asked."""
    file = Path(order["file"])
    try:
        content = hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError as error:
        raise BadRobot(order["where"], "files-unreadable", reason=str(error.strerror)) from error
    asked = {key: value for key, value in order.items() if key not in {"file", "where"}}
    return f"{content} {file.suffix} {json.dumps(asked, sort_keys=True)}"


def ask(answer: Reader, orders: Sequence[Order]) -> list[Arrays]:
    """A reader's answers, from a process of its own.

    Args:
        answer: takes an order, which JSON can hold, with `where`, the file and key for the sentence.

    Raises:
        BadRobot: what the reader refuses, or an order that takes too much time or memory.
    """
    if _confined or not orders:
        return [answer(order) for order in orders]
    said = _run_reader(answer.__module__, orders)
    return [_arrays(said, order["where"]) for order in orders]


def _run_reader(module: str, orders: Sequence[Order]) -> io.BytesIO:
    """What the process wrote before it ended, in whatever way."""
    one_thread = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    process = subprocess.Popen(
        [sys.executable, "-m", module],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=os.environ | one_thread,
        cwd=Path(__file__).parents[2],
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
        if "code" not in head:
            return [np.load(said, allow_pickle=False) for _ in range(head["arrays"])]
        flaw = Message.model_validate(head)
    except (ValueError, EOFError) as error:
        raise BadRobot(where, "files-reader-ended", most_s=SECONDS, most_gb=MEMORY / 1e9) from error
    raise BadRobot(where, flaw.code, **{name: value for name, value in flaw.parameters.items() if name != "where"})


def answer_orders(answer: Reader) -> None:
    """Answers the orders on standard input, one a line, on standard output; the process has limits from here on."""
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for line in sys.stdin:
        used = resource.getrusage(resource.RUSAGE_SELF)
        resource.setrlimit(resource.RLIMIT_CPU, (ceil(used.ru_utime + used.ru_stime) + SECONDS, resource.RLIM_INFINITY))
        whole = io.BytesIO()
        try:
            arrays = answer(json.loads(line))
        except BadRobot as flaw:
            whole.write(flaw.message.model_dump_json(exclude={"text"}).encode() + b"\n")
        else:
            whole.write(json.dumps({"arrays": len(arrays)}).encode() + b"\n")
            for array in arrays:
                np.save(whole, array, allow_pickle=False)
        sys.stdout.buffer.write(whole.getvalue())
        sys.stdout.buffer.flush()
