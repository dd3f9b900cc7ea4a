"""Something else holds on to the payload: cables, hands, obstacles."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.ndimage import gaussian_filter1d

from bench.stranger.array import Array
from bench.stranger.draws import draw_direction
from bench.stranger.fault import Fault
from bench.stranger.kinematics import Kinematics
from bench.stranger.rig import Rig
from bench.stranger.rigid_body import read_push
from bench.stranger.signals import PAD, STEP_S, derive, rise_and_fall, run_coarsely


def rub_with_memory(way: Array, friction: float, stiffness: float) -> Array:
    """(N, 3), friction by Dahl's law along a way (N, 3), in the unit of `friction`."""
    z = np.zeros(3)
    out = np.empty_like(way)
    last = way[0]
    for i, x in enumerate(way):
        d = x - last
        last = x
        z = z + stiffness * (d - np.linalg.norm(d) * z / friction)
        out[i] = z
    return out


def pull_hose(rng: np.random.Generator, rig: Rig) -> Fault:
    """From a point above."""
    across = draw_direction(rng, 2) * rng.uniform(0.04, 0.08)
    fitting = np.r_[across, rng.uniform(0.03, 0.1)]
    anchor = rig.nominal.p.mean(0) + np.r_[rng.uniform(-0.5, -0.2), rng.uniform(-0.3, 0.3), rng.uniform(0.5, 0.9)]
    stiffness, friction = rng.uniform(3, 9), rng.uniform(0.2, 0.5)
    free_length = np.quantile(np.linalg.norm(rig.nominal.find_place(fitting) - anchor, axis=1), 0.2)

    def pull(k: Kinematics, scale: float) -> Array:
        place = k.find_place(fitting)
        to_anchor = anchor - place
        length = np.linalg.norm(to_anchor, axis=1)[:, None]
        x = length - free_length
        taut = 0.5 * (x + np.sqrt(x * x + 0.02**2))
        spring = stiffness * taut * to_anchor / length + stiffness * 0.35 * np.minimum(taut, 0.5) ** 2 * to_anchor / length
        force = spring - run_coarsely(lambda way: rub_with_memory(way, friction, friction / 0.01), place)
        return scale * read_push(k.turn_into_sensor(force), fitting)

    return Fault(
        family="cable_drag",
        variant="hose to an overhead point: slack, progressive spring, friction with memory (Dahl) along the way of the fitting",
        size=lambda scale: {
            "k": stiffness * scale,
            "anchor": anchor,
            "free_length": free_length,
            "friction_N": friction * scale,
            "fitting": fitting,
        },
        add_wrench=pull,
        limits=(0.3, 4),
    )


def twist_dress_pack(rng: np.random.Generator, rig: Rig) -> Fault:
    """About the last joint."""
    stiffness, friction = rng.uniform(0.02, 0.06), rng.uniform(0.02, 0.05)
    fitting = np.r_[draw_direction(rng, 2) * 0.05, 0.04]
    weight = rng.uniform(0.4, 0.9)
    angle = rig.q[:, rig.arm.roll : rig.arm.roll + 1]
    middle = angle[:, 0].mean() + rng.uniform(-0.4, 0.4)

    def rub(x: Array) -> Array:
        return rub_with_memory(np.c_[x, 0 * x, 0 * x], friction, friction / 0.08)[:, :1]

    def drag(k: Kinematics, scale: float) -> Array:
        x = angle[:, 0] - middle
        torque = -stiffness * x - 0.3 * stiffness * x**3 / 4 - run_coarsely(rub, angle)[:, 0]
        force = np.zeros((rig.steps, 3))
        force[:, 2] = -weight * (1 + 0.6 * (k.p[:, 2] - k.p[:, 2].mean()) / 0.3)
        force += -0.35 * weight * k.v / (np.linalg.norm(k.v, axis=1)[:, None] + 0.004)
        about_z = np.column_stack([np.zeros((rig.steps, 5)), torque])
        return np.asarray(scale * (read_push(k.turn_into_sensor(force), fitting) - about_z))

    return Fault(
        family="cable_drag",
        variant="dress pack: twists about the last joint with bending hysteresis, hangs with a weight that grows with height, "
        "drags against the direction of travel",
        size=lambda scale: {"k_twist": stiffness * scale, "friction_Nm": friction * scale, "weight_N": weight * scale},
        add_wrench=drag,
        limits=(0.3, 4),
    )


