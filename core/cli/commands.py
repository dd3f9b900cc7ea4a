"""The engine's commands: name, what it does in a sentence, and the module that is imported when it is asked for."""

from __future__ import annotations

import atexit
import gc
from importlib import import_module
from typing import Any, NamedTuple

from typer.core import TyperCommand, TyperGroup
from typer.main import get_command


class Command(NamedTuple):
    """A command or a group of them.

    Args:
        module: has the command as `app`.
    """

    module: str
    summary: str


COMMANDS = {
    "run": Command(
        "core.cli.run",
        "Plan and run the procedure on the cell's robot, identify the payload, write recording, answer and report. "
        "The robot is simulated unless cell.toml names a real one.",
    ),
    "identify": Command("core.cli.identify", "Identify the payload from a recording, or from another program's log. Either is only read."),
    "import": Command(
        "core.cli.import_log",
        "Make a recording of another program's log: show what its columns are taken for, and check that they agree with each other.",
    ),
    "export-recording": Command(
        "core.cli.export_recording",
        "Write a recording as PlotJuggler, Foxglove and `ros2 bag` open it: MCAP with messages of ROS 2, or CSV.",
    ),
    "compare": Command(
        "core.cli.compare", "Whether several runs found the same payload, and how they scatter: repeatability and reproducibility."
    ),
    "fuse": Command(
        "core.cli.fuse", "One answer from several runs of one payload, with the share that each of them and a prior has in it."
    ),
    "diagnose": Command(
        "core.cli.diagnose",
        "Where simulation and recording part, which unmodelled effect causes it, and how far adding it closes the gap.",
    ),
    "trial": Command(
        "core.cli.trials", "The blind check: plant faults in the virtual robot, seal the answer, diagnose, open the seal, score."
    ),
    "export": Command(
        "core.cli.exports",
        "Write the payload as a robot's controller or a simulator takes it, on standard output; say what that cannot hold.",
    ),
    "certificate": Command("core.cli.certificate", "Write the certificate of a finished run: one page for the record, as PDF and as JSON."),
    "requirement": Command(
        "core.cli.requirement", "Say how exactly the controller has to know its payload, and whether an answer is good enough for it."
    ),
    "plan": Command("core.cli.plan", "Plan the procedure and show start configurations, distances and times. Nothing moves."),
    "cells": Command("core.cli.list_cells", "List the cells at hand, and what keeps any of them from being used."),
    "twin": Command("core.cli.twins", "What has been added to a cell's simulation."),
    "fake": Command("core.cli.fake", "A server that speaks a real controller's protocol, moved by the virtual robot."),
    "cell": Command("core.cli.cells", "Make a cell from a robot's description, and look for what is wrong in one."),
}


class EngineCommands(TyperGroup):
    """The engine's commands, and those of the program that has them; a list of commands imports none."""

    def __init__(self, **options: Any) -> None:
        super().__init__(**options)
        listed = {name: TyperCommand(name, help=command.summary) for name, command in COMMANDS.items()}
        self.commands = {**listed, **self.commands}

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """The command that is asked for, imported."""
        name, command, rest = super().resolve_command(ctx, args)
        if name in COMMANDS:
            gc.disable()  # nothing of what is imported is garbage, and looking for some takes a tenth of a short command
            command = get_command(import_module(COMMANDS[name].module).app)
            gc.freeze()
            atexit.register(gc.unfreeze)  # what libraries hold is let go before they look whether it was
            gc.enable()
            command.name = name
        return name, command, rest
