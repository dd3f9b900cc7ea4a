"""A target that takes JSON: a field beside its own says how exactly the payload is known."""

from __future__ import annotations

import json
from abc import abstractmethod
from typing import Any

from core.export.target import ExportTarget
from core.export.uncertainty import ExportUncertainty
from core.payload.uncertain_parameters import UncertainParameters

UNCERTAINTY = "heft_uncertainty"
"""Name of the field, which is nobody else's."""


class JsonTarget(ExportTarget):
    """One object, its names the target's own."""

    @abstractmethod
    def content(self, payload: UncertainParameters) -> dict[str, Any]:
        """What is in the object."""

    def text(self, payload: UncertainParameters) -> str:
        """The object as JSON."""
        return json.dumps(self.content(payload), indent=2) + "\n"

    @property
    def holds_uncertainty(self) -> bool:
        """Whoever reads an object by its names passes over others."""
        return True

    def add_uncertainty(self, text: str, uncertainty: ExportUncertainty) -> str:
        """The object with one field more, `ExportUncertainty`."""
        return json.dumps({**json.loads(text), UNCERTAINTY: uncertainty.model_dump()}, indent=2) + "\n"
