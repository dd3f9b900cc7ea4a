"""The `heft` command of the engine alone."""

from __future__ import annotations

import typer

from core.cli.commands import EngineCommands
from core.cli.terminal import EPILOG, HELP, enter, start

app = typer.Typer(
    name="heft", cls=EngineCommands, help=HELP, epilog=EPILOG, no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False
)


app.callback()(start)


def main() -> None:
    """Entry point of the engine alone."""
    enter(app)
