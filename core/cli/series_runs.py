"""The runs that a comparison or a fusion is told of: answers as JSON, folders of runs, or folders of recordings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from core.cli.answer_file import read_result_file
from core.cli.terminal import find_wording, messages
from core.errors import BadInput
from core.estimation.result import Result, SecondsPart, result_of
from core.estimation.series import measure_result
from core.payload.random_effects import Measured
from core.recording.manifest import FILE as MANIFEST

ANSWER = "result.json"


@dataclass(frozen=True)
class RunsOfSeries:
    """Runs with their names; `results` say what else is known of them."""

    names: tuple[str, ...]
    results: tuple[Result, ...]

    @property
    def measured(self) -> list[Measured]:
        """What each has found; the frame is the sensor's."""
        return [measure_result(result) for result in self.results]


def read_runs(paths: Sequence[Path]) -> RunsOfSeries:
    """Reads answers, and identifies recordings.

    Raises:
        BadInput: there is neither an answer nor a recording, or one run is named twice.
    """
    results: list[Result] = []
    for path in paths:
        recorded = path / MANIFEST
        if path.is_dir() and (path / ANSWER).is_file():
            results.append(read_result_file(path / ANSWER))
        elif recorded.is_file():
            results.append(_identify(path))
        elif path.is_dir():
            raise BadInput(str(path), "cli-no-run", answer=ANSWER, manifest=MANIFEST)
        else:
            results.append(read_result_file(path))
    _check_apart(paths, results)
    return RunsOfSeries(shorten_names(paths), tuple(results))


def _check_apart(paths: Sequence[Path], results: Sequence[Result]) -> None:
    """No run counts twice, under whatever name: two measurements never agree in every digit."""
    first: dict[tuple[float | None, ...], Path] = {}
    for path, result in zip(paths, results, strict=True):
        found = () if result.estimate is None else tuple(result.estimate.phi)
        if any(value is not None for value in found) and first.setdefault(found, path) is not path:
            raise BadInput(str(path), "cli-run-twice", first=str(first[found]))


def _identify(folder: Path) -> Result:
    from core.estimation.identification import identify_recording  # noqa: PLC0415 - answers that are there already wait for no estimator
    from core.recording.long_recording import read_condensed  # noqa: PLC0415 - answers that are there already wait for no Parquet

    if messages.is_terminal:
        messages.print(find_wording().say("cli-identifying", folder=str(folder)), highlight=False)
    recording, remarks = read_condensed(folder)
    seconds = SecondsPart(robot=float(recording.t[-1] - recording.t[0]), estimate=0.0)
    found = identify_recording(recording)
    found = replace(found, warnings=(*found.warnings, *remarks))
    return result_of(found, recording, seconds=seconds, folder=folder)


def shorten_names(paths: Sequence[Path]) -> tuple[str, ...]:
    """The last part that tells them apart."""
    parts = [path.resolve().with_suffix("").parts for path in paths]
    for depth in range(1, max(len(each) for each in parts) + 1):
        names = ["/".join(each[-depth:]) for each in parts]
        if len(set(names)) == len(names):
            return tuple(names)
    return tuple(f"{'/'.join(each[-1:])} ({k + 1})" for k, each in enumerate(parts))
