"""Trials at the same time, on cores and on a Dask cluster."""

from __future__ import annotations

import builtins
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from core.errors import BadInput
from core.trial import batch
from core.trial.batch import on_cluster, on_cores, outcomes
from core.trial.draw import DrawnTrial
from core.trial.outcome import TrialOutcome
from tests.core.trial.synthetic_outcomes import none, sealed


def drawn(seed: int) -> DrawnTrial:
    """A trial of which nothing but the seal is used."""
    return DrawnTrial(None, None, sealed(seed, kind="none"), None, ())  # type: ignore[arg-type]  # never run


def pretended(one: DrawnTrial, keep: Path | None = None) -> TrialOutcome:
    """In place of a trial: fails for seed 13, tells its process."""
    if one.sealed.seed == 13:
        raise ValueError("singular matrix")
    return none(one.sealed.seed, version=str(os.getpid()))


@pytest.fixture(autouse=True)
def _pretend(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "run_trial", pretended)


def test_trials_run_in_processes_of_their_own_and_none_is_lost():
    with on_cores(2) as pool:
        found = list(outcomes([drawn(k) for k in range(8)], pool))
    assert sorted(outcome.sealed.seed for outcome in found) == list(range(8))
    assert str(os.getpid()) not in {outcome.version for outcome in found}


def test_a_trial_that_fails_has_an_outcome_that_says_why():
    with on_cores(1) as pool:
        found = {outcome.sealed.seed: outcome for outcome in outcomes([drawn(12), drawn(13)], pool)}
    assert found[12].stopped is None
    assert str(found[13].stopped) == "ValueError: singular matrix"


def test_an_interruption_ends_the_workers_and_what_waits(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(batch, "run_trial", sleeping)
    with pytest.raises(KeyboardInterrupt), on_cores(1) as pool:
        for outcome in outcomes([drawn(k) for k in (0, 1000, 1001)], pool):
            assert outcome.sealed.seed == 0
            raise KeyboardInterrupt


def sleeping(one: DrawnTrial, keep: Path | None = None) -> TrialOutcome:
    """Seeds from 1000 on never end."""
    if one.sealed.seed >= 1000:
        import threading

        threading.Event().wait()
    return none(one.sealed.seed)


@pytest.fixture
def cluster() -> Iterator[str]:
    """A scheduler with one worker in this process."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None, protocol="tcp") as local:
        yield local.scheduler_address


def test_a_dask_cluster_runs_the_trials(cluster: str):
    with on_cluster(cluster) as executor:
        found = {outcome.sealed.seed: outcome for outcome in outcomes([drawn(k) for k in (11, 12, 13)], executor)}
    assert found[11] == none(11, version=str(os.getpid()))
    assert str(found[13].stopped) == "ValueError: singular matrix"


def test_without_dask_the_answer_is_what_to_install(monkeypatch: pytest.MonkeyPatch):
    real = builtins.__import__

    def without(name: str, *arguments: Any, **more: Any) -> Any:
        if name == "distributed":
            raise ImportError(name)
        return real(name, *arguments, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(BadInput, match=r"pip install 'heft\[dask\]'"), on_cluster("tcp://127.0.0.1:1"):
        pass


def test_a_scheduler_that_does_not_answer_is_bad_input(monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr(batch, "CONNECT_S", 0.5)
    with pytest.raises(BadInput, match="no scheduler"), on_cluster("tcp://127.0.0.1:9"):
        pass
