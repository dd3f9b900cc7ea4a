"""The procedure through each driver, against a server of its protocol at the protocol's own rate: commands missed, latency, faults.

`python -m bench.drivers [--minutes 10] [--faults 20] [--patience 20]`; with a patience the server's clock waits for each command, so that a
computer that is busy with other things shows what driver and procedure do, not what it does itself.
"""

from __future__ import annotations

import argparse
import threading
import time
from collections import Counter
from collections.abc import Callable, Generator
from pathlib import Path
from random import Random

import numpy as np

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cell.session import UniversalRobot
from core.errors import HeftError
from core.events import Event, drive
from core.fakes.ur_arm import EMERGENCY, UrArm
from core.fakes.ur_server import UrServer
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.sessions.ur import UniversalRobotsSession

HOST = "127.77.0.1"
CELL = load_cell(find_cell("ur5e_line"))
CARRIED = CELL.payloads["steel_block"]


def cell_at(host: str, **said: str) -> Cell:
    link = UniversalRobot.model_validate({"driver": "ur_rtde", "host": host, "model": "UR5e", **said})
    return CELL.model_copy(update={"session": link})


def run_procedure(cell: Cell, out: Path | None = None) -> Generator[Event, None, Outcome]:
    session = UniversalRobotsSession(cell)
    start = session.find_start()
    return identify(cell, session, CARRIED.box, payload="steel_block", reference=CARRIED, start=start, clock_waits=False, out=out)


def ignore(_: Event) -> None:
    """Nobody listens."""


def measure_procedure(minutes: float, patience_s: float | None) -> None:
    """Procedures one after the other until the time is over."""
    with UrServer(UrArm(CELL, CARRIED.parameters, seed=1), HOST, patience_s=patience_s) as server:
        began, runs = time.monotonic(), 0
        while not runs or time.monotonic() < began + 60.0 * minutes:
            try:
                outcome = drive(run_procedure(cell_at(HOST)), ignore)
            except HeftError as error:
                print(f"  ended: {type(error).__name__}: {error}")
                break
            runs += 1
            estimate = outcome.identification.estimate
            mass = np.nan if estimate is None else estimate.phi[0]
            print(f"  procedure {runs}: {outcome.robot_s:.0f} s of motion, mass {mass:.4f} kg (true {CARRIED.mass_kg} kg)", flush=True)
        arm = server.arm
        latency = 1e3 * np.array(server.latencies_s or [np.nan])
        print(
            f"  {runs} procedures in {(time.monotonic() - began) / 60.0:.1f} min at {1 / 0.002:.0f} Hz: {arm.missed} of "
            f"{arm.periods_followed} periods without a new command, by the server's count; {server.late_periods} periods began late on "
            f"this computer\n  latency from sample to command: median {np.median(latency):.2f} ms, 99.9 % {np.quantile(latency, 0.999):.2f}"
            f" ms, worst {latency.max():.2f} ms"
        )


def make_lossy(server: UrServer, _: Random) -> None:
    server.loss = 0.05


def make_jittery(server: UrServer, _: Random) -> None:
    server.jitter_s = 0.02


def make_outage(server: UrServer, random: Random) -> None:
    def cut() -> None:
        server.cut = True
        time.sleep(1.0)
        server.cut = False

    threading.Timer(random.uniform(0.3, 2.5), cut).start()


def make_emergency(server: UrServer, random: Random) -> None:
    threading.Timer(random.uniform(0.3, 2.5), lambda: server.order(lambda: server.arm.stop_safely(EMERGENCY))).start()


def make_old(server: UrServer, _: Random) -> None:
    server.arm.version = (5, 4, 0, 0)


def make_uncalibrated(server: UrServer, random: Random) -> None:
    server.arm.stretch = random.choice([-1, 1]) * random.uniform(0.006, 0.03)


def swap_joints(server: UrServer, random: Random) -> None:
    i, j = random.sample(range(6), 2)
    order = server.arm.order
    order[i], order[j] = order[j], order[i]


FAULTS: dict[str, Callable[[UrServer, Random], None]] = {
    "5 % lost packets": make_lossy,
    "20 ms jitter": make_jittery,
    "1 s outage": make_outage,
    "emergency stop": make_emergency,
    "wrong version": make_old,
    "wrong calibration": make_uncalibrated,
    "wrong joint order": swap_joints,
}


def move_with_fault(fault: Callable[[UrServer, Random], None], seed: int) -> str:
    """Three seconds of motion under a fault; what came of it."""
    random = Random(seed)
    host = f"127.78.{seed % 200}.{2 + seed // 200}"
    with UrServer(UrArm(CELL, CARRIED.parameters, seed=seed), host) as server:
        home = server.arm.q.copy()
        session = UniversalRobotsSession(cell_at(host))
        seen = []
        fault(server, random)
        try:
            with session:
                q = session.state().q_cmd
                for k in range(1500):
                    seen.append(session.state())
                    q = q + 0.002 * 0.1 * min(1.0, k / 100) * np.array([1, -1, 1, -1, 1, -1])
                    session.command(q)
            outcome = "went on"
        except HeftError as error:
            outcome = type(error).__name__
        time.sleep(0.6)
        stands = server.arm.q.copy()
        time.sleep(0.3)
        still = np.abs(server.arm.q - stands).max() < 1e-4
        stamps = np.array([state.t for state in seen])
        honest = bool((np.diff(stamps) > 0).all()) if len(stamps) > 1 else True
        moved = np.abs(stands - home).max() > 1e-3
        return f"{outcome}, {'stands' if still else 'MOVES'}{'' if moved else ', never moved'}{'' if honest else ', SAMPLES REPEATED'}"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--faults", type=int, default=20)
    parser.add_argument("--patience", type=float)
    given = parser.parse_args()
    if given.faults:
        for name, fault in FAULTS.items():
            found = Counter(move_with_fault(fault, seed) for seed in range(given.faults))
            print(f"{name}: " + "; ".join(f"{count} x {what}" for what, count in found.most_common()), flush=True)
    if given.minutes:
        print("the whole procedure, Universal Robots:", flush=True)
        measure_procedure(given.minutes, given.patience)


if __name__ == "__main__":
    main()
