"""The procedure through each driver, against a server of its protocol at the protocol's own rate: commands missed, latency, faults.

`python -m bench.drivers [ur xarm kuka franka] [--minutes 10] [--faults 20] [--patience 20]`; with a patience the server's clock waits for
each command, so that a computer that is busy with other things shows what driver and procedure do, not what it does itself.
"""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from random import Random
from types import TracebackType
from typing import Any, NamedTuple, Self

import numpy as np

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.cell.session import FrankaRobot, KukaRobot, RealRobot, UniversalRobot, XarmRobot
from core.errors import HeftError
from core.events import Event, drive
from core.fakes import ur_arm, xarm_arm
from core.fakes.franka_arm import JOINT_REFLEX, FrankaArm
from core.fakes.franka_server import FrankaServer
from core.fakes.fri_arm import FriArm
from core.fakes.fri_server import FriServer
from core.fakes.ur_arm import UrArm
from core.fakes.ur_server import UrServer
from core.fakes.xarm_arm import XarmArm
from core.fakes.xarm_server import XarmServer
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.sequence import Tally
from core.sessions.external_sensor import ExternalSensorSession
from core.sessions.opening import DRIVERS, Simulation, open_robot_session
from core.sessions.session import RobotSession

CELL = load_cell(find_cell("ur5e_line"))
LBR_CELL = load_cell(find_cell("lwr4_bench"))
FRANKA_CELL = LBR_CELL.model_copy(update={"robot": LBR_CELL.robot.model_copy(update={"acceleration_rad_s2": (10.0,) * 7})})
CARRIED_NAME = "steel_block"
CARRIED = CELL.payloads[CARRIED_NAME]
NOT_SIMULATED = Simulation(None)
XARM_PORT = 5020
FRI_CLIENT = "127.76.0.1"
Server = UrServer | XarmServer | FriServer | FrankaServer


class Robot(NamedTuple):
    """A driver and what stands in for its controller.

    Args:
        host: of the long runs; those of the faults are beside it. fake: arguments of `heft fake`.
        serve: with the seed of the arm, at an address.
        before, during: faults that are there from the start, and those that come while it moves.
    """

    title: str
    host: str
    fake: tuple[str, ...]
    link: type[RealRobot]
    said: dict[str, Any]
    serve: Callable[[int, str, float | None], Server]
    before: dict[str, Callable[[Any, Random], None]]
    during: dict[str, Callable[[Any, Random], None]]
    cell: Cell = CELL

    def cell_at(self, host: str) -> Cell:
        return self.cell.model_copy(update={"session": self.link.model_validate({**self.said, "host": host})})


def serve_ur(seed: int, host: str, patience_s: float | None) -> Server:
    return UrServer(UrArm(CELL, CARRIED.parameters, seed=seed), host, patience_s=patience_s)


def serve_xarm(seed: int, host: str, patience_s: float | None) -> Server:
    return XarmServer(XarmArm(CELL, CARRIED.parameters, seed=seed), host, port=XARM_PORT, patience_s=patience_s)


def serve_kuka(seed: int, host: str, patience_s: float | None) -> Server:
    return FriServer(FriArm(LBR_CELL, CARRIED.parameters, seed=seed), host, client=FRI_CLIENT, patience_s=patience_s)


def serve_franka(seed: int, host: str, patience_s: float | None) -> Server:
    return FrankaServer(FrankaArm(FRANKA_CELL, CARRIED.parameters, seed=seed), host, patience_s=patience_s)


class ArmClock:
    """The stand-in's own time, a moment later, as far as nobody has waited for longer: the server's clock may go by answers."""

    def __init__(self, arm: FriArm | FrankaArm) -> None:
        self._arm, self._waited = arm, 0.0

    def __call__(self) -> float:
        return max(self._waited, 1000.0 + self._arm.t + 1e-4)

    def wait(self, seconds: float) -> None:
        self._waited = self() + seconds


