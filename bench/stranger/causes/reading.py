"""What is read off the recording beside the wrench: noise, hum, coarse steps, held samples, and a reference that is not the payload."""

from __future__ import annotations

import numpy as np
from scipy import signal

from bench.stranger.array import Array
from bench.stranger.draws import draw_direction
from bench.stranger.fault import Fault, Reference
from bench.stranger.rig import Rig
from bench.stranger.rigid_body import Body, find_steiner, find_wrench

ON_THE_READING = "on the reading's side"


def add_noise_in_motion(rng: np.random.Generator, rig: Rig) -> Fault:
    """Coloured, and stronger while the arm moves."""
    factor, memory = rng.uniform(1.8, 3.0), 0.8
    e = signal.lfilter([np.sqrt(1 - memory * memory)], [1, -memory], rng.normal(size=rig.white.shape), axis=0)

    def add(noise: Array, _: float) -> Array:
        speed = np.abs(rig.sample(rig.dq)).max(1)[:, None]
        return np.asarray(noise + e * rig.sensor.noise_std * factor * (0.55 + 0.45 * np.minimum(1, speed / 0.15)))

    return Fault(
        family="sensor_noise",
        variant="coloured (AR 0.8) extra noise, stronger while the motors run",
        size=lambda _: {"factor": np.sqrt(1 + factor * factor)},
        change_noise=add,
        fixed=True,
        seen_in_reading=True,
        facts={"note": ON_THE_READING},
    )


def hum(rng: np.random.Generator, rig: Rig) -> Fault:
    """The mains, and their third harmonic."""
    noise_std = rig.sensor.noise_std
    f = 50 + rng.uniform(-0.04, 0.04)
    A = noise_std * rng.uniform(1.5, 5, 6) * (rng.random(6) < 0.7)
    A[rng.integers(3)] = 5 * noise_std[0]
    phase = rng.uniform(0, 6, 6)

    def add(noise: Array, _: float) -> Array:
        t = rig.times
        breathing = 1 + 0.3 * np.sin(2 * np.pi * t / 23)
        wave = np.sin(2 * np.pi * f * t[:, None] + phase) + 0.3 * np.sin(6 * np.pi * f * t[:, None] + 2 * phase)
        return np.asarray(noise + breathing[:, None] * A * wave)

    return Fault(
        family="sensor_interference",
        variant="mains hum near 50 Hz with third harmonic and slowly breathing amplitude",
        size=lambda _: {"f": f, "amplitude": A},
        change_noise=add,
        fixed=True,
        seen_in_reading=True,
        facts={"note": ON_THE_READING},
    )


def convert_coarsely(rng: np.random.Generator, rig: Rig) -> Fault:
    """Steps of several standard deviations."""
    step = rig.sensor.noise_std * rng.uniform(4, 8) * rng.uniform(0.7, 1.3, 6)
    return Fault(
        family="sensor_quantization",
        variant="coarse converter steps (4-8 sigma), not stated in the resolution",
        size=lambda _: {"step": step},
        convert=lambda W, _: np.asarray(np.round((W + step * 0.3) / step) * step),
        fixed=True,
        seen_in_reading=True,
        facts={"note": ON_THE_READING},
    )


def hold_samples(rng: np.random.Generator, rig: Rig) -> Fault:
    """Now and then the last wrench is sent again for a while."""
    n = len(rig.times)
    held = np.zeros(n, bool)
    i = 0
    while i < n:
        i += int(rng.geometric(1 / (0.25 * rig.rate)))
        length = int(rng.geometric(1 / (0.10 * rig.rate)))
        held[i : i + length] = True
        i += length
    held[0] = False
    sent = np.maximum.accumulate(np.where(held, 0, np.arange(n)))
    return Fault(
        family="sample_dropout",
        variant="bursts of held wrench samples (Gilbert channel, mean burst 0.1 s)",
        size=lambda _: {"mean_burst_s": 0.1},
        convert=lambda W, _: W[sent],
        fixed=True,
        seen_in_reading=True,
        facts={"held_share": held.mean(), "note": ON_THE_READING + "; visible_sigma includes the held noise"},
    )


def forget_adapter(rng: np.random.Generator, rig: Rig) -> Fault:
    """The reference lacks a part of the payload."""
    body = rig.body
    mass = body.mass * rng.uniform(0.82, 0.93)
    lacking = body.mass - mass
    at = np.r_[rng.uniform(-0.02, 0.02, 2), rng.uniform(0.0, 0.04)]
    reference = Reference(mass, body.first_moment - lacking * at, body.inertia - find_steiner(lacking, at) * 0.8)
    return Fault(
        family="payload_mismatch",
        variant="the reference left the adapter and its screws out",
        size=lambda _: {"true_mass": body.mass, "reference_mass": mass, "missing_at": at},
        reference=reference,
        fixed=True,
        facts=_compare(rig, reference),
    )


def refer_to_old_gripper(rng: np.random.Generator, rig: Rig) -> Fault:
    """The reference has another centre of mass and other inertia."""
    body = rig.body
    d = draw_direction(rng) * rng.uniform(0.006, 0.015)
    factor = rng.uniform(1.1, 1.3)
    com = body.com + d
    old = Body(body.mass, com, body.inertia_at_com * factor)
    reference = Reference(body.mass * 1.003, old.first_moment, old.inertia)
    return Fault(
        family="payload_mismatch",
        variant="CAD of the older gripper: centre of mass and inertia differ, mass nearly the same",
        size=lambda _: {"shift_m": d, "inertia_factor": factor},
        reference=reference,
        fixed=True,
        facts=_compare(rig, reference),
    )


def _compare(rig: Rig, reference: Reference) -> dict[str, object]:
    """What the reference is off by, in noise standard deviations of the wrench."""
    body = rig.body
    d = find_wrench(
        rig.feel(rig.nominal),
        reference.mass - body.mass,
        reference.first_moment - body.first_moment,
        reference.inertia - body.inertia,
    )
    d = d / rig.sensor.noise_std
    return {
        "visible_sigma": float(np.linalg.norm(d - d.mean(0))),
        "note": "on the reference's side; visible_sigma is against the reference payload (nothing is left after another payload)",
    }
