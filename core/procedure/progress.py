"""Shows a run's events on a terminal; in a pipe only what matters afterwards (stops, restarts) is printed."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar

from rich.console import Console
from rich.progress import BarColumn, Progress, SpinnerColumn, TaskID, TaskProgressColumn, TextColumn, TimeRemainingColumn

from core import events
from core.events import Event, drive

Answer = TypeVar("Answer")


def watch(run: Generator[Event, None, Answer], console: Console) -> Answer:
    """Prints the events of `run` as they come and returns its answer.

    Raises:
        HeftError: whatever the run raises.
    """
    columns = (SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        view = _View(progress, progress.add_task("planning", total=None), console)
        return drive(run, view.show)


class _View:
    """What one event changes on the screen."""

    def __init__(self, progress: Progress, task: TaskID, console: Console) -> None:
        self.progress = progress
        self.task = task
        self.console = console
        self.phase = ""

    def show(self, event: Event) -> None:
        match event:
            case events.StartConfigurationFound():
                self._describe(f"planning: {event.axis} stands {event.clearance_m:.2f} m from {event.nearest}")
            case events.TransferPlanned():
                self._describe(f"planning: path to {event.axis}, {event.robot_s:.1f} s")
            case events.Planned():
                self.progress.update(self.task, total=event.robot_s, completed=0.0)
                self._tell(f"Planned in {event.plan_s:.1f} s: {event.robot_s:.0f} s of robot time.")
            case events.PhaseStarted():
                self.phase = f"{event.step}/{event.steps} {event.phase} {event.toward}".strip()
                self._describe(self.phase)
            case events.Progress():
                mass = None if event.estimate_phi is None else event.estimate_phi[0]
                known = "" if mass is None else f", {mass:.3f} kg so far"
                self._describe(f"{self.phase}{known}")
                self.progress.update(self.task, completed=event.done_s, total=event.total_s)
            case events.RobotStopped():
                self.console.print(f"[bold]{event.error}[/bold]: {event.message}")
            case events.TargetReached():
                self._tell(event.message.text)
            case events.RecordingWritten():
                self._tell(f"Recording: {event.folder} ({event.samples} samples)")
            case _:
                return

    def _describe(self, text: str) -> None:
        self.progress.update(self.task, description=text)

    def _tell(self, text: str) -> None:
        if self.console.is_terminal:
            self.console.print(text)