class ArmSensor(ForceSensor):
    """What is on the flange of the stand-in, once per period of its drives, without a line that could lose it."""

    name = "sensor"

    def __init__(self, arm: FriArm | FrankaArm, clock: ArmClock) -> None:
        self._arm, self._clock, self._told = arm, clock, -1.0
        self.tally = Tally()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None) -> None:
        """Nothing is open."""

    def read(self, wait_s: float = 0.0) -> list[Reading]:
        arm = self._arm
        if arm.t <= self._told:
            self._clock.wait(wait_s)
            return []
        self._told, samples = arm.t, arm.samples
        step = arm.period / len(samples)
        self.tally.received += len(samples)
        return [Reading(arm.t - step * (len(samples) - 1 - k), self._clock(), -sample.wrench) for k, sample in enumerate(samples)]


def open_session(cell: Cell, server: Server) -> RobotSession:
    """Of the driver, with the sensor on the flange where the robot has none of its own."""
    session = DRIVERS[cell.session.driver](cell)
    if not isinstance(server, FriServer | FrankaServer):
        return session
    clock = ArmClock(server.arm)
    return ExternalSensorSession(session, ArmSensor(server.arm, clock), clock=clock)


def run_procedure(cell: Cell, session: RobotSession) -> Generator[Event, None, Outcome]:
    start = session.find_start()
    return identify(cell, session, CARRIED.box, payload=CARRIED_NAME, reference=CARRIED, start=start, clock_waits=False)


def ignore(_: Event) -> None:
    """Nobody listens."""


@contextmanager
def serve_here(robot: Robot, patience_s: float) -> Iterator[Callable[[Cell], RobotSession]]:
    """The stand-in in this program, for a sensor that goes by its clock; with what it counted at the end."""
    with robot.serve(1, robot.host, patience_s) as server:
        yield lambda cell: open_session(cell, server)
        print(f"  {server.arm.periods_followed} periods under command, {server.arm.missed} of them without a new command", flush=True)


@contextmanager
def serve_apart(robot: Robot, patience_s: float | None) -> Iterator[Callable[[Cell], RobotSession]]:
    """The stand-in as a program of its own, as a controller is another computer; ended with what it counted as its last line."""
    patience = [] if patience_s is None else ["--patience", str(patience_s)]
    options = ["--host", robot.host, "--payload", CARRIED_NAME, "--seed", "1", *patience]
    command = [sys.executable, "-m", "core.cli", "fake", *robot.fake, *options]
    signal.signal(signal.SIGINT, signal.default_int_handler)  # what a shell ignores in the background the stand-in would ignore, too
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as served:
        try:
            assert served.stdout is not None
            said = served.stdout.readline()
            if robot.host not in said:
                raise RuntimeError(said + served.stdout.read())
            yield lambda cell: open_robot_session(cell, NOT_SIMULATED)
        finally:
            served.send_signal(signal.SIGINT)
            print("  " + served.communicate()[0].strip(), flush=True)


def measure_procedure(robot: Robot, minutes: float, patience_s: float | None) -> None:
    """Procedures one after the other until the time is over."""
    cell = robot.cell_at(robot.host)
    assert isinstance(cell.session, RealRobot)
    # a box on a line of its own goes by the wall clock, which a clock that waits leaves behind
    here = patience_s is not None and cell.session.sensor is not None
    with serve_here(robot, patience_s or 0.0) if here else serve_apart(robot, patience_s) as open_it:
        began, runs = time.monotonic(), 0
        while not runs or time.monotonic() < began + 60.0 * minutes:
            try:
                outcome = drive(run_procedure(cell, open_it(cell)), ignore)
            except HeftError as error:
                print(f"  ended: {type(error).__name__}: {error}")
                break
            runs += 1
            estimate = outcome.identification.estimate
            mass, std = (np.nan, np.nan) if estimate is None else (estimate.phi[0], estimate.std[0])
            known = 0 if estimate is None else int(np.isfinite(estimate.phi).sum())
            print(
                f"  procedure {runs}: {outcome.robot_s:.0f} s of motion, mass {mass:.4f} ± {1.96 * std:.4f} kg "
                f"(true {CARRIED.mass_kg} kg), {known} of 10 parameters determined",
                flush=True,
            )
        print(f"  {runs} procedures in {(time.monotonic() - began) / 60.0:.1f} min; the server's count:")


