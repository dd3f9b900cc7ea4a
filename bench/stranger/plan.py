"""What is recorded: ten times nothing, fifty single causes, ten pairs and ten that have no name, shuffled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from bench.stranger.causes import characteristic, joints, mounting, payload, reading, surroundings, timing, unlisted, zero
from bench.stranger.fault import Maker

Kind = Literal["none", "single", "double", "unknown"]
SHUFFLED_BY, FIRST_SEED, SEED_STEP = 990127, 51000, 13
HEAVY = (1.4, 4.0)
USUAL = (0.6, 4.0)
"""Masses, kg."""


@dataclass(frozen=True)
class Order:
    """One recording to be made.

    Attributes:
        motion: its kind; None where it is drawn, as everything else that is None.
        recorded: columns that are recorded in any case: q_cmd (`cmd`) and dq.
    """

    kind: Kind
    name: str
    makers: tuple[Maker, ...] = ()
    motion: str | None = None
    mass_kg: tuple[float, float] = USUAL
    rate: int | None = None
    elastic: bool | None = None
    with_torques: bool = False
    reseed: int = 0
    recorded: frozenset[str] = frozenset()


@dataclass(frozen=True)
class Case:
    """An order with the number of its folder and its seed."""

    number: str
    seed: int
    order: Order


def _expect_nothing(place: int) -> Order:
    return Order("none", f"none{place}", elastic=place in (1, 4, 7))


def _plant(
    maker: Maker,
    motion: str | None = None,
    mass_kg: tuple[float, float] = HEAVY,
    rate: int | None = None,
    reseed: int = 0,
) -> Order:
    return Order("single", maker.__name__, (maker,), motion, mass_kg, rate, reseed=reseed)


def _pair(first: Maker, second: Maker, motion: str | None = None) -> Order:
    return Order("double", f"{first.__name__}+{second.__name__}", (first, second), motion, HEAVY)


def _plant_unlisted(maker: Maker, motion: str | None = None) -> Order:
    return Order("unknown", maker.__name__, (maker,), motion, HEAVY)


ORDERS = (
    *(_expect_nothing(place) for place in range(10)),
    _plant(zero.drift_at_random, mass_kg=USUAL),
    _plant(zero.warm_up, mass_kg=USUAL),
    _plant(zero.follow_air_conditioning, mass_kg=USUAL),
    _plant(zero.jump_and_relax, mass_kg=USUAL),
    _plant(zero.jump, mass_kg=USUAL),
    _plant(characteristic.differ_by_sign),
    _plant(characteristic.amplify_more_when_warm),
    _plant(characteristic.amplify_wrongly, "att"),
    _plant(characteristic.mix_all_channels, "mix"),
    _plant(characteristic.leak_one_channel),
    _plant(characteristic.bend_oddly),
    _plant(characteristic.bend_both_ways),
    _plant(characteristic.remember_turning_points),
    _plant(characteristic.loop_smoothly, "mix"),
    _plant(characteristic.creep, "att"),
    _plant(characteristic.clip_hard, mass_kg=USUAL, reseed=1),
    _plant(characteristic.clip_softly),
    _plant(reading.add_noise_in_motion, mass_kg=USUAL),
    _plant(reading.hum, mass_kg=USUAL, rate=500),
    _plant(reading.convert_coarsely, "proc", USUAL),
    _plant(reading.hold_samples, mass_kg=USUAL),
    _plant(timing.delay, "mix", (2.5, 4)),
    _plant(timing.delay_unsteadily, "exc"),
    _plant(timing.filter_by_bessel, "exc"),
    _plant(timing.average, "mix"),
    _plant(timing.observe_joints_late, "exc", (3, 4), reseed=1),
    _plant(mounting.turn_about_tool),
    _plant(mounting.tilt_base),
    _plant(mounting.lean_on_rubber_feet, "att"),
    _plant(joints.lose_zeros_of_wrist, "mix"),
    _plant(joints.lose_all_zeros, "att"),
    _plant(joints.give_under_load, "att"),
    _plant(joints.play_in_gears, "proc", (3, 4), reseed=1),
    _plant(joints.ripple, "att", rate=250),
    Order("single", "rub", (joints.rub,), "att", with_torques=True, recorded=frozenset({"cmd", "dq"})),
    _plant(reading.forget_adapter, "mix", USUAL),
    _plant(reading.refer_to_old_gripper, mass_kg=USUAL),
    _plant(payload.slide_on_rail, mass_kg=USUAL),
    _plant(payload.swing_on_hinge, mass_kg=USUAL),
    _plant(payload.creep_to_low_side, mass_kg=USUAL),
    _plant(payload.slip_in_jaws, mass_kg=USUAL),
    _plant(payload.turn_in_gripper, mass_kg=USUAL),
    _plant(payload.lose_part, mass_kg=USUAL),
    _plant(payload.pour, mass_kg=USUAL),
    _plant(payload.bend, "att!", rate=250),
    _plant(surroundings.pull_hose, mass_kg=USUAL),
    _plant(surroundings.twist_dress_pack, mass_kg=USUAL),
    _plant(surroundings.push_by_hand, mass_kg=USUAL),
    _plant(surroundings.push_often_by_hand, mass_kg=USUAL),
    _plant(surroundings.lean_on_obstacle, mass_kg=USUAL),
    _pair(zero.warm_up, mounting.tilt_base),
    _pair(characteristic.mix_all_channels, surroundings.push_by_hand),
    _pair(characteristic.amplify_wrongly, timing.delay, "mix"),
    _pair(joints.lose_zeros_of_wrist, surroundings.pull_hose, "att"),
    _pair(characteristic.loop_smoothly, mounting.turn_about_any_axis, "mix"),
    _pair(timing.filter_torques_more, payload.slip_in_jaws, "exc"),
    _pair(surroundings.push_often_by_hand, zero.drift_at_random),
    _pair(payload.slide_on_rail, mounting.lean_on_rubber_feet),
    _pair(zero.jump_and_relax, timing.delay_unsteadily),
    _pair(characteristic.bend_both_ways, joints.lose_zeros_of_last_joint, "att"),
    _plant_unlisted(unlisted.attract_to_table, "att"),
    _plant_unlisted(unlisted.blow),
    _plant_unlisted(unlisted.run_spindle, "exc"),
    _plant_unlisted(unlisted.feel_rotor_magnets),
    _plant_unlisted(unlisted.feel_drives),
    _plant_unlisted(unlisted.dip_into_bath, "att"),
    _plant_unlisted(unlisted.shake_floor),
    _plant_unlisted(unlisted.rock),
    _plant_unlisted(unlisted.work_gripper),
    _plant_unlisted(unlisted.turn_in_field),
)


def list_cases() -> list[Case]:
    """All of them, by number."""
    numbers = np.random.default_rng(SHUFFLED_BY).permutation(len(ORDERS)) + 1
    cases = [
        Case(f"{number:03d}", FIRST_SEED + SEED_STEP * place + order.reseed, order)
        for place, (number, order) in enumerate(zip(numbers, ORDERS, strict=True))
    ]
    return sorted(cases, key=lambda case: case.number)
