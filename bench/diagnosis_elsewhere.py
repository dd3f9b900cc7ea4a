"""Diagnoses where nothing is shaped like the models: other physics, and a background as real arms have it.

python -m bench.diagnosis_elsewhere [--only NAME,NAME] [--seed S] [--processes P]

The motion, the payload and its wrench are those of `tests.synthetic` (point masses, Newton's law). In the background of every recording
are zeros of 0.01 deg, a tilt of 0.03 deg, gains of 0.1 % and stamps of 0.05 ms, each a standard deviation. What is planted is written here
in numpy and shares no code with `core/effects` or `core/plant`.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path
from typing import TypeAlias

import numpy as np
from scipy.signal import lfilter
from threadpoolctl import threadpool_limits

from core.array import Array, interpolate

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.cell.folder import load_cell
from core.gap.answer import Diagnosis
from core.gap.diagnosis import examine
from core.gap.fit_all import one_by_one
from core.payload.inertia import InertialParameters
from core.recording.recording import Recording
from tests.synthetic import CELLS, GRAVITY, NOISE_STD, Imperfections, Run, payload, record, run_of, wrench_of

PERIOD_S = 0.008
ZEROS_DEG, TILT_DEG, GAIN, STAMP_S = 0.01, 0.03, 1e-3, 5e-5
CARRIED = "steel_block"


@dataclass
class Stage:
    """What a case may change before sensor and recorder see it: the wrench (N, 6) on the sensor, N and N m, and the joints as read."""

    run: Run
    body: InertialParameters
    rng: np.random.Generator
    wrench: Array
    read: Array

    @property
    def share(self) -> Array:
        """(N,), of the run that is over."""
        t = self.run.t
        return np.asarray((t - t[0]) / (t[-1] - t[0]))

    @property
    def load(self) -> Array:
        """(6,), largest magnitude of each channel."""
        return np.asarray(np.abs(self.wrench).max(axis=0))

    def push(self, force: Array, point: Array) -> None:
        """Adds forces (N, 3), base axes, that act on the payload at a point, sensor axes."""
        f = np.einsum("nji,nj->ni", self.run.rotation, force)
        self.wrench = self.wrench - np.hstack((f, np.cross(point, f)))


Case: TypeAlias = Callable[[Stage], None]
CASES: dict[str, tuple[str, Case]] = {}
"""By name: the identifier that is right, and what is planted."""


def case(right: str) -> Callable[[Case], Case]:
    """Registers a case under the name of its function."""

    def register(plant: Case) -> Case:
        CASES[plant.__name__] = (right, plant)
        return plant

    return register


@case("none")
def healthy(stage: Stage) -> None:
    """Background alone."""


@case("none")
def healthy_again(stage: Stage) -> None:
    """Background alone, with another draw."""


@case("sensor_gain")
def gain_of_one(stage: Stage) -> None:
    """Fx reads 2.5 % too much."""
    stage.wrench = stage.wrench * [1.025, 1, 1, 1, 1, 1]


@case("sensor_gain")
def gain_of_all(stage: Stage) -> None:
    """Every channel off by 1 to 2 %."""
    stage.wrench = stage.wrench * (1.0 + stage.rng.choice([-1, 1], 6) * stage.rng.uniform(0.01, 0.02, 6))


@case("sensor_crosstalk")
def crosstalk(stage: Stage) -> None:
    """Every channel shows 1 % of every other, scaled by their loads."""
    C = 0.015 * stage.rng.choice([-1, 1], (6, 6)) * (1 - np.eye(6))
    stage.wrench = stage.wrench + (stage.wrench / stage.load) @ C.T * stage.load


@case("base_tilt")
def tilt(stage: Stage) -> None:
    """0.5 deg about y."""
    angle = np.radians(0.5)
    stage.wrench = wrench_of(stage.run, stage.body, 9.81 * np.array([np.sin(angle), 0.0, -np.cos(angle)]))


@case("time_delay")
def late(stage: Stage) -> None:
    """The wrench is 14 ms late."""
    t = stage.run.t
    stage.wrench = interpolate(t - 0.014, t, stage.wrench)


@case("joint_offset")
def zero(stage: Stage) -> None:
    """The zero of the fourth joint is 1.2 deg off."""
    stage.read = stage.read - np.radians(1.2) * (np.arange(stage.read.shape[1]) == 3)


@case("sensor_drift")
def drift(stage: Stage) -> None:
    """Warms up by 1.5 N."""
    warm = 1.0 - np.exp(-3.0 * stage.share)
    stage.wrench = stage.wrench + np.outer(warm, [1.5, -0.8, 1.0, 0.03, 0.05, -0.02])


@case("sensor_drift")
def drift_of_two_kinds(stage: Stage) -> None:
    """Warms up fast one way and slowly the other."""
    t = stage.run.t - stage.run.t[0]
    both = 2.0 * (1.0 - np.exp(-t / 4.0)) - 3.0 * (1.0 - np.exp(-t / 30.0))
    stage.wrench = stage.wrench + np.outer(both, [1.0, -0.6, 0.8, 0.03, 0.04, -0.02])


@case("sensor_drift")
def drift_that_wanders(stage: Stage) -> None:
    """A random walk of 1 N in each force over the run."""
    n = len(stage.run.t)
    walk = np.cumsum(stage.rng.normal(size=(n, 6)), axis=0) / np.sqrt(n)
    stage.wrench = stage.wrench + walk * [1.0, 1.0, 1.0, 0.04, 0.04, 0.04]


@case("sensor_offset_step")
def jump(stage: Stage) -> None:
    """One jump at 55 % of the run."""
    stage.wrench = stage.wrench + np.outer(stage.share > 0.55, [1.2, -0.6, 0.9, 0.03, -0.05, 0.02])


@case("sensor_offset_step")
def several_jumps(stage: Stage) -> None:
    """Four jumps, each in all channels and another direction."""
    for at in (0.17, 0.38, 0.61, 0.83):
        jump_by = stage.rng.normal(size=6) * [1.0, 1.0, 1.0, 0.04, 0.04, 0.04]
        stage.wrench = stage.wrench + np.outer(stage.share > at, jump_by)


@case("sensor_saturation")
def clipped_hard(stage: Stage) -> None:
    """Two channels end at 45 and 60 % of their load, on both sides."""
    limit = stage.load * [0.45, 9, 9, 9, 0.6, 9]
    stage.wrench = np.clip(stage.wrench, -limit, limit)


@case("sensor_hysteresis")
def sticks_and_snaps(stage: Stage) -> None:
    """A block on a spring: what is held back stays until the spring snaps it on by two thirds of what it may hold back."""
    held = 0.03 * stage.load
    out, at = stage.wrench.copy(), stage.wrench[0].copy()
    for k, w in enumerate(stage.wrench):
        snap = np.abs(w - at) > held
        at = np.where(snap, w - np.sign(w - at) * held / 3.0, at)
        out[k] = w - 0.5 * (w - at)
    stage.wrench = out


@case("payload_mass_change")
def loses_mass(stage: Stage) -> None:
    """6 % of the payload falls off at 40 % of the run."""
    lighter = InertialParameters(0.94 * stage.body.phi)
    stage.wrench = np.where(stage.share[:, None] > 0.4, wrench_of(stage.run, lighter), stage.wrench)


@case("sensor_rotation")
def turned(stage: Stage) -> None:
    """The sensor is mounted 1.2 deg turned about its own z."""
    c, s = np.cos(np.radians(1.2)), np.sin(np.radians(1.2))
    R = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
    stage.wrench = np.hstack((stage.wrench[:, :3] @ R.T, stage.wrench[:, 3:] @ R.T))


@case("structure_vibration")
def floor_shakes(stage: Stage) -> None:
    """The floor shakes at 5 Hz with 0.3 m/s2: every mass feels it."""
    a = 0.3 * np.sin(2.0 * np.pi * 5.0 * stage.run.t)[:, None] * [0.8, 0.5, 0.33]
    still = wrench_of(stage.run, stage.body)
    run = replace(stage.run, a=stage.run.a + a)
    stage.wrench = stage.wrench + wrench_of(run, stage.body) - still


@case("unknown")
def torque_of_a_rotor(stage: Stage) -> None:
    """A spinning wheel in the payload: torque across its axis and the rate."""
    torque = np.cross(stage.run.omega, [0.05, 0.02, 0.15])
    stage.wrench = stage.wrench + np.hstack((np.zeros_like(torque), torque))


@case("unknown")
def magnet(stage: Stage) -> None:
    """A magnet in the bench pulls at the payload with the fourth power of the distance."""
    place = np.cumsum(np.cumsum(stage.run.a, axis=0) * PERIOD_S, axis=0) * PERIOD_S
    away = np.array([0.1, 0.2, -0.35]) - (place - place.mean(axis=0))
    distance = np.linalg.norm(away, axis=1)[:, None]
    stage.push(4.0 * away / distance * (0.3 / np.maximum(distance, 0.1)) ** 4, np.array([0.0, 0.0, 0.08]))


@case("unknown")
def jet(stage: Stage) -> None:
    """Air blows from the flange, on and off every 1.7 s."""
    on = (np.floor(stage.run.t / 1.7) % 2 == 0) * 1.0
    force = np.outer(lfilter([PERIOD_S / 0.1], [1.0, PERIOD_S / 0.1 - 1.0], on), [1.5, 0.4, 0.0])
    stage.wrench = stage.wrench + np.hstack((force, np.cross([0.0, 0.03, 0.2], force)))


@case("sensor_gain")
def gain_by_sign(stage: Stage) -> None:
    """Fz reads 2.5 % too much in one direction and 1 % too little in the other, tx half of that."""
    w = stage.wrench
    gain = np.where(w > 0, 1.0, -0.4) * [0.0, 0.0, 0.025, 0.0125, 0.0, 0.0]
    stage.wrench = w * (1.0 + gain)


@case("sensor_gain")
def gain_that_warms_up(stage: Stage) -> None:
    """All channels grow by 3 % while the sensor warms up, two thirds of it within a quarter of the run."""
    stage.wrench = stage.wrench * (1.0 + 0.03 * (1.0 - np.exp(-4.0 * stage.share)))[:, None]


@case("payload_shift")
def two_shifts(stage: Stage) -> None:
    """A fifth of the payload slips by 13 mm at 30 % of the run, and by 9 mm another way at 65 %."""
    run, part = stage.run, 0.2 * stage.body.phi[0]
    place = stage.body.phi[1:4] / stage.body.phi[0] + np.array([0.0, 0.01, 0.02])
    for at, way in ((0.3, np.array([12e-3, 0.0, 4e-3])), (0.65, np.array([-3e-3, 9e-3, 0.0]))):
        moved = _carry(run, part, place + way) - _carry(run, part, place)
        stage.wrench = stage.wrench + (stage.share > at)[:, None] * moved
        place = place + way


def _carry(run: Run, mass: float, place: Array) -> Array:
    """(N, 6), what a point mass at a place (3,), sensor axes, asks of the sensor."""
    turning = np.cross(run.alpha, place) + np.cross(run.omega, np.cross(run.omega, place))
    force = mass * (np.einsum("nji,nj->ni", run.rotation, run.a - GRAVITY) + turning)
    return np.hstack((force, np.cross(place, force)))


def make(name: str, seed: int) -> Recording:
    """The recording of a case, over its background."""
    rng = np.random.default_rng([seed, list(CASES).index(name)])
    cell = ("lwr4_bench", "ur5e_line")[seed % 2]
    run = run_of(cell, seed, repetitions=1, period=PERIOD_S)
    body = payload(CARRIED, cell) if cell == "lwr4_bench" else payload(sorted_payloads(cell)[-1], cell)
    clean = wrench_of(run, body)
    stage = Stage(run, body, rng, clean, run.q)
    CASES[name][1](stage)
    return record_over_background(stage, clean, rng)


def record_over_background(stage: Stage, clean: Array, rng: np.random.Generator, background: float = 1.0, noise: float = 1.0) -> Recording:
    """What sensor and encoders make of a stage whose wrench was `clean` (N, 6) before anything was planted.

    Args:
        background, noise: their sizes, in multiples.
    """
    run, body = stage.run, stage.body
    tilted = background * np.radians(TILT_DEG) * rng.normal(size=2)
    leaning = wrench_of(run, body, GRAVITY + np.cross([*tilted, 0.0], GRAVITY)) - wrench_of(run, body)
    w = (stage.wrench + leaning) * (1.0 + background * GAIN * rng.normal(size=6))
    shaken = run.t + background * STAMP_S * rng.normal(size=len(run.t))
    w = interpolate(shaken, run.t, w)
    zeros = background * np.radians(ZEROS_DEG) * rng.normal(size=run.q.shape[1])
    blank = record(run, body, rng, Imperfections(noise_std=noise * NOISE_STD, resolution=None))
    read = blank.q if blank.q is None else blank.q + (stage.read - run.q) + zeros
    return replace(blank, wrench=blank.wrench if blank.wrench is None else blank.wrench - clean + w, q=read)


def sorted_payloads(cell: str) -> list[str]:
    """Names, the lightest first."""
    known = load_cell(CELLS / cell).payloads
    return sorted(known, key=lambda name: known[name].parameters.mass)


def find_name(diagnosis: Diagnosis) -> str:
    """What the verdict stands for."""
    if diagnosis.verdict not in ("explained", "ambiguous"):
        return {"no_gap": "none"}.get(diagnosis.verdict, diagnosis.verdict)
    singles = [(each.probability, each.id) for each in diagnosis.effects]
    pairs = [(each.probability, "+".join(each.ids)) for each in diagnosis.pairs]
    return max(singles + pairs)[1]


def answer(name: str, seed: int) -> tuple[str, str, Diagnosis]:
    """A case, what the verdict stands for, and the whole answer."""
    with threadpool_limits(1):
        diagnosis, _ = examine(make(name, seed), fit_all=one_by_one)
    return name, find_name(diagnosis), diagnosis


def main() -> None:
    """Prints a line for each case, then the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", default=",".join(CASES))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=2)
    arguments = parser.parse_args()
    names = arguments.only.split(",")
    tally: dict[str, list[bool]] = {}
    with ProcessPoolExecutor(arguments.processes, mp_context=get_context("fork")) as pool:
        for name, found, diagnosis in pool.map(answer, names, [arguments.seed] * len(names)):
            right = CASES[name][0]
            beside = [each.id for each in diagnosis.also if each.material]
            is_right = found == right or (right in beside and found in ("none", "unknown"))
            tally.setdefault(right if right in ("none", "unknown") else "named", []).append(is_right)
            gap, first = diagnosis.gap, [f"{each.id} {each.probability:.2f}" for each in diagnosis.effects[:2]]
            first += [f"{'+'.join(each.ids)} {each.probability:.2f}" for each in diagnosis.pairs[:1]]
            gaps = "" if gap is None else f"{gap.before:7.2f} ->{gap.after:6.2f}"
            said = ", ".join([*first, f"unknown {diagnosis.unknown_probability:.2f}"])
            print(f"{'ok ' if is_right else '   '}{name:22s}{right:20s}{found:34s}{gaps}  {said}  [{' '.join(beside)}]", flush=True)
    for kind, each in tally.items():
        print(f"{kind}: {sum(each)} of {len(each)}")


if __name__ == "__main__":
    main()
