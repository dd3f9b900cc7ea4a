"""`heft trial`: the blind check on a terminal."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, closing, nullcontext
from pathlib import Path
from typing import Annotated

import typer
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeRemainingColumn

from core.cli.options import LanguageOption
from core.cli.terminal import answers, find_wording, messages
from core.errors import BadInput
from core.trial.batch import cores, on_cluster, on_cores, outcomes
from core.trial.draw import CELLS, DrawnTrial, draw
from core.trial.folder import append, check_seals, open_folder, read_outcomes
from core.trial.judgement import mark
from core.trial.outcome import TrialOutcome
from core.trial.sheet import score_sheet, write_sheet
from core.words.catalogue import Language

app = typer.Typer()


@app.command()
def trial(
    count: Annotated[int, typer.Option(min=1, help="How many trials, from the first seed on.")] = 1,
    seed: Annotated[int, typer.Option(min=0, help="The first seed.")] = 0,
    seeds: Annotated[str | None, typer.Option(metavar="LIST", help="These seeds instead, as in `300,305,400-420`.")] = None,
    cell: Annotated[
        list[str] | None,
        typer.Option(metavar="CELL", help="A cell to draw from, name or folder; can be repeated. [default: those that ship]"),
    ] = None,
    report: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder for outcomes and score sheet; a run there goes on.")] = None,
    keep: Annotated[Path | None, typer.Option(metavar="DIR", help="Folder for the recordings, one per seed.")] = None,
    processes: Annotated[int | None, typer.Option(min=1, help="Trials at the same time. [default: one per core]")] = None,
    dask: Annotated[str | None, typer.Option(metavar="ADDRESS", help="Scheduler of a Dask cluster that is to run them.")] = None,
    *,
    language: LanguageOption,
) -> None:
    """The blind check: plant faults in the virtual robot, seal the answer, diagnose, open the seal, score."""
    wanted = seeds_of(seeds) if seeds else list(range(seed, seed + count))
    done = {} if report is None else read_outcomes(report)
    if keep is not None:
        _make_room(keep, [k for k in wanted if k not in done])
    where = on_cluster(dask) if dask else on_cores(min(processes or cores(), len(wanted)))
    with messages.status(find_wording().say("cli-planning")) if messages.is_terminal else nullcontext():
        drawn = [draw(k, cell or CELLS) for k in wanted]
    check_seals(drawn, done)
    missing = [one for one in drawn if one.sealed.seed not in done]
    for one in missing:
        told = find_wording().say("cli-trial-sealed", seed=one.sealed.seed, hash=one.sealed.hash)
        answers.print(told, highlight=False, soft_wrap=True)
    if report is not None:
        open_folder(report, drawn, done)
    try:
        with closing(_track_outcomes(missing, where, keep)) as coming:
            for outcome in coming:
                done[outcome.sealed.seed] = outcome
                if report is not None:
                    append(report, outcome)
                _show(outcome)
    finally:
        if done:
            _finish(list(done.values()), report, language)


def _finish(found: list[TrialOutcome], report: Path | None, language: Language) -> None:
    """The sheet over all that is there, however the run ended."""
    found = sorted(found, key=lambda outcome: outcome.sealed.seed)
    answers.print(score_sheet(found, language), highlight=False, markup=False, soft_wrap=True)
    if report is not None:
        write_sheet(report, found, language)


def seeds_of(text: str) -> list[int]:
    """Seeds of a list like `300,305,400-420`, each once.

    Raises:
        BadInput: not such a list.
    """
    found: dict[int, None] = {}
    for part in text.split(","):
        first, dash, last = part.strip().partition("-")
        if not first.isdecimal() or (dash and not last.isdecimal()):
            raise BadInput("--seeds", "cli-not-seeds", found=part)
        found.update(dict.fromkeys(range(int(first), int(last or first) + 1)))
    return list(found)


def _make_room(keep: Path, seeds: Sequence[int]) -> None:
    """Before anything long begins, drawing included: no recording is there already."""
    for seed in seeds:
        if (keep / str(seed)).exists():
            raise BadInput(str(keep / str(seed)), "cli-kept-already")
    keep.mkdir(parents=True, exist_ok=True)


def _track_outcomes(
    drawn: Sequence[DrawnTrial], where: AbstractContextManager[Executor], keep: Path | None
) -> Generator[TrialOutcome, None, None]:
    """The outcomes with a bar that tells how long the rest will take."""
    columns = (SpinnerColumn(), TextColumn(find_wording().say("cli-trials")), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with where as executor, Progress(*columns, console=messages, transient=True, disable=not messages.is_terminal) as progress:
        yield from progress.track(outcomes(drawn, executor, keep), total=len(drawn))


def _show(outcome: TrialOutcome) -> None:
    sealed = outcome.sealed
    answer = outcome.stopped or f"{outcome.verdict} {outcome.first or ''}".strip()
    told = find_wording().say(
        "cli-trial-answered", seed=sealed.seed, planted=sealed.in_words, size=sealed.size, answer=answer, mark=mark(outcome)
    )
    answers.print(told, highlight=False, soft_wrap=True)
