"""A case of the plan from its seed to its folder, and the truth about it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from bench.stranger.array import Array
from bench.stranger.fault import Fault, Planted
from bench.stranger.plan import Case, Order
from bench.stranger.rig import Rig, draw_rig
from bench.stranger.rounding import round_all
from bench.stranger.sizing import Yardstick, find_rms, find_scale
from bench.stranger.writing import Options, write_recording

Truth = dict[str, object]


def make_case(case: Case, folder: Path) -> Truth:
    """Writes the recording of a case into a folder, on one core; what was planted, and how much of it is to be seen.

    `visible_sigma` and `rms_excess_per_sample` are of the difference that no payload and offset can make, in noise standard deviations:
    over the recording, and for one sample of one channel. `background_*` is the same of what every recording has.
    """
    with threadpool_limits(1):
        return _make(case, folder)


def _make(case: Case, folder: Path) -> Truth:
    order = case.order
    rig = draw_rig(case.seed, order.motion, order.rate, order.mass_kg, order.elastic, order.with_torques)
    options = _draw_options(case)
    faults = [make(np.random.default_rng(case.seed + 100 + place), rig) for place, make in enumerate(order.makers)]
    yardstick = Yardstick(rig)
    sized = [find_scale(yardstick, fault) for fault in faults]
    planted = [Planted(fault, scale) for fault, (scale, _) in zip(faults, sized, strict=True)]
    seen = [each for _, each in sized]
    together = yardstick.measure(planted)
    reading = write_recording(folder, rig, planted, options)
    truth = {
        **_tell_plan(order, rig, planted),
        **_tell_sizes(yardstick, together, seen),
        "rows": len(rig.times),
        **_tell_facts(faults),
    }
    if any(fault.seen_in_reading for fault in faults):
        truth["visible_sigma"] = round_all(float(np.linalg.norm(yardstick.project(reading.changed))))
    return truth


def _draw_options(case: Case) -> Options:
    rng = np.random.default_rng(case.seed + 5)
    recorded = case.order.recorded
    return Options(
        dq=bool(rng.random() < 0.5) or "dq" in recorded,
        cmd=bool(rng.random() < 0.5) or "cmd" in recorded,
        tau=bool(rng.random() < 0.1),
        temp=bool(rng.random() < 0.35),
        phase=bool(rng.random() < 0.65),
        sign=-1 if rng.random() < 0.06 else 1,
    )


def _tell_plan(order: Order, rig: Rig, planted: list[Planted]) -> Truth:
    has_name = order.kind in ("single", "double")
    return {
        "kind": order.kind,
        "families": [fault.family for fault, _ in planted] if has_name else [],
        "variant": " + ".join(fault.variant for fault, _ in planted) or "background imperfections only",
        "size": [round_all(fault.size(scale)) for fault, scale in planted],
        "robot": rig.arm.name,
        "motion": rig.kind,
        "rate_hz": rig.rate,
        "seconds": round_all(rig.seconds, 4),
        "mass": round_all(rig.body.mass, 4),
        "elastic_background": rig.background.stiffness is not None,
    }


def _tell_sizes(yardstick: Yardstick, together: Array, seen: list[Array]) -> Truth:
    each = [float(np.linalg.norm(one)) for one in seen]
    told: Truth = {
        "visible_sigma": round_all(float(np.linalg.norm(together)), 4),
        "rms_excess_per_sample": round_all(find_rms(together), 3),
        "visible_sigma_each": round_all(each, 4),
        "background_sigma": round_all(float(np.linalg.norm(yardstick.background)), 4),
        "background_rms": round_all(find_rms(yardstick.background), 3),
    }
    if len(seen) == 2:
        told["overlap_cos"] = round_all(float(seen[0] @ seen[1] / (each[0] * each[1] + 1e-12)), 3)
    return told


def _tell_facts(faults: list[Fault]) -> Truth:
    return {name: round_all(fact) for fault in faults for name, fact in fault.facts.items()}
