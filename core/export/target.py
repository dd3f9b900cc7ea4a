"""What a target of an export promises, and what it cannot hold."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from core.array import Array
from core.errors import BadPayload
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


class Target(ABC):
    """One way in which somebody takes a payload; parameters are always those in the flange's frame.

    Attributes:
        name: in addresses and on the command line.
        title: for people.
        file: name of the file that is written.
        says: frame, units and order of what is in it.
        needs: rows of phi without which nothing can be written.
    """

    name: ClassVar[str]
    title: ClassVar[str]
    file: ClassVar[str]
    says: ClassVar[Message]
    needs: ClassVar[slice] = slice(0, 10)

    @abstractmethod
    def text(self, payload: UncertainParameters) -> str:
        """The file's content; every parameter of `needs` is known."""

    def lacks(self, payload: UncertainParameters) -> Iterator[Lack]:
        """What has no place in it."""
        del payload
        yield from ()

    def render_file(self, payload: UncertainParameters) -> str:
        """The file's content.

        Raises:
            BadPayload: it needs a parameter that is not determined, or that is beyond what it takes.
        """
        for name, value, unit in list(zip(PHI_NAMES, payload.phi, PHI_UNITS, strict=True))[self.needs]:
            if not np.isfinite(value):
                raise BadPayload(name, "export-not-determined", unit=unit, target=self.title)
        return self.text(payload)


def inertia_lacks(payload: UncertainParameters, names: tuple[str, ...]) -> Iterator[Lack]:
    """Entries of the inertia about the centre of mass that have no place; what is not determined cannot be lost."""
    for name, value, std in zip(INERTIA_NAMES, payload.inertia_com, payload.inertia_com_std, strict=True):
        if name in names and np.isfinite(value):
            yield Lack(name, float(value), float(std), "kg m2")


def digits(values: Array, separator: str = ", ", factor: float = 1.0) -> str:
    """Numbers with nine digits, more than any identification has."""
    return separator.join(f"{factor * value:.9g}" for value in values)
