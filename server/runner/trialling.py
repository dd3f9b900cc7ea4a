"""Blind trials, one after the other on one core: sealed, told, run, opened. What is done stays in their folder, from where they go on."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path

from threadpoolctl import threadpool_limits

from core.errors import HeftError
from core.trial.batch import outcomes
from core.trial.draw import DrawnTrial, draw
from core.trial.folder import append, check_seals, open_folder, read_outcomes
from core.trial.judgement import mark
from core.trial.outcome import TrialOutcome
from core.trial.sheet import score_sheet
from core.words.catalogue import LANGUAGES
from server.runner.messages import Advanced, Answered, Failed
from server.runner.trial_schemas import SEALS, NamedEffect, OpenedTrial, Seal, TrialsResult
from server.runner.work import give_way


def main(folder: Path, count: int, seed: int, connection: Connection) -> None:
    """Runs `count` trials from a seed on.

    Args:
        folder: of these trials; made here, or that of an earlier beginning.
    """
    give_way()
    threadpool_limits(1)
    with suppress(BrokenPipeError):  # nobody waits any more
        try:
            drawn = [draw(k) for k in range(seed, seed + count)]
            done = read_outcomes(folder)
            check_seals(drawn, done)
            open_folder(folder, drawn, done)
            connection.send(Advanced(len(done) / count, _seals(drawn)))
            _run(drawn, done, folder, connection)
            connection.send(Answered(_open_trials(list(done.values()))))
        except HeftError as error:
            connection.send(Failed(type(error).__name__, error.message))


def _run(drawn: list[DrawnTrial], done: dict[int, TrialOutcome], folder: Path, connection: Connection) -> None:
    """What is not done yet."""
    missing = [one for one in drawn if one.sealed.seed not in done]
    with ThreadPoolExecutor(1) as alone:
        for outcome in outcomes(missing, alone):
            append(folder, outcome)
            done[outcome.sealed.seed] = outcome
            connection.send(Advanced(len(done) / len(drawn)))


def _seals(drawn: list[DrawnTrial]) -> str:
    return SEALS.dump_json([Seal(seed=one.sealed.seed, sha256=one.sealed.hash) for one in drawn]).decode()


def _open_trials(found: list[TrialOutcome]) -> str:
    found = sorted(found, key=lambda outcome: outcome.sealed.seed)
    opened = [
        OpenedTrial(
            seed=outcome.sealed.seed,
            sealed=outcome.sealed.model_dump_json(),
            planted=outcome.sealed.in_words,
            size=outcome.sealed.size,
            verdict=outcome.verdict,
            named=outcome.first,
            effects=[NamedEffect(id=each.id, probability=each.probability, closure=each.closure) for each in outcome.effects],
            also=tuple(sorted(outcome.also)),
            none_probability=outcome.none_probability,
            unknown_probability=outcome.unknown_probability,
            gap_before=outcome.gap_before,
            gap_after=outcome.gap_after,
            mark=mark(outcome),
        )
        for outcome in found
    ]
    sheets = {language: score_sheet(found, language) for language in LANGUAGES}
    return TrialsResult(opened=opened, sheet=sheets["en"], sheets=sheets).model_dump_json()
