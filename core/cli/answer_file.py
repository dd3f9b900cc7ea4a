"""Answers read back from the files that `--json` wrote."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ValidationError

from core.errors import BadInput, together
from core.estimation.result import Result
from core.files.schema_flaw import schema_flaw
from core.gap.answer import Diagnosis

Answer = TypeVar("Answer", bound=BaseModel)


def read_result_file(file: Path) -> Result:
    """A result of `heft identify` or `heft run`, also of an earlier version.

    Raises:
        BadInput: it cannot be read, or is something else.
    """
    return _read(file, Result, "cli-no-result")


def read_diagnosis_file(file: Path) -> Diagnosis:
    """A diagnosis of `heft diagnose`, also of an earlier version.

    Raises:
        BadInput: it cannot be read, or is something else.
    """
    return _read(file, Diagnosis, "cli-no-diagnosis")


def _read(file: Path, kind: type[Answer], code: str) -> Answer:
    """Args: code: of the message for a file that holds something else."""
    try:
        return kind.model_validate_json(file.read_bytes())
    except OSError as error:
        raise BadInput(str(file), "cli-result-unreadable", reason=str(error.strerror)) from error
    except ValidationError as error:
        flaw = schema_flaw(error.errors()[0]).refusal(BadInput, str(file))
        raise together([flaw, BadInput(str(file), code)]) from error
