"""A case of the plan from its seed to its folder, and the truth about it."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from bench.second_stranger.fault import Planted
from bench.second_stranger.reading import refer_rightly
from bench.second_stranger.rivals import Rivals
from bench.second_stranger.sensing import Samples, sample
from bench.second_stranger.sizing import Yardstick
from bench.second_stranger.telling import describe_variant, find_temperature, measure_seen, tell_sizes
from bench.third_stranger.plan import FIRST_SEED, Case
from bench.third_stranger.reading import draw_noise, payload_mismatch, poll, read_in_form
from bench.third_stranger.scene import Scene, draw_scene
from bench.third_stranger.writing import write_recording

Truth = dict[str, object]
READING_SEED = 303
OF_MOTION = ("time_delay", "time_delay_at_ms", "kinematic_lag")
"""Rivals that averaged poses say nothing of."""


def make_case(case: Case, folder: Path) -> Truth:
    """Writes the recording of a case into a folder, on one core; what was planted, and how much of it is to be seen.

    `visible_sigma` and `rms_excess_per_sample` are of the difference that no payload and offset can make, in noise standard deviations:
    over the recording, and for one sample of one channel; where no position is recorded, at rest alone. `rival_leftover_sigma` is what
    other effects would leave of `visible_sigma_whole`, which is over all rows. `form_rms_excess` is what polling does to the wrench.
    """
    with threadpool_limits(1):
        return _make(case, folder)


def _make(case: Case, folder: Path) -> Truth:
    order = case.order
    rng = np.random.default_rng([FIRST_SEED, case.key, order.redraw])
    scene = draw_scene(rng, case.wish)
    rig = scene.rig
    faults = [make(rng, rig) for make in order.makers]
    if order.then is not None and faults[0].at_s is not None:
        faults.append(order.then(rng, rig, faults[0].at_s))
    yardstick = Yardstick(scene.show_what_counts(), scene.always)
    sized = [yardstick.find_scale(fault, wanted) for fault, wanted in zip(faults, order.wanted, strict=True)]
    planted = [Planted(fault, scale) for fault, (scale, _) in zip(faults, sized, strict=True)]
    samples = sample(rig, [*planted, *scene.always])
    rng = np.random.default_rng([READING_SEED, case.key, order.redraw])
    reading = (order.read or read_in_form)(rng, scene, samples.wrench + rig.offset + draw_noise(rng, scene))
    reference = (order.refer or refer_rightly)(rig)
    is_referred = rng.random() < 0.9 or order.refer is payload_mismatch
    write_recording(rng, folder, scene, samples, reading.wrench, find_temperature(faults), reference if is_referred else None)
    sizes = tell_sizes(planted, reading, reference)
    whole = Yardstick(rig, scene.always)
    seen, each = measure_seen(whole, yardstick, planted, [rms for _, rms in sized], reading)
    return {
        "kind": order.kind,
        "families": list(order.families),
        "variant": order.variant or describe_variant(order.name, sizes),
        "size": [size._asdict() for size in sizes],
        "visible_sigma": seen,
        "rms_excess_per_sample": seen / yardstick.root_count,
        "visible_sigma_each": [rms * yardstick.root_count for rms in each],
        "also_defensible": list(order.defensible),
        "robot": rig.arm.name,
        "motion": rig.motion,
        "rate_hz": 0.0 if scene.form.poses else scene.form.rate,
        "seconds": float(np.round(rig.seconds, 2)),
        "mass": rig.body.mass,
        "rows": len(rig.times),
        "visible_sigma_whole": whole.measure(planted) if planted else 0.0,
        "rival_leftover_sigma": _find_rivals(scene, samples, whole) if planted else {},
        "background_rms_excess": yardstick.background / yardstick.root_count,
        "elastic_background": rig.is_elastic,
        "seed": order.redraw,
        "form": scene.form.name,
        "form_is_hard": scene.form.is_hard,
        "form_fields": asdict(scene.form),
        "form_rms_excess": _measure_form(scene, samples, whole),
        "gravity": rig.gravity.tolist(),
        "tared_with_load": scene.is_tared,
        "offset": np.round(rig.offset, 3).tolist(),
        "noise_std": scene.row_noise.tolist(),
        "noise_colour": np.round(scene.colours, 3).tolist(),
    }


def _find_rivals(scene: Scene, samples: Samples, whole: Yardstick) -> dict[str, float]:
    found = Rivals(scene.rig, samples).measure(whole.subtract(samples))
    return {name: left for name, left in found.items() if not (scene.form.poses and name in OF_MOTION)}


def _measure_form(scene: Scene, samples: Samples, whole: Yardstick) -> float:
    """The rms, in noise standard deviations, that polling leaves."""
    if scene.form.polled is None:
        return 0.0
    held = samples.wrench[poll(scene.rig.times, scene.form.polled)]
    return whole.measure_reading(held - samples.wrench) / whole.root_count
