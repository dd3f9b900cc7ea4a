"""`heft fake`: a server that speaks a real controller's protocol, moved by the virtual robot, to try a driver without a robot."""

from __future__ import annotations

import time
from contextlib import nullcontext
from typing import Annotated

import typer

from core.cell.folder import find_cell, load_cell
from core.cli.options import CellArgument, PayloadOption, SeedOption, choose_payload
from core.cli.terminal import find_wording, messages
from core.errors import BadInput
from core.fakes.ati_server import AtiServer, Setup
from core.fakes.ur_arm import UrArm
from core.fakes.ur_server import UrServer

app = typer.Typer()
RDT_PORT, PAGES_PORT = 49152, 8049


@app.callback()
def choose() -> None:
    """A server that speaks a real controller's protocol, moved by the virtual robot."""


@app.command("ur")
def serve_ur(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    host: Annotated[str, typer.Option(metavar="ADDRESS", help="Address to listen at, of this computer.")] = "127.0.0.1",
    patience: Annotated[
        float | None,
        typer.Option(metavar="S", help="How long each period waits for its command, for a computer that is busy; none as on a real robot."),
    ] = None,
    ati: Annotated[bool, typer.Option("--ati", help="With an ATI Net F/T box on its flange: RDT 49152, pages 8049.")] = False,
) -> None:
    """A Universal Robots e-series controller (RTDE 30004, secondary interface 30002, dashboard 29999) with the cell's virtual robot."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    arm = UrArm(loaded, carried.parameters, seed)
    if len(arm.q) != 6:
        raise BadInput("cell", "cli-fake-not-six-joints", count=len(arm.q))
    server = UrServer(arm, host, patience_s=patience)
    try:
        with server, _attach_box(arm) if ati else nullcontext():
            if ati:
                messages.print(find_wording().say("cli-fake-serves-ati", rdt=str(RDT_PORT), pages=str(PAGES_PORT)), soft_wrap=True)
            messages.print(find_wording().say("cli-fake-serves", host=host, model=arm.model, serial=arm.serial), soft_wrap=True)
            while True:
                time.sleep(1.0)
    except OSError as error:
        raise BadInput("--host", "cli-fake-no-address", host=host, reason=error.strerror or "") from error
    except KeyboardInterrupt:
        said = find_wording().say("cli-fake-served", followed=arm.periods_followed, missed=arm.missed, late=server.late_periods)
        messages.print(said, soft_wrap=True)


def _attach_box(arm: UrArm) -> AtiServer:
    """A box that reports what acts on the arm's sensor; the arm's samples have what it exerts."""
    ranges = ";".join(f"{value:g}" for value in arm.cell.sensor.range)
    return AtiServer(lambda _: (-arm.samples[-1].wrench).tolist(), setup=Setup(ranges=ranges), rdt_port=RDT_PORT, http_port=PAGES_PORT)
