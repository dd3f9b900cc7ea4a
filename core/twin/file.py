"""`twin.json` in a cell's folder: read as the untrusted file it is, written whole or not at all.

The effects, with all that they compute with, are loaded only where values are checked against them.
"""

from __future__ import annotations

import difflib
from typing import TYPE_CHECKING

import numpy as np
from pydantic import ValidationError

from core.cell.cell import TWIN_FILE, Cell
from core.errors import BadTwin
from core.files.jail import read_inside
from core.files.schema_flaw import schema_flaw
from core.files.whole_file import write_whole
from core.twin.twin import NOMINAL, Entry, Twin
from core.words.message import Message

if TYPE_CHECKING:
    from core.effects.effect import Parameter

MAX_BYTES = 1_000_000
MINUS_ZERO = -1e-6
"""Of the largest eigenvalue; a covariance that has been written and read again may be this far from positive."""


def read_twin(cell: Cell) -> Twin:
    """The cell's twin; the nominal one where its folder has no `twin.json`.

    Raises:
        BadTwin: the file is malformed, names an unknown effect or parameter, or a value is impossible.
    """
    twin = parse_twin(cell)
    check_twin(twin, cell)
    return twin


def parse_twin(cell: Cell) -> Twin:
    """The same as data, by a process that does not know the effects.

    Raises:
        BadTwin: the file is malformed.
    """
    file = cell.folder / TWIN_FILE
    if not file.exists() and not file.is_symlink():
        return NOMINAL
    text = read_inside(cell.folder, TWIN_FILE, BadTwin, max_bytes=MAX_BYTES)
    try:
        return Twin.model_validate_json(text)
    except ValidationError as error:
        raise schema_flaw(error.errors()[0]).refusal(BadTwin, str(file)) from error


def write_twin(cell: Cell, twin: Twin) -> None:
    """Replaces the cell's twin, or takes the file away where nothing is left to add to the nominal one.

    Raises:
        BadTwin: an effect, parameter or value that could not be read again, or a folder that cannot be written.
    """
    check_twin(twin, cell)
    put_twin(cell, twin)


def put_twin(cell: Cell, twin: Twin) -> None:
    """The same with a twin that was checked before.

    Raises:
        BadTwin: the folder cannot be written.
    """
    file = cell.folder / TWIN_FILE
    try:
        if twin.effects:
            write_whole(file, serialise_twin(twin))
        else:
            file.unlink(missing_ok=True)
    except OSError as error:
        raise BadTwin(str(file), "twin-not-written", reason=error.strerror or str(error)) from error


def serialise_twin(twin: Twin) -> str:
    """What stands in a `twin.json`."""
    return twin.model_dump_json(indent=1) + "\n"


def close_name(identifier: str, known: list[str]) -> Message:
    """What an unknown name is answered with."""
    close = difflib.get_close_matches(identifier, known, n=1, cutoff=0.5)
    return Message.of("twin-close-name", name=close[0]) if close else Message.of("twin-known-names", names=known)


def check_twin(twin: Twin, cell: Cell) -> None:
    """Every effect is known, its parameters have their units and plausible sizes, and their covariance is one.

    Raises:
        BadTwin: not so.
    """
    from core.effects.library import find_effect, library  # noqa: PLC0415 - seconds of compilers and numerics, see above
    from core.twin.model import make_home_scene  # noqa: PLC0415 - as above

    where = str(cell.folder / TWIN_FILE)
    scene = make_home_scene(cell)
    for k, entry in enumerate(twin.effects):
        here = f"{where}: effects.{k}"
        try:
            effect = find_effect(entry.effect)
        except KeyError:
            meant = close_name(entry.effect, [each.id for each in library()])
            raise BadTwin(f"{here}.effect", "twin-unknown-effect", effect=entry.effect, meant=meant) from None
        if twin.ids.count(entry.effect) > 1:
            raise BadTwin(f"{here}.effect", "twin-effect-twice", effect=entry.effect, count=twin.ids.count(entry.effect))
        _check_parameters(entry, effect.parameters(scene), f"{here}.parameters")
        _check_covariance(entry, f"{here}.covariance")


def _check_parameters(entry: Entry, parameters: tuple[Parameter, ...], where: str) -> None:
    by_name = {p.name: p for p in parameters}
    for name in entry.parameters:
        if name not in by_name:
            meant = close_name(name, list(by_name))
            raise BadTwin(f"{where}.{name}", "twin-unknown-parameter", effect=entry.effect, meant=meant)
    for name in by_name:
        if name not in entry.parameters and not name.endswith("_per_k"):  # only found where the temperature is recorded
            raise BadTwin(f"{where}.{name}", "twin-no-such-key")
    for name, fitted in entry.parameters.items():
        p = by_name[name]
        if fitted.unit != p.unit:
            raise BadTwin(f"{where}.{name}.unit", "twin-unit", unit=fitted.unit, right=p.unit)
        if not p.lower <= fitted.value <= p.upper:
            place = f"{where}.{name}.value"
            raise BadTwin(place, "twin-out-of-bounds", figure=fitted.value, unit=p.unit, lower=p.lower, upper=p.upper)


def _check_covariance(entry: Entry, where: str) -> None:
    n = len(entry.parameters)
    if [len(row) for row in entry.covariance] != [n] * n:
        raise BadTwin(where, "twin-covariance-size", rows=len(entry.covariance), count=n)
    C = np.array(entry.covariance)
    size = np.linalg.eigvalsh(C)
    if not np.allclose(C, C.T) or size[0] < MINUS_ZERO * max(size[-1], 0.0):
        raise BadTwin(where, "twin-no-covariance")
