"""The file that `heft diagnose --json` wrote."""

from __future__ import annotations

from pathlib import Path

from pydantic import ValidationError

from core.errors import BadInput, together
from core.files.schema_flaw import schema_flaw
from core.gap.answer import Diagnosis


def read_diagnosis(file: Path) -> Diagnosis:
    """A diagnosis, also of an earlier version.

    Raises:
        BadInput: it cannot be read, or is something else.
    """
    try:
        return Diagnosis.model_validate_json(file.read_bytes())
    except OSError as error:
        raise BadInput(str(file), "cli-result-unreadable", reason=str(error.strerror)) from error
    except ValidationError as error:
        flaw = schema_flaw(error.errors()[0]).refusal(BadInput, str(file))
        raise together([flaw, BadInput(str(file), "cli-no-diagnosis")]) from error
