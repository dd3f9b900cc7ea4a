"""`heft fake`: a server that speaks a real controller's protocol, moved by the virtual robot, to try a driver without a robot."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from typing import Annotated

import numpy as np
import typer

from core.array import Array
from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cli.options import CellArgument, PayloadOption, SeedOption, choose_payload
from core.cli.terminal import find_wording, messages
from core.errors import BadInput
from core.fakes.ati_server import AtiServer, Setup
from core.fakes.franka_arm import FrankaArm
from core.fakes.franka_protocol import PORT as FCI_PORT
from core.fakes.franka_server import FrankaServer
from core.fakes.fri_arm import FriArm
from core.fakes.fri_server import PORT as FRI_PORT
from core.fakes.fri_server import FriServer
from core.fakes.paced_server import PacedServer
from core.fakes.ur_arm import UrArm
from core.fakes.ur_server import UrServer
from core.fakes.xarm_arm import XarmArm
from core.fakes.xarm_server import CONTROL_PORT, XarmServer
from core.plant.virtual_robot import VirtualRobot

app = typer.Typer()
RDT_PORT, PAGES_PORT = 49152, 8049


@app.callback()
def choose() -> None:
    """A server that speaks a real controller's protocol, moved by the virtual robot."""


HostOption = Annotated[str, typer.Option("--host", metavar="ADDRESS", help="Address to listen at, of this computer.")]
PatienceOption = Annotated[
    float | None,
    typer.Option(
        "--patience", metavar="S", help="How long each period waits for its command, for a computer that is busy; none as on a real robot."
    ),
]
UR_PORTS, XARM_PORTS = "30002, 30004, 29999", "30000-30003"


@app.command("ur")
def serve_ur(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    host: HostOption = "127.0.0.1",
    patience: PatienceOption = None,
    ati: Annotated[bool, typer.Option("--ati", help="With an ATI Net F/T box on its flange: RDT 49152, pages 8049.")] = False,
) -> None:
    """A Universal Robots e-series controller (RTDE 30004, secondary interface 30002, dashboard 29999) with the cell's virtual robot."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    arm = UrArm(loaded, carried.parameters, seed)
    if len(arm.q) != 6:
        raise BadInput("cell", "cli-fake-not-six-joints", count=len(arm.q))
    server = UrServer(arm, host, patience_s=patience)
    with _tell_no_address(host, UR_PORTS), server, _make_box(lambda: arm.samples[-1].wrench, loaded) if ati else nullcontext():
        if ati:
            _say_box()
        _serve(server, arm, arm.model, arm.serial)


@app.command("xarm")
def serve_xarm(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    host: HostOption = "127.0.0.1",
    port: Annotated[
        int, typer.Option(metavar="PORT", min=1, max=65535, help="Of the control, session.port; below 1024 administrators only.")
    ] = CONTROL_PORT,
    patience: PatienceOption = None,
) -> None:
    """A UFACTORY xArm controller with a six-axis sensor (control 502, reports 30000 to 30003) with the cell's virtual robot."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    arm = XarmArm(loaded, carried.parameters, seed)
    if not 5 <= arm.n <= 7:
        raise BadInput("cell", "cli-fake-not-five-to-seven-joints", count=arm.n)
    server = XarmServer(arm, host, port=port, patience_s=patience)
    with _tell_no_address(host, f"{port}, {XARM_PORTS}"), server:
        _serve(server, arm, f"xArm{arm.n}", arm.serial)