def make_lossy(server: Server, _: Random) -> None:
    server.loss = 0.05


def make_jittery(server: Server, _: Random) -> None:
    server.jitter_s = 0.02


def make_outage(server: Server, random: Random) -> None:
    def cut() -> None:
        server.cut = True
        time.sleep(1.0)
        server.cut = False

    threading.Timer(random.uniform(0.3, 2.5), cut).start()


def order_later(server: Server, random: Random, what: Callable[[], None]) -> None:
    threading.Timer(random.uniform(0.3, 2.5), lambda: server.order(what)).start()


def make_ur_emergency(server: UrServer, random: Random) -> None:
    order_later(server, random, lambda: server.arm.stop_safely(ur_arm.EMERGENCY))


def make_xarm_emergency(server: XarmServer, random: Random) -> None:
    order_later(server, random, lambda: server.arm.fail(xarm_arm.EMERGENCY))


def change_mode(server: XarmServer, random: Random) -> None:
    order_later(server, random, lambda: server.arm.set_mode(xarm_arm.POSITION))


def make_kuka_stop(server: FriServer, random: Random) -> None:
    order_later(server, random, lambda: server.arm.stop_safely(1))


def end_application(server: FriServer, random: Random) -> None:
    order_later(server, random, server.arm.end_motion)


def make_deaf(server: FriServer | FrankaServer, random: Random) -> None:
    order_later(server, random, lambda: setattr(server, "deaf", True))


def make_ur_old(server: UrServer, _: Random) -> None:
    server.arm.version = (5, 4, 0, 0)


def make_xarm_old(server: XarmServer, _: Random) -> None:
    server.arm.version = "v1.12.8"


def make_reflex(server: FrankaServer, random: Random) -> None:
    order_later(server, random, lambda: server.arm.fail(JOINT_REFLEX))


def press_user_stop(server: FrankaServer, random: Random) -> None:
    order_later(server, random, server.arm.press_user_stop)


def make_franka_old(server: FrankaServer, _: Random) -> None:
    server.arm.version, server.arm.model = 4, "panda"


def make_uncalibrated(server: Server, random: Random) -> None:
    server.arm.stretch = random.choice([-1, 1]) * random.uniform(0.006, 0.03)


def swap_joints(server: Server, random: Random) -> None:
    order = server.arm.order
    i, j = random.sample(range(len(order)), 2)
    order[i], order[j] = order[j], order[i]


