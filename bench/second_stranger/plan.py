"""What is recorded: 36 causes in the wrench, four beside it, ten pairs, ten that have no name and twelve times nothing, shuffled."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, TypeVar

import numpy as np

from bench.second_stranger.causes import characteristic, joints, memory, mounting, payload, surroundings, timing, unlisted, zero
from bench.second_stranger.fault import Consequence, Fault, Maker
from bench.second_stranger.reading import Reader, Referrer, payload_mismatch, sample_dropout, sensor_noise, sensor_quantization
from bench.second_stranger.rig import Wish

Ordered = TypeVar("Ordered")
Kind = Literal["none", "single", "double", "unknown"]
FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT = 20261128, 77, 24
Masses = tuple[float, float]
USUAL: Masses = (1.2, 5.5)
"""kg."""


@dataclass(frozen=True)
class Order:
    """One recording to be made.

    Attributes:
        families: what a diagnosis should call the causes.
        wanted: the rms that each of them is to leave, in noise standard deviations.
        then: what the only maker's cause brings about.
        read, refer: what is planted on the reading's side, and on the reference's.
        variant: what it is, where the causes do not say it.
        seconds: about; drawn where None.
        redraw: the first of its seeds with which everything was as wanted.
    """

    kind: Kind
    name: str
    motion: str
    families: tuple[str, ...] = ()
    makers: tuple[Maker, ...] = ()
    wanted: tuple[float, ...] = ()
    then: Consequence | None = None
    read: Reader | None = None
    refer: Referrer | None = None
    variant: str = ""
    mass_kg: Masses = USUAL
    is_quiet: bool = False
    least_rate: int = 0
    seconds: float | None = None
    redraw: int = 0


@dataclass(frozen=True)
class Case:
    """An order with the number of its folder, its seed, and whether the joints give a little."""

    number: str
    key: int
    order: Order
    is_elastic: bool

    @property
    def wish(self) -> Wish:
        """What of the rig is not left to chance."""
        order = self.order
        is_upright = "cable" in order.name
        return Wish(order.motion, order.mass_kg, order.is_quiet, order.least_rate, order.seconds, is_upright, self.is_elastic)


def _plant(
    maker: Maker,
    family: str,
    motion: str,
    wanted: float,
    quiet_kg: Masses | None = None,
    least_rate: int = 0,
    redraw: int = 0,
) -> Order:
    """A single cause; with a quieter sensor and these masses where it would hardly be seen otherwise."""
    return Order(
        kind="single",
        name=maker.__name__,
        motion=motion,
        families=(family,),
        makers=(maker,),
        wanted=(wanted,),
        mass_kg=quiet_kg or USUAL,
        is_quiet=quiet_kg is not None,
        least_rate=least_rate,
        redraw=redraw,
    )


def _misread(name: str, motion: str, variant: str, read: Reader | None = None, refer: Referrer | None = None) -> Order:
    return Order("single", name, motion, (name,), read=read, refer=refer, variant=variant)


def _pair(
    first: Maker,
    second: Maker,
    families: tuple[str, str],
    motion: str,
    wanted: tuple[float, float],
    mass_kg: Masses = USUAL,
) -> Order:
    return Order("double", _join(first, second), motion, families, (first, second), wanted, mass_kg=mass_kg)


def _follow(first: Maker, then: Consequence, families: tuple[str, str], motion: str, wanted: tuple[float, float]) -> Order:
    return Order("double", _join(first, then), motion, families, (first,), wanted, then)


def _join(*makers: Callable[..., Fault]) -> str:
    return "+".join(maker.__name__ for maker in makers)


def _plant_unlisted(maker: Maker, motion: str, wanted: float, least_rate: int = 0) -> Order:
    return Order("unknown", maker.__name__, motion, makers=(maker,), wanted=(wanted,), least_rate=least_rate)


def _expect_nothing(place: int, motion: str, seconds: float, mass_kg: Masses) -> Order:
    return Order("none", f"none{place}", motion, variant=f"sound, {motion} motion", mass_kg=mass_kg, seconds=seconds)


SINGLES = (
    _plant(zero.drift_overshoot, "sensor_drift", "paper", 5),
    _plant(zero.drift_wander, "sensor_drift", "mixed", 3.2),
    _plant(zero.drift_hvac, "sensor_drift", "free", 4),
    _plant(zero.step_gauge, "sensor_offset_step", "mixed", 4.5),
    _plant(zero.step_settle, "sensor_offset_step", "sweep", 2.8),
    _plant(characteristic.gain_warm, "sensor_gain", "mixed", 3.5),
    _plant(characteristic.gain_fixed, "sensor_gain", "sweep", 4.5),
    _plant(characteristic.cross_plate, "sensor_crosstalk", "mixed", 5),
    _plant(characteristic.cross_oneside, "sensor_crosstalk", "free", 3.5),
    _plant(characteristic.nonlin_cubic, "sensor_nonlinearity", "free", 4),
    _plant(characteristic.nonlin_even, "sensor_nonlinearity", "mixed", 3),
    _plant(memory.hyst_preisach, "sensor_hysteresis", "sweep", 2.8, (3, 5)),
    _plant(memory.hyst_dahl, "sensor_hysteresis", "free", 3.0, (3, 5)),
    _plant(memory.creep_sum, "sensor_creep", "mixed", 2.6, (3, 5), redraw=1),
    _plant(characteristic.sat_soft, "sensor_saturation", "free", 8),
    _plant(timing.delay_skew, "time_delay", "sweep", 3.5),
    _plant(timing.delay_packets, "time_delay", "mixed", 5),
    _plant(timing.lp_cascade, "sensor_lowpass", "jerky", 13, redraw=2),
    _plant(timing.kin_ema, "kinematic_lag", "fast", 10),
    _plant(mounting.rot_wedge, "sensor_rotation", "free", 5),
    _plant(mounting.trans_origin, "sensor_translation", "fast", 2.3, (4.5, 6)),
    _plant(mounting.tilt_settle, "base_tilt", "mixed", 6),
    _plant(mounting.tilt_floor, "base_tilt", "free", 3.5),
    _plant(joints.joff_ecc, "joint_offset", "mixed", 5),
    _plant(joints.elast_hard, "joint_elasticity", "free", 3.2),
    _plant(joints.backlash_soft, "joint_backlash", "sweep", 2.2, (4, 6)),
    _plant(joints.ripple_hd, "gear_ripple", "mixed", 4.5, (3, 6), least_rate=500),
    _plant(payload.loose_rubber, "payload_loose", "mixed", 5),
    _plant(payload.loose_sleeve, "payload_loose", "sweep", 7),
    _plant(payload.shift_slide, "payload_shift", "mixed", 5),
    _plant(payload.mass_fill, "payload_mass_change", "sweep", 6),
    _plant(payload.flex_modes, "tool_flexibility", "jerky", 4, least_rate=250),
    _plant(surroundings.cable_catenary, "cable_drag", "mixed", 5),
    _plant(surroundings.cable_lanyard, "cable_drag", "free", 4),
    _plant(surroundings.contact_hand, "external_contact", "paper", 14),
    _plant(surroundings.contact_foam, "external_contact", "free", 12),
)
MISREAD = (
    _misread("sensor_noise", "mixed", "noise that breathes with a fan (AR(1) share), 2.6 x stated", read=sensor_noise),
    _misread("sensor_quantization", "paper", "sticky coarse converter codes of 4 sigma", read=sensor_quantization),
    _misread("sample_dropout", "sweep", "bursts of held wrench rows (Gilbert-Elliott), 27 %", read=sample_dropout),
    _misread("payload_mismatch", "mixed", "reference 9 % heavy, centre 6 mm off, inertia 12 % off", refer=payload_mismatch),
)
PAIRS = (
    _pair(zero.drift_log, surroundings.contact_hand, ("sensor_drift", "external_contact"), "mixed", (3, 7.7)),
    _pair(mounting.tilt_const, timing.delay_const2, ("base_tilt", "time_delay"), "sweep", (4.6, 2.7)),
    _pair(surroundings.cable_twist, zero.drift_wander, ("cable_drag", "sensor_drift"), "free", (3.1, 5.8)),
    _pair(surroundings.contact_bump, mounting.tilt_const, ("external_contact", "base_tilt"), "mixed", (5.1, 3)),
    _pair(payload.loose_slosh, timing.delay_const2, ("payload_loose", "time_delay"), "sweep", (5.8, 4.7), (2.5, 5)),
    _pair(joints.joff_one, zero.drift_overshoot, ("joint_offset", "sensor_drift"), "free", (3.9, 4.3)),
    _follow(surroundings.contact_once, zero.step_after_contact, ("external_contact", "sensor_offset_step"), "paper", (8.7, 3.5)),
    _follow(surroundings.contact_once, payload.shift_by_contact, ("external_contact", "payload_shift"), "sweep", (5.5, 5.3)),
    _pair(payload.mass_drop, mounting.tilt_settle, ("payload_mass_change", "base_tilt"), "mixed", (4.9, 4.3)),
    _pair(surroundings.cable_catenary, characteristic.gain_fixed, ("cable_drag", "sensor_gain"), "free", (5.4, 4.5)),
)
UNLISTED = (
    _plant_unlisted(unlisted.u_gyro, "mixed", 7),
    _plant_unlisted(unlisted.u_air, "fast", 4),
    _plant_unlisted(unlisted.u_magnet, "free", 6),
    _plant_unlisted(unlisted.u_eddy, "mixed", 3.5),
    _plant_unlisted(unlisted.u_ship, "free", 4),
    _plant_unlisted(unlisted.u_track, "sweep", 5),
    _plant_unlisted(unlisted.u_press, "mixed", 3.5, least_rate=250),
    _plant_unlisted(unlisted.u_emi, "free", 4),
    _plant_unlisted(unlisted.u_turntable, "paper", 4.5),
    _plant_unlisted(unlisted.u_gravcomp, "fast", 4),
)
NOTHING = (
    _expect_nothing(0, "fast", 60, (1, 3)),
    _expect_nothing(1, "fast", 75, (2, 4)),
    _expect_nothing(2, "fast", 50, (3, 6)),
    _expect_nothing(3, "poor", 60, (1, 3)),
    _expect_nothing(4, "poor", 70, (2, 5)),
    _expect_nothing(5, "poor", 48, (3, 6)),
    _expect_nothing(6, "mixed", 80, (5.2, 6)),
    _expect_nothing(7, "free", 65, (5.2, 6)),
    _expect_nothing(8, "paper", 90, (5.2, 6)),
    _expect_nothing(9, "sweep", 40, (1, 4)),
    _expect_nothing(10, "mixed", 41, (2, 4)),
    _expect_nothing(11, "free", 40, (1, 6)),
)
GROUPS = (SINGLES, MISREAD, PAIRS, UNLISTED, NOTHING)
"""Orders; a hundred seeds are kept for each."""


def list_cases() -> list[Case]:
    """All of them, by number."""
    return [Case(*each) for each in number_orders(GROUPS, FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT)]


def number_orders(
    groups: Sequence[Sequence[Ordered]], seed: int, elastic_by: int, elastic_count: int
) -> Iterator[tuple[str, int, Ordered, bool]]:
    """Orders shuffled by a seed: number of the folder, key, the order, and whether its joints give a little, drawn by another seed."""
    orders = [(100 * group + place, order) for group, of_group in enumerate(groups) for place, order in enumerate(of_group)]
    shuffled = np.random.default_rng(seed).permutation(len(orders)).tolist()
    elastic = np.random.default_rng(elastic_by).permutation(len(orders))[:elastic_count]
    for number, place in enumerate(shuffled, start=1):
        yield f"{number:03d}", *orders[place], place in elastic