class Episode(NamedTuple):
    """A hand on the payload: from when to when, s; its force (3,), N; where (3,), m, sensor axes; how long it takes hold, s; whether the
    force stays in base axes or turns with the tool; and its tremor (N, 3), in shares of four."""

    begin_s: float
    end_s: float
    force: Array
    place: Array
    rise_s: float
    in_base: bool
    tremor: Array


def push_by_hand(rng: np.random.Generator, rig: Rig) -> Fault:
    """Three to five times."""
    return _push(rng, rig, int(rng.integers(3, 6)), 9)


def push_often_by_hand(rng: np.random.Generator, rig: Rig) -> Fault:
    """Six to eight times, less hard."""
    return _push(rng, rig, int(rng.integers(6, 9)), 5)


def _push(rng: np.random.Generator, rig: Rig, count: int, most_n: float) -> Fault:
    episodes = _draw_episodes(rng, rig, count, most_n)

    def push(k: Kinematics, scale: float) -> Array:
        W = np.zeros((rig.steps, 6))
        for episode in episodes:
            held = rise_and_fall(rig.t, episode.begin_s, episode.end_s, episode.rise_s)
            force = episode.force * (1 + 0.25 * episode.tremor) * held[:, None] * scale
            W += read_push(k.turn_into_sensor(force) if episode.in_base else force, episode.place)
        return W

    return Fault(
        family="external_contact",
        variant=f"by hand, {len(episodes)} episodes of different force, place, length; tremor on it",
        size=lambda scale: {"episodes": [_describe(episode, scale) for episode in episodes]},
        add_wrench=push,
        wanted=(2.2, 20),
        limits=(0.1, 5),
    )


def _draw_episodes(rng: np.random.Generator, rig: Rig, count: int, most_n: float) -> list[Episode]:
    """One after the other, until the recording is nearly over."""
    drawn: list[tuple[float, float, Array, Array, float, bool]] = []
    t = rng.uniform(0.08, 0.2) * rig.seconds
    for _ in range(count):
        lasting_s = rng.uniform(1.2, 5)
        force = draw_direction(rng) * rng.uniform(2, most_n)
        place = rig.body.com + rng.normal(size=3) * 0.04
        drawn.append((t, t + lasting_s, force, place, rng.uniform(0.1, 0.4), bool(rng.random() < 0.5)))
        t += lasting_s + rng.uniform(0.06, 0.2) * rig.seconds
        if t > rig.seconds - 3:
            break
    return [Episode(*each, gaussian_filter1d(rng.normal(size=(rig.steps, 3)), 120, axis=0) * 20) for each in drawn]


def _describe(episode: Episode, scale: float) -> dict[str, object]:
    return {
        "t0": episode.begin_s,
        "t1": episode.end_s,
        "force": episode.force * scale,
        "at": episode.place,
        "fixed_in": "base" if episode.in_base else "tool",
    }


def lean_on_obstacle(rng: np.random.Generator, rig: Rig) -> Fault:
    """Soft, and pushed aside in the end."""
    begin_s = rng.uniform(0.3, 0.5) * rig.seconds
    end_s = begin_s + rng.uniform(6, 12)
    place = rig.body.com + np.r_[0, 0, 0.05] + rng.normal(size=3) * 0.02
    stiffness, mu = rng.uniform(150, 500), rng.uniform(0.2, 0.4)
    normal = draw_direction(rng)
    middle = rig.nominal.find_place(place)[int((begin_s + end_s) / 2 / STEP_S) + PAD]

    def lean(k: Kinematics, scale: float) -> Array:
        p = k.find_place(place)
        held = rise_and_fall(rig.t, begin_s, end_s, 0.3)
        pressed = np.clip(0.012 - 0.3 * ((p - middle) @ normal), 0, 0.03)
        v = derive(p)
        along = v - np.outer(v @ normal, normal)
        way = normal - mu * along / (np.linalg.norm(along, axis=1)[:, None] + 0.002)
        force = (stiffness * pressed * held * scale)[:, None] * way
        return read_push(k.turn_into_sensor(force), place)

    return Fault(
        family="external_contact",
        variant="leans on a soft obstacle once (spring, sliding friction), pushed aside later",
        size=lambda scale: {"t0": begin_s, "t1": end_s, "k": stiffness * scale, "normal": normal, "mu": mu, "at": place},
        add_wrench=lean,
        wanted=(2.2, 20),
        limits=(0.1, 5),
    )
