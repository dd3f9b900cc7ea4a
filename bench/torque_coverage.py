"""Whether 95 % intervals from joint torques hold the truth: `python -m bench.torque_coverage --count 30`.

Three sources: a generator that shares no code with the engine (`tests.torque_recordings`, LuGre friction, wrong current constants), the
virtual robot with the friction of its drives on a motion without regard to the cell, and the same robot on the motions that
`heft plan --for joint-torques` finds; each beside a recording without payload and, where there is one, with the arm's model alone.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from core.array import Array

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.estimation.estimate import Identification
from core.estimation.joint_torques.identification import identify_by_torques
from core.events import drive
from core.gap.planned_path import path_of
from core.payload.inertia import PHI_NAMES, InertialParameters
from core.planning.stops import PlanRequest, Stops
from core.plant.virtual_robot import VirtualRobot
from core.recording.recording import Recording
from core.robot.collision import CollisionModel
from core.robot.model import RobotModel
from tests.torque_recordings import make

INTERVAL = 1.96
SECONDS = 20.0
NOTHING = InertialParameters(np.zeros(10))
OFF = (-0.1, -0.08, -0.05, 0.05, 0.08, 0.1)
"""Wrong current constants of 5 to 10 %."""


@dataclass(frozen=True)
class Pair:
    """Recordings with and without a payload, and the truth (10,)."""

    loaded: Recording
    empty: Recording
    phi: Array


def independent(seed: int) -> Pair:
    """Of the independent generator, its current constants 5 to 10 % off and nothing stated of them."""
    rng = np.random.default_rng(seed)
    made = make(seed, mass_kg=float(rng.uniform(1.0, 5.0)), same_motion=bool(seed % 2), gains=rng.choice(OFF, 6))
    return Pair(made.loaded, made.empty, made.phi)


def virtual(seed: int) -> Pair:
    """Of the virtual robot of `cells/lwr4_bench`: torques without error of gain, friction of its drives, rotors; stated 0.2 % and 2 %."""
    rng = np.random.default_rng(seed)
    cell = load_cell(find_cell("lwr4_bench"))
    payload = draw_payload(rng)
    loaded, empty = (record(cell, carried, swing(cell, rng), rng) for carried in (payload, NOTHING))
    return Pair(loaded, empty, payload.phi)


def planned(seed: int) -> Pair:
    """Of the same robot, which makes the motions that are planned for it, the same twice."""
    rng = np.random.default_rng(seed)
    cell = load_cell(find_cell("lwr4_bench"))
    q_cmd = plan_motions()
    payload = draw_payload(rng)
    loaded, empty = (record(cell, carried, q_cmd, rng) for carried in (payload, NOTHING))
    return Pair(loaded, empty, payload.phi)


def draw_payload(rng: np.random.Generator) -> InertialParameters:
    """A block of 1 to 5 kg about the sensor."""
    size = rng.uniform(0.06, 0.15, 3)
    m = float(rng.uniform(1.0, 5.0))
    return InertialParameters.from_com(m, rng.uniform(-0.04, 0.06, 3), np.diag(m / 12.0 * (size @ size - size**2)))


@cache
def plan_motions() -> Array:
    """(N, n), joint positions every millisecond of the motions that are planned in that cell for whatever its box contains."""
    cell = load_cell(find_cell("lwr4_bench"))
    robot, home = RobotModel.of_cell(cell), np.array(cell.robot.home_rad)
    asked = PlanRequest(cell, cell.payload_box, home, 0, 0.001, "rrt_connect", 0)
    plan = drive(Stops.of_joint_torques().plan(asked, robot, CollisionModel(cell, robot, cell.payload_box)))
    print(f"planned in {plan.plan_s:.0f} s: {plan.robot_s:.0f} s of motion", file=sys.stderr, flush=True)
    like = Recording(t=np.array([0.0, 0.001]), gravity=cell.gravity_in_base, robot=robot.description)
    path = path_of(plan, robot, like).q
    assert path is not None  # of an arm
    return path


def swing(cell: Cell, rng: np.random.Generator) -> Array:
    """(N, n), joint positions every millisecond of sums of sines about home, beginning and ending at rest."""
    home = np.array(cell.robot.home_rad)
    w, p = 2.0 * np.pi * rng.uniform(0.05, 0.5, (4, len(home))), rng.uniform(0.0, 2.0 * np.pi, (4, len(home)))
    a = np.minimum(0.3 / w, 0.25)
    t = np.arange(int(SECONDS * 1000)) / 1000.0
    fade = np.clip(np.minimum(t, t[-1] - t) / 2.0, 0.0, 1.0)
    rise = fade**3 * (10.0 - 15.0 * fade + 6.0 * fade**2)
    return np.asarray(home + rise[:, None] * (a * np.sin(w * t[:, None, None] + p)).sum(axis=1))


def record(cell: Cell, payload: InertialParameters, q_cmd: Array, rng: np.random.Generator) -> Recording:
    """What the robot reports while it is told joint positions (N, n), one every millisecond."""
    robot, virtual_robot = RobotModel.of_cell(cell), VirtualRobot(cell, payload, rng)
    samples = [virtual_robot.step(row) for row in q_cmd]
    q, tau = (np.array([getattr(sample, name) for sample in samples])[::4] for name in ("q", "tau"))
    t = np.arange(len(q_cmd))[::4] / 1000.0
    recording = Recording(t=t, gravity=cell.gravity_in_base, q=q, tau=tau, robot=robot.description)
    return replace(recording, torque_gain_std=0.002, link_mass_std=0.02)


SOURCES: dict[str, Callable[[int], Pair]] = {"independent": independent, "virtual robot": virtual, "planned motions": planned}


def main() -> None:
    """Prints for each source, with and without a recording of the bare arm: shares of the intervals that hold, and half-widths."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=30, help="pairs of each source")
    parser.add_argument("--first", type=int, default=0, help="seed of the first")
    parser.add_argument("--only", default="", help="sources whose name contains this")
    arguments = parser.parse_args()
    print(f"{'':36}" + "".join(f"{name:>9}" for name in PHI_NAMES))
    for name, source in SOURCES.items():
        if arguments.only not in name:
            continue
        both: list[tuple[Identification, Array]] = []
        alone: list[tuple[Identification, Array]] = []
        for seed in range(arguments.first, arguments.first + arguments.count):
            pair = source(seed)
            both.append((identify_by_torques(pair.loaded, pair.empty), pair.phi))
            alone.append((identify_by_torques(pair.loaded), pair.phi))
            print(f"{name} {seed}: {_off(*both[-1])} with and without, {_off(*alone[-1])} alone", file=sys.stderr, flush=True)
        show(f"{name}, with and without", both)
        show(f"{name}, arm's model alone", alone)


