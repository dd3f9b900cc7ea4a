"""A case of the plan from its seed to its folder, and the truth about it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from bench.second_stranger.fault import Fault, Planted
from bench.second_stranger.plan import FIRST_SEED, Case, Order
from bench.second_stranger.reading import Reading, Reference, payload_mismatch, read_plainly, refer_rightly
from bench.second_stranger.rig import Rig, draw_rig
from bench.second_stranger.rivals import Rivals
from bench.second_stranger.sensing import sample
from bench.second_stranger.sizing import Yardstick
from bench.second_stranger.telling import describe_variant, find_temperature, tell_sizes
from bench.second_stranger.writing import write_recording

Truth = dict[str, object]
READING_SEED = 99


def make_case(case: Case, folder: Path) -> Truth:
    """Writes the recording of a case into a folder, on one core; what was planted, and how much of it is to be seen.

    `visible_sigma` and `rms_excess_per_sample` are of the difference that no payload and offset can make, in noise standard deviations:
    over the recording, and for one sample of one channel. `rival_leftover_sigma` is what other effects would leave of it.
    """
    with threadpool_limits(1):
        return _make(case, folder)


def _make(case: Case, folder: Path) -> Truth:
    order = case.order
    rng = np.random.default_rng([FIRST_SEED, case.key, order.redraw])
    rig = draw_rig(rng, case.wish)
    faults = _draw_faults(rng, rig, order)
    yardstick = Yardstick(rig)
    sized = [yardstick.find_scale(fault, wanted) for fault, wanted in zip(faults, order.wanted, strict=True)]
    planted = [Planted(fault, scale) for fault, (scale, _) in zip(faults, sized, strict=True)]
    samples = sample(rig, planted)
    rng = np.random.default_rng([READING_SEED, case.key, order.redraw])
    noise = rig.noise_std * rng.normal(size=samples.wrench.shape)
    reading = (order.read or read_plainly)(rng, rig, samples.wrench + rig.offset, noise)
    reference = (order.refer or refer_rightly)(rig)
    is_referred = rng.random() < 0.9 or order.refer is payload_mismatch
    sign = -1 if rng.random() < 0.1 else 1
    write_recording(rng, folder, rig, samples.joints, reading.wrench, find_temperature(faults), reference if is_referred else None, sign)
    sizes = tell_sizes(planted, reading, reference)
    seen, each = _measure(yardstick, planted, [rms for _, rms in sized], reading, reference)
    return {
        "kind": order.kind,
        "families": list(order.families),
        "variant": order.variant or describe_variant(order.name, sizes),
        "size": [size._asdict() for size in sizes],
        "visible_sigma": seen,
        "rms_excess_per_sample": seen / yardstick.root_count,
        "visible_sigma_each": [rms * yardstick.root_count for rms in each],
        "also_defensible": [],
        "robot": rig.arm.name,
        "motion": rig.motion,
        "rate_hz": rig.rate,
        "seconds": float(np.round(rig.seconds, 2)),
        "mass": rig.body.mass,
        "rows": len(rig.times),
        "rival_leftover_sigma": Rivals(rig, samples).measure(yardstick.subtract(samples)) if planted else {},
        "background_rms_excess": yardstick.background / yardstick.root_count,
        "elastic_background": rig.is_elastic,
        "seed": order.redraw,
    }


def _draw_faults(rng: np.random.Generator, rig: Rig, order: Order) -> list[Fault]:
    faults = [make(rng, rig) for make in order.makers]
    if order.then is not None and faults[0].at_s is not None:
        faults.append(order.then(rng, rig, faults[0].at_s))
    return faults


def _measure(
    yardstick: Yardstick, planted: Sequence[Planted], each: list[float], reading: Reading, reference: Reference
) -> tuple[float, list[float]]:
    """What is to be seen of all causes, over the recording, and the rms of each, in noise standard deviations."""
    if reading.changed is not None:
        seen = yardstick.measure_reading(reading.changed)
        return seen, [seen / yardstick.root_count]
    if reference.size is not None:
        return 0.0, [0.0]
    return (yardstick.measure(planted) if planted else 0.0), each
