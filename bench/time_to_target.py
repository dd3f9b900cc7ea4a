"""Robot time to 1 % of inertia and 0.1 % of mass (half-widths of 95 % intervals), against today's plan carried out as a whole.

    python -m bench.time_to_target [ROBOT ...] [--target mass=0.1%,inertia=1%] [--seed N]

Each robot carries the steel block of `lwr4_bench` with a sensor whose calibration is stated to 0.01 %, so that time decides and not type B.
Prints for each robot both times, what was reached, and their ratio; in the end the median (wanted: at most 0.6).
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from statistics import median

from core.cell.cell import Cell
from core.cell.folder import find_cell, load_cell
from core.errors import Refused, Stopped
from core.events import drive
from core.payload.calibration import SensorCalibration
from core.payload.site import Site
from core.procedure.identify import identify
from core.procedure.outcome import Outcome
from core.requirement.target import Target, TargetCheck, parse_target
from core.requirement.target_answer import TargetPart, hold_against_target
from core.sessions.simulated import SimulatedSession
from tests.real_robots import ROBOTS, real_cell

WANTED = 0.6
SHIPPED = ("lwr4_bench", "ur5e_line")
BLOCK = load_cell(find_cell(SHIPPED[0])).payloads["steel_block"]
CALIBRATION = SensorCalibration(gain_std=(1e-4,) * 6, crosstalk_std=(5e-5,) * 6, source="made up for the bench")


def calibrate(cell: Cell) -> Cell:
    """The cell with everything stated well enough that repetitions, and nothing else, decide."""
    sensor = cell.sensor.model_copy(update={"calibration": CALIBRATION, "mount_std_rad": 1e-5})
    robot = cell.robot.model_copy(update={"zero_std_rad": 1e-5})
    return cell.model_copy(update={"sensor": sensor, "robot": robot, "site": Site(latitude_deg=48.1)})


def load(name: str, folder: Path) -> Cell:
    """A shipped cell, or a robot of `tests.real_robots` on a table."""
    return load_cell(find_cell(name)) if name in SHIPPED else real_cell(name, folder / name, payload_box=BLOCK.box)


def carry_out(cell: Cell, seed: int, target: Target | None) -> Outcome:
    """A run in simulation, as a whole where there is no target."""
    session = SimulatedSession(cell, BLOCK.parameters, seed=seed)
    return drive(identify(cell, session, BLOCK.box, reference=BLOCK, seed=seed, target=target))


def say(found: TargetPart | None) -> str:
    """Standing and how much of the target each quantity uses."""
    if found is None:
        return ""
    parts = [f"{each.quantity} {each.half_width / each.wanted:.0%}" for each in found.quantities if each.half_width and each.wanted]
    return f"{found.standing} ({', '.join(parts)})"


def main() -> None:
    """Prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("robots", nargs="*", default=[*SHIPPED, *ROBOTS])
    parser.add_argument("--target", default="mass=0.1%,inertia=1%")
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    target, ratios = parse_target(asked.target), []
    with tempfile.TemporaryDirectory() as folder:
        for name in asked.robots:
            try:
                cell = load(name, Path(folder))
            except RuntimeError as error:  # no configuration is free
                print(f"{name}: {error}", flush=True)
                continue
            try:
                whole, early = (carry_out(calibrate(cell), asked.seed, each) for each in (None, target))
            except (Refused, Stopped) as error:
                print(f"{name}: {type(error).__name__}: {str(error)[:100]}", flush=True)
                continue
            ratio = early.robot_s / whole.robot_s
            of_whole = hold_against_target(TargetCheck(target), whole.identification.estimate)
            print(f"{name}: {whole.robot_s:.1f} s {say(of_whole)}, {early.robot_s:.1f} s {say(early.target)}: {ratio:.2f}", flush=True)
            ratios.append(ratio)
    if ratios:
        print(f"{len(ratios)} robots: median {median(ratios):.2f}, {min(ratios):.2f} to {max(ratios):.2f} (wanted at most {WANTED})")


if __name__ == "__main__":
    main()
