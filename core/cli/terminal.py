"""What every command does on a terminal: where it writes, and how an error or an interrupt ends it.

Answers go to standard output, progress and errors to standard error; in a pipe there is no progress. Exit codes: 0 done, 2 bad input,
3 refused by planning, 4 stopped by the guard, 130 interrupted. What people read is said in the language of
`find_language`; help and JSON are English.
"""

import signal
import sys
from types import FrameType
from typing import Annotated

import typer
from rich.console import Console

from core.errors import BadInput, HeftError
from core.words.catalogue import LANGUAGES, find_language
from core.words.wording import Wording

HELP = "Finds out what a robot carries, safely, with people around. Not a safety function."

EPILOG = f"Answers and errors are in the language of HEFT_LANGUAGE ({', '.join(LANGUAGES)}), else of LC_ALL, LC_MESSAGES or LANG."

answers = Console()
messages = Console(stderr=True)


def find_wording() -> Wording:
    """The words of this terminal."""
    return Wording(find_language())


def show_version(wanted: bool) -> None:
    """Prints the version of the code and ends."""
    if wanted:
        from core.version import code_version  # noqa: PLC0415  reads all sources, for this option alone

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
    except HeftError as error:
        for each in (error, *error.others) if isinstance(error, BadInput) else (error,):
            messages.print(find_wording().say("cli-error", error=each.message), highlight=False, markup=False, soft_wrap=True)
        sys.exit(error.exit_code)
    except KeyboardInterrupt:
        messages.print(find_wording().say("cli-interrupted"), highlight=False)
        sys.exit(130)


def _terminate(_signal: int, _frame: FrameType | None) -> None:
    """SIGTERM stops the robot in the same way as Ctrl-C."""
    raise KeyboardInterrupt
