"""What a target of an export promises, and what it cannot hold."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from core.array import Array
from core.errors import BadPayload
from core.export.uncertainty import ExportUncertainty, state_uncertainty
from core.payload.inertia import PHI_NAMES, PHI_UNITS
from core.payload.uncertain_parameters import UncertainParameters
from core.words.message import Message

INERTIA_NAMES = PHI_NAMES[4:]
MM = 1000.0
"""Millimetres in a metre."""


@dataclass(frozen=True)
class Lack:
    """A number that a target has no place for.

    Args:
        name: as in `core.payload.inertia.PHI_NAMES`; inertia about the centre of mass.
        value, std: what is lost, with its standard uncertainty, in `unit`.
    """

    name: str
    value: float
    std: float
    unit: str

    @property
    def times_std(self) -> float:
        """Size of what is lost against its uncertainty: below 2 or 3 there is little to lose."""
        return abs(self.value) / self.std if self.std > 0.0 else np.inf


class ExportTarget(ABC):
    """One way in which somebody takes a payload; parameters are always those in the flange's frame.

    Attributes:
        name: in addresses and on the command line.
        title: for people.
        file: name of the file that is written.
        says: frame, units and order of what is in it.
        needs: rows of phi without which nothing can be written.
        remark: how a line that nobody executes is written, `{}` in its place; empty where there are none.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    file: ClassVar[str]
    says: ClassVar[Message]
    needs: ClassVar[slice] = slice(0, 10)
    remark: ClassVar[str] = ""

    @abstractmethod
    def text(self, payload: UncertainParameters) -> str:
        """The file's content; every parameter of `needs` is known."""

    @classmethod
    def require(cls, payload: UncertainParameters, rows: slice) -> None:
        """Nothing where these rows of phi are determined.

        Raises:
            BadPayload: one is not.
        """
        for name, value, unit in list(zip(PHI_NAMES, payload.phi, PHI_UNITS, strict=True))[rows]:
            if not np.isfinite(value):
                raise BadPayload(name, "export-not-determined", unit=unit, target=cls.title)

    @property
    def holds_uncertainty(self) -> bool:
        """Whether the file says how exactly the payload is known."""
        return bool(self.remark)

    def add_uncertainty(self, text: str, uncertainty: ExportUncertainty) -> str:
        """The file's content with remarks on how exactly it is known; as it was where there is no place for them."""
        return write_remarks(self.remark, uncertainty) + text

    def lacks(self, payload: UncertainParameters) -> Iterator[Lack]:
        """What has no place in it."""
        del payload
        yield from ()

    def render_file(self, payload: UncertainParameters, uncertainty: ExportUncertainty | None = None) -> str:
        """The file's content, with the uncertainty where that has a place in it.

        Raises:
            BadPayload: it needs a parameter that is not determined, or that is beyond what it takes.
        """
        self.require(payload, self.needs)
        text = self.text(payload)
        return text if uncertainty is None else self.add_uncertainty(text, uncertainty)


def write_remarks(remark: str, uncertainty: ExportUncertainty) -> str:
    """Lines in English, as controllers read no other letters; nothing where there are no remarks."""
    return "".join(f"{remark.format(line.text)}\n" for line in state_uncertainty(uncertainty) if remark)


def inertia_lacks(payload: UncertainParameters, names: tuple[str, ...]) -> Iterator[Lack]:
    """Entries of the inertia about the centre of mass that have no place; what is not determined cannot be lost."""
    for name, value, std in zip(INERTIA_NAMES, payload.inertia_com, payload.inertia_com_std, strict=True):
        if name in names and np.isfinite(value):
            yield Lack(name, float(value), float(std), "kg m2")


def digits(values: Array, separator: str = ", ", factor: float = 1.0) -> str:
    """Numbers with nine digits, more than any identification has."""
    return separator.join(f"{factor * value:.9g}" for value in values)
