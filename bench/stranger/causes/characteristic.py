"""The sensor's body does not give back what it is loaded with: gains, cross-talk, curves, hysteresis, creep, limits."""

from __future__ import annotations

import numpy as np

from bench.stranger.array import Array
from bench.stranger.draws import draw_sign
from bench.stranger.fault import Fault
from bench.stranger.rig import Rig
from bench.stranger.sensing import sense
from bench.stranger.signals import lag_once, run_coarsely


def find_usual_load(rig: Rig) -> Array:
    """(6,), N and N m, that the payload's weight puts on each channel."""
    weight = rig.body.mass * 9.81
    arm = max(float(np.linalg.norm(rig.body.com)), 0.04)
    return np.array([weight] * 3 + [weight * arm] * 3)


def differ_by_sign(rng: np.random.Generator, rig: Rig) -> Fault:
    """Forces that push are amplified otherwise than those that pull."""
    e = np.zeros(6)
    e[:3] = rng.normal(size=3) * 0.02
    e[rng.integers(3)] = draw_sign(rng) * 0.04
    load = find_usual_load(rig)
    return Fault(
        family="sensor_gain",
        variant="gain differs for push and pull (e on positive loads only), smoothly joined",
        size=lambda scale: {"e_positive": e * scale},
        distort=lambda W, scale: W + e * scale * W * 0.5 * (1 + np.tanh(W / (0.03 * load))),
        facts={"also_defensible": ["sensor_nonlinearity"]},
    )


def amplify_more_when_warm(rng: np.random.Generator, rig: Rig) -> Fault:
    """Gains of which a third is there at once."""
    e = rng.normal(size=6) * 0.02
    e[:3] += draw_sign(rng) * 0.02
    tau_s = rng.uniform(15, 60)
    y = 1 - np.exp(-np.maximum(rig.t, 0) / tau_s)
    return Fault(
        family="sensor_gain",
        variant="gain warms up: 1 + e (0.3 + 0.7 (1 - exp(-t/tau)))",
        size=lambda scale: {"e": e * scale, "tau_s": tau_s},
        distort=lambda W, scale: W * (1 + (0.3 + 0.7 * y)[:, None] * e * scale),
    )


def amplify_wrongly(rng: np.random.Generator, _: Rig) -> Fault:
    """Constant gains."""
    force = rng.normal(size=3) * 0.025
    e = np.r_[force, rng.normal(size=3) * 0.02]
    return Fault(
        family="sensor_gain",
        variant="wrong sensitivities, every channel its own, constant",
        size=lambda scale: {"e": e * scale},
        distort=lambda W, scale: W * (1 + e * scale),
    )


def mix_all_channels(rng: np.random.Generator, _: Rig) -> Fault:
    """Every channel shows a little of every other."""
    unit = np.r_[[1] * 3, [0.04] * 3]
    C = rng.normal(size=(6, 6)) * 0.015 * np.outer(unit, 1 / unit)
    np.fill_diagonal(C, 0)
    return Fault(
        family="sensor_crosstalk",
        variant="all 30 off-diagonal terms random",
        size=lambda scale: {"C": C * scale},
        distort=lambda W, scale: W + W @ C.T * scale,
    )


def leak_one_channel(rng: np.random.Generator, _: Rig) -> Fault:
    """One force shows in three other channels."""
    C = np.zeros((6, 6))
    source = int(rng.integers(3))
    others = [i for i in range(3) if i != source]
    C[others[0], source] = draw_sign(rng) * 0.04
    C[others[1], source] = draw_sign(rng) * 0.015
    C[3 + rng.integers(3), source] = draw_sign(rng) * 0.002
    return Fault(
        family="sensor_crosstalk",
        variant="one force channel leaks into two others and a torque",
        size=lambda scale: {"C": C * scale},
        distort=lambda W, scale: W + W @ C.T * scale,
    )


def bend_oddly(rng: np.random.Generator, rig: Rig) -> Fault:
    """An S, the same for push and pull."""
    load = find_usual_load(rig)
    force = rng.normal(size=3) * 0.03 + draw_sign(rng) * 0.02
    e = np.r_[force, rng.normal(size=3) * 0.02]
    return Fault(
        family="sensor_nonlinearity",
        variant="S-shaped characteristic: e sin(pi W / W0), W0 the payload's load",
        size=lambda scale: {"e_share_of_load": e * scale, "W0": load},
        distort=lambda W, scale: W + e * scale * load * np.sin(np.pi * W / load),
    )


def bend_both_ways(rng: np.random.Generator, rig: Rig) -> Fault:
    """A parabola and a cubic."""
    load = find_usual_load(rig)
    e2, e3 = rng.normal(size=6) * 0.02, rng.normal(size=6) * 0.02
    e2[:3] += 0.02 * draw_sign(rng)
    return Fault(
        family="sensor_nonlinearity",
        variant="even and odd terms together: e2 W^2/W0 + e3 W^3/W0^2",
        size=lambda scale: {"e2": e2 * scale, "e3": e3 * scale, "W0": load},
        distort=lambda W, scale: W + scale * (e2 * W**2 / load + e3 * W**3 / load**2),
    )