LINE: dict[str, Callable[[Any, Random], None]] = {
    "5 % lost packets": make_lossy,
    "20 ms jitter": make_jittery,
}
OUTAGE: dict[str, Callable[[Any, Random], None]] = {"1 s outage": make_outage}
ANOTHER: dict[str, Callable[[Any, Random], None]] = {"wrong calibration": make_uncalibrated, "wrong joint order": swap_joints}
ROBOTS = {
    "ur": Robot(
        "Universal Robots",
        "127.77.0.1",
        ("ur", "ur5e_line"),
        UniversalRobot,
        {"driver": "ur_rtde", "model": "UR5e"},
        serve_ur,
        LINE | {"wrong version": make_ur_old} | ANOTHER,
        OUTAGE | {"emergency stop": make_ur_emergency},
    ),
    "xarm": Robot(
        "UFACTORY",
        "127.77.0.2",
        ("xarm", "ur5e_line", "--port", str(XARM_PORT)),
        XarmRobot,
        {"driver": "xarm", "model": "xArm6", "port": XARM_PORT},
        serve_xarm,
        LINE | {"wrong version": make_xarm_old} | ANOTHER,
        OUTAGE | {"emergency stop": make_xarm_emergency, "mode changed": change_mode},
    ),
    "kuka": Robot(
        "KUKA",
        "127.77.0.3",
        ("kuka", "lwr4_bench", "--client", FRI_CLIENT),
        KukaRobot,
        {"driver": "kuka_fri", "listen": FRI_CLIENT, "sensor": {"driver": "ati_net_ft", "host": "127.0.0.1", "http_port": 8049}},
        serve_kuka,
        LINE | ANOTHER,
        OUTAGE | {"safety stop": make_kuka_stop, "application ended": end_application, "answers lost": make_deaf},
        LBR_CELL,
    ),
    "franka": Robot(
        "Franka",
        "127.77.0.4",
        ("franka", "lwr4_bench"),
        FrankaRobot,
        {"driver": "franka_fci", "model": "fr3", "sensor": {"driver": "ati_net_ft", "host": "127.0.0.1", "http_port": 8049}},
        serve_franka,
        LINE | {"wrong version": make_franka_old} | ANOTHER,
        OUTAGE | {"reflex": make_reflex, "user stop": press_user_stop, "commands lost": make_deaf},
        FRANKA_CELL,
    ),
}


def move_with_fault(robot: Robot, name: str, seed: int) -> str:
    """Three seconds of motion under a fault; what came of it."""
    random = Random(seed)
    host = f"127.78.{seed % 200}.{2 + seed // 200}"
    with robot.serve(seed, host, None) as server:
        home = server.arm.q.copy()
        session = open_session(robot.cell_at(host), server)
        seen = []
        if name in robot.before:
            robot.before[name](server, random)
        try:
            with session:
                if name in robot.during:
                    robot.during[name](server, random)
                q = session.state().q_cmd
                # each joint at a speed of its own, so that no two can be confused
                speeds = 0.1 * np.where(np.arange(q.size) % 2, -1.0, 1.0) * np.linspace(0.6, 1.0, q.size)
                for k in range(round(3.0 / session.period)):
                    seen.append(session.state())
                    q = q + session.period * min(1.0, 5.0 * k * session.period) * speeds
                    session.command(q)
            outcome = "went on"
        except HeftError as error:
            outcome = type(error).__name__
        time.sleep(1.2)  # an outage is over by then, and what waited in the line has come
        stands = server.arm.q.copy()
        time.sleep(0.3)
        still = np.abs(server.arm.q - stands).max() < 1e-4
        stamps = np.array([state.t for state in seen])
        honest = bool((np.diff(stamps) > 0).all()) if len(stamps) > 1 else True
        moved = np.abs(stands - home).max() > 1e-3
        return f"{outcome}, {'stands' if still else 'MOVES'}{'' if moved else ', never moved'}{'' if honest else ', SAMPLES REPEATED'}"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("robots", nargs="*", default=list(ROBOTS), help=f"of {', '.join(ROBOTS)}")
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--faults", type=int, default=20)
    parser.add_argument("--patience", type=float)
    given = parser.parse_args()
    if unknown := sorted(set(given.robots) - set(ROBOTS)):
        parser.error(f"no such robot: {', '.join(unknown)}; there are {', '.join(ROBOTS)}")
    for robot in (ROBOTS[name] for name in given.robots):
        for name in (robot.before | robot.during) if given.faults else ():
            found = Counter(move_with_fault(robot, name, seed) for seed in range(given.faults))
            print(f"{robot.title}, {name}: " + "; ".join(f"{count} x {what}" for what, count in found.most_common()), flush=True)
        if given.minutes:
            print(f"the whole procedure, {robot.title}:", flush=True)
            measure_procedure(robot, given.minutes, given.patience)


if __name__ == "__main__":
    main()
