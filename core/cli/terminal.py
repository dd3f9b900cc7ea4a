"""What every command does on a terminal: where it writes, and how an error or an interrupt ends it.

Answers go to standard output, progress and errors to standard error; in a pipe there is no progress. Exit codes: 0 done, 2 bad input,
3 refused by planning, 4 stopped by the guard, 130 interrupted. What people read is said in the language of
`find_language`; help and JSON are English.
"""

from __future__ import annotations

import signal
import sys
from types import FrameType
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

from core.words.catalogue import LANGUAGES, find_language

if TYPE_CHECKING:
    from core.words.wording import Wording

HELP = "Finds out what a robot carries, safely, with people around. Not a safety function."

EPILOG = f"Answers and errors are in the language of HEFT_LANGUAGE ({', '.join(LANGUAGES)}), else of LC_ALL, LC_MESSAGES or LANG."

answers = Console()
messages = Console(stderr=True)


def find_wording() -> Wording:
    """The words of this terminal."""
    from core.words.wording import Wording  # noqa: PLC0415 - help needs no messages

    return Wording(find_language())


def show_version(wanted: bool) -> None:
    """Prints the version of the code and ends."""
    if wanted:
        from core.version import code_version  # noqa: PLC0415 - reads all sources, for this option alone

        answers.print(code_version(), highlight=False)
        raise typer.Exit


VersionOption = Annotated[bool, typer.Option("--version", callback=show_version, is_eager=True, help="Show which code this is and exit.")]


def start(version: VersionOption = False) -> None:
    """What every command begins with."""


def enter(program: typer.Typer) -> None:
    """Runs a command and turns errors into a sentence each and an exit code."""
    signal.signal(signal.SIGTERM, _terminate)
    try:
        program()
    except KeyboardInterrupt:
        messages.print(find_wording().say("cli-interrupted"), highlight=False)
        sys.exit(130)
    except Exception as error:
        from core.errors import BadInput, HeftError  # noqa: PLC0415 - help meets no errors, and they take half of its time

        if not isinstance(error, HeftError):
            raise
        for each in (error, *error.others) if isinstance(error, BadInput) else (error,):
            messages.print(find_wording().say("cli-error", error=each.message), highlight=False, markup=False, soft_wrap=True)
        sys.exit(error.exit_code)


def _terminate(_signal: int, _frame: FrameType | None) -> None:
    """SIGTERM stops the robot in the same way as Ctrl-C."""
    raise KeyboardInterrupt
