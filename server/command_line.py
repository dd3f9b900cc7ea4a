"""`heft` with the service: the engine's commands, and `serve` and `audit verify`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from core.cli.commands import EngineCommands
from core.cli.terminal import EPILOG, HELP, answers, enter, start
from core.words.catalogue import find_language

app = typer.Typer(
    name="heft", cls=EngineCommands, help=HELP, epilog=EPILOG, no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False
)
app.callback()(start)
audit = typer.Typer(help="The log of what was done, by whom.", no_args_is_help=True)
app.add_typer(audit, name="audit")

DataOption = Annotated[Path | None, typer.Option(metavar="DIR", help="Folder of the database and the recordings. [default: data]")]


@app.command()
def serve(
    host: Annotated[str | None, typer.Option(help="Address to listen on. [default: 127.0.0.1]")] = None,
    port: Annotated[int | None, typer.Option(min=0, max=65535, help="Port to listen on; 0 takes a free one. [default: 8000]")] = None,
    cells: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder with one folder per cell. [default: cells in the data folder]")
    ] = None,
    data: DataOption = None,
) -> None:
    """Start the service for operator, MES and watchers. Every setting is also an environment variable HEFT_*."""
    from server.serve import run_service as start  # noqa: PLC0415 - the other commands need no web

    start(host=host, port=port, cells=cells, data=data)


@app.command(hidden=True)
def openapi(file: Annotated[Path, typer.Argument(metavar="FILE", help="Where to write it; it appears only when it is whole.")]) -> None:
    """Write the OpenAPI description, from which clients are generated. Nothing is started."""
    from server.serve import write_openapi  # noqa: PLC0415 - the other commands need no web

    write_openapi(file)


@audit.command()
def verify(
    data: DataOption = None,
    expect: Annotated[str | None, typer.Option(metavar="HASH", help="A hash seen earlier, which the chain must still contain.")] = None,
) -> None:
    """Check that nothing in the audit log was changed, removed or put in between."""
    from server.serve import verify_audit  # noqa: PLC0415 - the other commands need no store

    answers.print(verify_audit(data, expect).say(find_language()), highlight=False, soft_wrap=True)


def main() -> None:
    """Entry point."""
    enter(app)
