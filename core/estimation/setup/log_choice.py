"""Which of the mappings that the names of a log leave open its samples speak for."""

from __future__ import annotations

from collections.abc import Mapping as Answers
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from core.estimation.setup.check import SetUp, check_setup
from core.recording.logs.conversion import Conversion
from core.recording.logs.mapping import Mapping, change_mapping, read_mapping
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import Log
from core.recording.recording import Recording

CHECKED_ROWS = 300_000
"""Of a long log its beginning is looked at."""
CLEARLY = 3.0
"""Times that another mapping has to fit worse to be out of the question, as a slip has to (docs/recordings.md)."""
OPEN_KEYS = {"axes": "import-why-wrench-axes", "sign": "import-why-wrench-sign"}


class ImportedLog(NamedTuple):
    """A log under one mapping: its beginning, and whether that agrees with itself."""

    conversion: Conversion
    beginning: Recording
    check: SetUp

    @property
    def mapping(self) -> Mapping:
        """That it was read with."""
        return self.conversion.mapping


def read_log(log: Log, mapping: Path | None, answers: Answers[str, str]) -> ImportedLog:
    """The log as a mapping has it, or as its names and samples speak.

    Args:
        mapping: the file of somebody's mapping, its URDF beside it; None where there is none.
        answers: keys of the mapping that somebody has given.

    Raises:
        OpenQuestion: one more has to be given.
        BadInput: the mapping or an answer cannot be used.
        BadRecording: something in the log cannot be used.
    """
    mappings = propose_mappings(log, answers) if mapping is None else [change_mapping(read_mapping(mapping), answers)]
    return import_log(log, mappings, Path() if mapping is None else mapping.parent)


def import_log(log: Log, mappings: Sequence[Mapping], beside: Path) -> ImportedLog:
    """The log under the mapping with which it fits best and the payload weighs more than nothing.

    Args:
        mappings: they differ in sign and axes of the wrench.
        beside: folder in which the URDF is.

    Raises:
        OpenQuestion: several do equally well.
        BadRecording: something in the log cannot be used.
    """
    tried: list[ImportedLog] = []
    for mapping in mappings:
        conversion = tried[0].conversion.under(mapping) if tried else Conversion(log, mapping, beside)
        beginning = conversion.recording(slice(0, CHECKED_ROWS))
        tried.append(ImportedLog(conversion, beginning, check_setup(beginning)))
    best = min(tried, key=_rank)
    alike = [each for each in tried if _is_alike(each, best)]
    for key, reason in OPEN_KEYS.items():
        choices = list(dict.fromkeys(str(getattr(each.mapping.wrench, key, None)) for each in alike))
        if len(choices) > 1:
            raise OpenQuestion(log.where, f"wrench.{key}", choices, reason, str(getattr(best.mapping.wrench, key)))
    return best


def _rank(each: ImportedLog) -> tuple[bool, float, bool]:
    weighed = each.check.weighed
    return weighed is None or weighed.mass <= 0.0, 0.0 if weighed is None else weighed.misfit, each.check.contradiction is not None


def _is_alike(each: ImportedLog, best: ImportedLog) -> bool:
    """Whether nothing speaks for the best that does not speak for this one too."""
    one, other = each.check.weighed, best.check.weighed
    if one is None or other is None:
        return one is other
    if other.upright and one.mass <= 0.0:
        return False
    return one.misfit < CLEARLY * max(other.misfit, 1.0)