def remember_turning_points(rng: np.random.Generator, rig: Rig) -> Fault:
    """Hysteresis of many small plays."""
    load, K = find_usual_load(rig), 7
    thresholds = np.linspace(0.05, 0.9, K)[:, None] * load
    weights = rng.uniform(0.3, 1, K)[:, None] / K * np.ones(6)
    e = 0.05 * rng.uniform(0.6, 1.4, 6)
    return Fault(
        family="sensor_hysteresis",
        variant="Prandtl-Ishlinskii/Preisach: 7 play operators with distributed thresholds (return-point memory)",
        size=lambda scale: {"weight": e * scale, "thresholds_max": thresholds[-1]},
        distort=lambda W, scale: W - e * scale * (W * weights.sum(0) - run_coarsely(lambda x: _play(x, thresholds, weights), W)),
    )


def _play(W: Array, thresholds: Array, weights: Array) -> Array:
    """(N, 6), what plays with thresholds and weights (K, 6) make of loads (N, 6), in sum."""
    x = np.zeros_like(thresholds)
    out = np.empty_like(W)
    for i, w in enumerate(W):
        x = np.minimum(np.maximum(x, w - thresholds), w + thresholds)
        out[i] = (weights * x).sum(0)
    return out


def loop_smoothly(rng: np.random.Generator, rig: Rig) -> Fault:
    """Hysteresis by Bouc and Wen."""
    load = find_usual_load(rig)
    e = 0.035 * rng.uniform(0.5, 1.5, 6)
    n, beta, length = rng.uniform(1.1, 1.8), rng.uniform(0.5, 0.7), rng.uniform(0.15, 0.35)

    def loop(W: Array) -> Array:
        z = np.zeros(6)
        out = np.empty_like(W)
        last = W[0]
        for i, w in enumerate(W):
            du = (w - last) / (length * load)
            last = w
            za = np.abs(z) ** (n - 1)
            z = np.clip(z + du - beta * np.abs(du) * za * z - (1 - beta) * du * za * np.abs(z), -1.2, 1.2)
            out[i] = z
        return out

    return Fault(
        family="sensor_hysteresis",
        variant="Bouc-Wen, smooth loops",
        size=lambda scale: {"amplitude": e * scale * load, "n": n, "beta": beta, "length": length},
        distort=lambda W, scale: W + e * scale * load * run_coarsely(loop, W),
    )


def creep(rng: np.random.Generator, _: Rig) -> Fault:
    """A share of the load comes late and goes late."""
    e = rng.uniform(0.01, 0.025, 6) * rng.choice([-1, 1])
    fast_s, middle_s, slow_s = rng.uniform(1.5, 3), rng.uniform(8, 14), rng.uniform(40, 80)
    return Fault(
        family="sensor_creep",
        variant="Kelvin-Voigt chain with three time constants (log-like creep and recovery)",
        size=lambda scale: {"e_total": e * scale, "tau_s": [fast_s, middle_s, slow_s]},
        distort=lambda W, scale: W + e * scale * (0.3 * lag_once(W, fast_s) + 0.4 * lag_once(W, middle_s) + 0.3 * lag_once(W, slow_s)),
        limits=(0.3, 8),
    )


def clip_hard(rng: np.random.Generator, rig: Rig) -> Fault:
    """One of the two channels that change most ends at a level."""
    W0 = sense(rig, [])
    channel = int(np.argsort(W0.std(0) / rig.sensor.noise_std)[-1 - rng.integers(2)])
    above = rng.random() < 0.5

    def level(scale: float) -> float:
        return float(np.quantile(W0[:, channel], 1 - 0.12 * scale if above else 0.12 * scale))

    def clip(W: Array, scale: float) -> Array:
        W = W.copy()
        W[:, channel] = (np.minimum if above else np.maximum)(W[:, channel], level(scale))
        return W

    return Fault(
        family="sensor_saturation",
        variant="hard clipping of one channel on one side, below the stated range (amplifier rail)",
        size=lambda scale: {"channel": channel, "side": 1 if above else -1, "level": level(scale)},
        put_out=clip,
        wanted=(2.2, 14),
        limits=(0.2, 3),
    )


def clip_softly(_: np.random.Generator, rig: Rig) -> Fault:
    """The force that changes most bends towards a limit on both sides."""
    W0 = sense(rig, [])
    channel = int(np.argsort((W0.std(0) / rig.sensor.noise_std)[:3])[-1])
    top = np.abs(W0[:, channel]).max()

    def bend(W: Array, scale: float) -> Array:
        limit = top * (1.06 - 0.03 * scale)
        knee = 0.82 * limit
        x = W[:, channel]
        a = np.abs(x)
        y = np.where(a > knee, knee + (limit - knee) * np.tanh((a - knee) / (limit - knee)), a)
        W = W.copy()
        W[:, channel] = np.sign(x) * y
        return W

    return Fault(
        family="sensor_saturation",
        variant="soft (tanh) saturation of one force channel on both sides, knee at 82 % of the limit",
        size=lambda scale: {"channel": channel, "limit": top * (1.06 - 0.03 * scale)},
        put_out=bend,
        wanted=(2.2, 20),
        limits=(0.3, 10),
    )