@app.command("kuka")
def serve_kuka(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    host: HostOption = "127.0.0.1",
    client: Annotated[str, typer.Option(metavar="ADDRESS", help="Where it sends to: the computer that runs `heft run`.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(metavar="PORT", min=1, max=65535, help="UDP port there, session.port.")] = FRI_PORT,
    period: Annotated[int, typer.Option(metavar="MS", min=1, max=10, help="How often it sends, session.send_period_ms.")] = 2,
    fri: Annotated[int, typer.Option(metavar="N", min=1, max=2, help="Version of FRI: 1 tells no pose of its own, 2 does.")] = 2,
) -> None:
    """A KUKA LBR over FRI with the cell's virtual robot, and an ATI Net F/T box on its flange (RDT 49152, pages 8049)."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    arm = FriArm(loaded, carried.parameters, seed, period_ms=period, version=fri)
    if arm.n != 7:
        raise BadInput("cell", "cli-fake-not-seven-joints", count=arm.n)
    server = FriServer(arm, host, client=client, port=port)
    with _tell_no_address(host, f"{RDT_PORT}, {PAGES_PORT}"), server, _make_box(lambda: arm.samples[-1].wrench, loaded):
        messages.print(find_wording().say("cli-fake-sends", host=host, client=client, port=str(port), period=period), soft_wrap=True)
        _say_box()
        _wait_for_the_end(server, arm)


@app.command("franka")
def serve_franka(
    cell: CellArgument,
    payload: PayloadOption = None,
    seed: SeedOption = 0,
    host: HostOption = "127.0.0.1",
    port: Annotated[int, typer.Option(metavar="PORT", min=1, max=65535, help="TCP port of the interface, session.port.")] = FCI_PORT,
    server_version: Annotated[
        int, typer.Option("--server-version", metavar="N", min=5, max=10, help="Of the interface: 5 is a Panda's, 6 to 10 a Research 3's.")
    ] = 10,
) -> None:
    """A Panda or Franka Research 3 over FCI with the cell's virtual robot, and an ATI Net F/T box on its flange (RDT 49152, pages 8049)."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    if len(loaded.robot.home_rad) != 7:
        raise BadInput("cell", "cli-fake-not-seven-joints", count=len(loaded.robot.home_rad))
    arm = FrankaArm(loaded, carried.parameters, seed, version=server_version)
    server = FrankaServer(arm, host, port=port)
    with _tell_no_address(host, f"{port}, {RDT_PORT}, {PAGES_PORT}"), server, _make_box(lambda: arm.samples[-1].wrench, loaded):
        messages.print(
            find_wording().say("cli-fake-serves-franka", host=host, port=str(port), model=arm.model, version=server_version), soft_wrap=True
        )
        _say_box()
        _wait_for_the_end(server, arm)


@contextmanager
def _tell_no_address(host: str, ports: str) -> Iterator[None]:
    """Raises BadInput where nothing can listen there."""
    try:
        yield
    except PermissionError as error:
        raise BadInput("--port", "cli-fake-not-allowed", host=host) from error
    except OSError as error:
        raise BadInput("--host", "cli-fake-no-address", host=host, reason=error.strerror or "", ports=ports) from error


def _say_box() -> None:
    """Where the sensor on the flange answers."""
    messages.print(find_wording().say("cli-fake-serves-ati", rdt=str(RDT_PORT), pages=str(PAGES_PORT)), soft_wrap=True)


def _serve(server: PacedServer, arm: UrArm | XarmArm, model: str, serial: str) -> None:
    """Until somebody has had enough."""
    messages.print(find_wording().say("cli-fake-serves", host=server.host, model=model, serial=serial), soft_wrap=True)
    _wait_for_the_end(server, arm)


def _wait_for_the_end(server: PacedServer, arm: UrArm | XarmArm | FriArm | FrankaArm) -> None:
    """Until somebody has had enough; then what was counted."""
    try:
        while True:
            time.sleep(1.0)
    except KeyboardInterrupt:
        wording = find_wording()
        said = wording.say("cli-fake-served", followed=arm.periods_followed, missed=arm.missed, late=server.late_periods)
        if server.latencies_s:
            median, most, worst = (f"{1e3 * each:.2f}" for each in np.quantile(server.latencies_s, [0.5, 0.999, 1.0]))
            said += " " + wording.say("cli-fake-latency", median=median, most=most, worst=worst)
        messages.print(said, soft_wrap=True)


@app.command("ati")
def serve_ati(cell: CellArgument, payload: PayloadOption = None, seed: SeedOption = 0) -> None:
    """An ATI Net F/T box (RDT 49152, pages 8049) on a virtual robot that holds the payload at home; `heft fake ur --ati` moves it."""
    loaded = load_cell(find_cell(cell))
    _, carried = choose_payload(loaded, payload)
    robot = VirtualRobot(loaded, carried.parameters, np.random.default_rng(seed))
    with _tell_no_address("127.0.0.1", f"{RDT_PORT}, {PAGES_PORT}"), _make_box(lambda: robot.step(robot.home).wrench, loaded):
        messages.print(find_wording().say("cli-fake-serves-ati-alone", rdt=str(RDT_PORT), pages=str(PAGES_PORT)), soft_wrap=True)
        with suppress(KeyboardInterrupt):
            while True:
                time.sleep(1.0)


def _make_box(wrench: Callable[[], Array], cell: Cell) -> AtiServer:
    """A box that reports what acts on the sensor; `wrench` is what the sensor exerts, (6,)."""
    ranges = ";".join(f"{value:g}" for value in cell.sensor.range)
    return AtiServer(lambda _: (-wrench()).tolist(), setup=Setup(ranges=ranges), rdt_port=RDT_PORT, http_port=PAGES_PORT)
