"""Results that are kept as they come, one line of JSON each, so that a bench that was cut short goes on where it ended."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from concurrent.futures import Future, as_completed
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel

Result = TypeVar("Result", bound=BaseModel)


def read_results(path: Path, kind: type[Result]) -> list[Result]:
    """Those of earlier runs; a last line that was cut off is left out."""
    lines = path.read_text().splitlines() if path.exists() else []
    return [kind.model_validate_json(line) for line in lines if line.endswith("}")]


def append_results(path: Path, asked: Mapping[Future[Result], object]) -> Iterator[Result]:
    """Each as it ends, once its line is written; one that fails is told by the name that it was asked for by."""
    with path.open("a") as file:
        if path.stat().st_size and not path.read_bytes().endswith(b"\n"):
            file.write("\n")
        for future in as_completed(asked):
            error = future.exception()
            if error is not None:
                print(f"{asked[future]} failed: {error!r}", file=sys.stderr, flush=True)
                continue
            result = future.result()
            file.write(result.model_dump_json() + "\n")
            file.flush()
            yield result