def _off(found: Identification, phi: Array) -> str:
    """By how many standard uncertainties each parameter is off."""
    return "-" if found.estimate is None else " ".join(f"{z:.1f}" for z in (found.estimate.phi - phi) / found.estimate.std)


def show(name: str, found: list[tuple[Identification, Array]]) -> None:
    """Coverage in %, median half-width and by repeatability alone, of what is determined."""
    estimates = [(each.estimate, phi) for each, phi in found if each.estimate is not None]
    z = np.array([(estimate.phi - phi) / estimate.std for estimate, phi in estimates])
    given = np.isfinite(z)
    shares = 100.0 * (given & (np.abs(np.nan_to_num(z)) <= INTERVAL)).sum(axis=0) / np.maximum(given.sum(axis=0), 1)
    half = INTERVAL * np.array([estimate.std for estimate, _ in estimates])
    alone = INTERVAL * np.sqrt([np.diag(estimate.budget.repeatability) for estimate, _ in estimates])
    print(
        f"{name + ', % held':36}"
        + "".join(f"{share:9.0f}" if n else f"{'-':>9}" for share, n in zip(shares, given.sum(axis=0), strict=True))
    )
    print(f"{'  determined, of ' + str(len(found)):36}" + "".join(f"{n:9d}" for n in given.sum(axis=0)))
    for title, x in (("  median half-width", half), ("  repeatability alone", alone)):
        print(f"{title:36}" + "".join(f"{_median(column):9.2g}" for column in x.T), flush=True)


def _median(x: Array) -> float:
    return float(np.median(x[np.isfinite(x)])) if np.isfinite(x).any() else float("nan")


if __name__ == "__main__":
    main()
