"""The folder of a run of trials: seals first, then each outcome as it comes, so that a run that was cut short can go on."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from pydantic import ValidationError

from core.errors import BadInput
from core.files.whole_file import write_whole
from core.trial.draw import DrawnTrial
from core.trial.outcome import TrialOutcome
from core.words.message import Message

OUTCOMES = "trials.jsonl"
SEALS = "seals.txt"


def read_outcomes(folder: Path) -> dict[int, TrialOutcome]:
    """The outcomes in a folder by seed; none where it does not exist yet. A last line that was cut off while it was written is dropped.

    Raises:
        BadInput: something else stands there, or a line that is no outcome.
    """
    file = folder / OUTCOMES
    if not file.exists():
        if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
            raise BadInput(str(folder), "trial-not-a-run")
        return {}
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True)
    found = [_outcome(Message.of("trial-line", file=str(file), line=n), line) for n, line in enumerate(lines, 1) if line.endswith("\n")]
    return {outcome.sealed.seed: outcome for outcome in found}


def _outcome(where: Message, line: str) -> TrialOutcome:
    try:
        return TrialOutcome.model_validate_json(line)
    except ValidationError as error:
        raise BadInput(where, "trial-bad-outcome", count=error.error_count()) from None


def check_seals(drawn: Iterable[DrawnTrial], done: dict[int, TrialOutcome]) -> None:
    """What is drawn now is what was drawn when the folder was begun.

    Raises:
        BadInput: a seal differs, so that the outcomes would not belong together.
    """
    for one in drawn:
        seed = one.sealed.seed
        if seed not in done or done[seed].sealed.hash == one.sealed.hash:
            continue
        where = Message.of("trial-seed", seed=seed)
        raise BadInput(where, "trial-other-seal", there=done[seed].sealed.hash[:12], drawn=one.sealed.hash[:12])


def open_folder(folder: Path, drawn: Iterable[DrawnTrial], done: dict[int, TrialOutcome]) -> None:
    """Makes the folder with the seals of what is to come, each once, and leaves only whole outcomes in it."""
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / SEALS).open("a+", encoding="utf-8") as seals:
        seals.seek(0)
        there = set(seals)
        lines = (f"{one.sealed.seed} {one.sealed.hash}\n" for one in drawn if one.sealed.seed not in done)
        seals.writelines(line for line in lines if line not in there)
    write_whole(folder / OUTCOMES, "".join(outcome.model_dump_json() + "\n" for outcome in done.values()))


def append(folder: Path, outcome: TrialOutcome) -> None:
    """Adds a finished trial; what is written is written."""
    with (folder / OUTCOMES).open("a", encoding="utf-8") as file:
        file.write(outcome.model_dump_json() + "\n")
