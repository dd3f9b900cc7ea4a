"""A case of the plan from its seed to its folder, and the truth about it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from bench.fourth_stranger.plan import FIRST_SEED, Case
from bench.fourth_stranger.reading import draw_noise, read_in_form
from bench.fourth_stranger.scene import draw_scene
from bench.fourth_stranger.writing import write_recording
from bench.second_stranger.fault import Planted
from bench.second_stranger.reading import refer_rightly
from bench.second_stranger.rivals import Rivals
from bench.second_stranger.sensing import sample
from bench.second_stranger.sizing import Yardstick
from bench.second_stranger.telling import describe_variant, find_temperature, measure_seen, tell_sizes

Truth = dict[str, object]
READING_SEED = 404


def make_case(case: Case, folder: Path) -> Truth:
    """Writes the recording of a case into a folder, on one core; what was planted, and how much of it is to be seen.

    `visible_sigma` and `rms_excess_per_sample` are of the difference that no payload and offset can make, in noise standard deviations:
    over the recording, and for one sample of one channel; where no position is recorded, at rest alone. `rms_each` is of each cause
    alone, `rms_beside_the_other` what each adds where the other is there already. `rival_leftover_sigma` is what other effects would
    leave of `visible_sigma_whole`, which is over all rows.
    """
    with threadpool_limits(1):
        return _make(case, folder)


def _make(case: Case, folder: Path) -> Truth:
    order = case.order
    rng = np.random.default_rng([FIRST_SEED, case.key, order.redraw])
    scene = draw_scene(rng, case.wish)
    rig = scene.rig
    faults = [make(rng, rig) for make in order.makers]
    yardstick = Yardstick(scene.show_what_counts())
    sized = [yardstick.find_scale(fault, wanted) for fault, wanted in zip(faults, order.wanted, strict=True)]
    planted = [Planted(fault, scale) for fault, (scale, _) in zip(faults, sized, strict=True)]
    samples = sample(rig, planted)
    rng = np.random.default_rng([READING_SEED, case.key, order.redraw])
    reading = (order.read or read_in_form)(rng, scene, samples.wrench + rig.offset + draw_noise(rng, scene))
    reference = (order.refer or refer_rightly)(rig)
    is_referred = rng.random() < 0.85 or order.refer is not None
    write_recording(rng, folder, scene, samples, reading.wrench, find_temperature(faults), reference if is_referred else None)
    sizes = tell_sizes(planted, reading, reference)
    whole = Yardstick(rig)
    seen, each = measure_seen(whole, yardstick, planted, [rms for _, rms in sized], reading)
    return {
        "kind": order.kind,
        "families": list(order.families),
        "variant": order.variant or describe_variant(order.name, sizes),
        "size": [size._asdict() for size in sizes],
        "visible_sigma": seen,
        "rms_excess_per_sample": seen / yardstick.root_count,
        "visible_sigma_each": [rms * yardstick.root_count for rms in each],
        "rms_each": each,
        "rms_beside_the_other": _measure_beside(yardstick, planted),
        "also_defensible": list(order.defensible),
        "robot": rig.arm.name,
        "motion": rig.motion,
        "rate_hz": scene.form.rate,
        "seconds": float(np.round(rig.seconds, 2)),
        "mass": rig.body.mass,
        "rows": len(rig.times),
        "visible_sigma_whole": whole.measure(planted) if planted else 0.0,
        "rival_leftover_sigma": Rivals(rig, samples).measure(whole.subtract(samples)) if planted else {},
        "background_rms_excess": yardstick.background / yardstick.root_count,
        "elastic_background": rig.is_elastic,
        "seed": order.redraw,
        "form": scene.form.name,
        "form_is_odd": order.is_odd,
        "form_fields": asdict(scene.form),
        "gravity": rig.gravity.tolist(),
        "tared_with_load": scene.is_tared,
        "offset": np.round(rig.offset, 5).tolist(),
        "noise_std": rig.noise_std.tolist(),
        "noise_colour": np.round(scene.colours, 3).tolist(),
    }


def _measure_beside(yardstick: Yardstick, planted: Sequence[Planted]) -> list[float]:
    """For each of two: the rms by which the wrench with both differs from that with the other one alone, noise standard deviations."""
    if len(planted) < 2:
        return []
    both = yardstick.measure(planted)
    alone = [yardstick.measure([each]) for each in reversed(planted)]
    return [float(np.sqrt(max(both**2 - other**2, 0.0))) / yardstick.root_count for other in alone]
