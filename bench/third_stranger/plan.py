"""What is recorded: 30 causes in the wrench, three beside it, nine pairs, nine that have no name and nine times nothing, shuffled."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from bench.second_stranger.fault import Consequence, Fault, Maker
from bench.second_stranger.plan import Kind, Masses, number_orders
from bench.second_stranger.reading import Referrer
from bench.third_stranger.causes import (
    characteristic,
    joints,
    memory,
    mounting,
    payload,
    surroundings,
    timing,
    unlisted,
    unlisted_arm,
    zero,
)
from bench.third_stranger.forms import Form
from bench.third_stranger.reading import Reader, payload_mismatch, sample_dropout, sensor_interference
from bench.third_stranger.scene import Wish
from bench.third_stranger.tours import Tour

FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT = 311128, 41, 20
USUAL: Masses = (1.2, 5.5)
HEAVY: Masses = (3.0, 6.0)
"""kg."""
SECONDS = 65.0


@dataclass(frozen=True)
class Order:
    """One recording to be made.

    Attributes:
        families: what a diagnosis should call the causes.
        wanted: the rms that each of them is to leave, in noise standard deviations.
        then: what the only maker's cause brings about.
        read, refer: what is planted on the reading's side, and on the reference's.
        variant: what it is, where the causes do not say it.
        seconds: about.
        redraw: the first of its seeds with which everything was as wanted.
        defensible: what a diagnosis may say besides.
    """

    kind: Kind
    name: str
    tour: Tour
    form: Form
    families: tuple[str, ...] = ()
    makers: tuple[Maker, ...] = ()
    wanted: tuple[float, ...] = ()
    then: Consequence | None = None
    read: Reader | None = None
    refer: Referrer | None = None
    variant: str = ""
    seconds: float = SECONDS
    mass_kg: Masses = USUAL
    is_quiet: bool = False
    redraw: int = 0
    defensible: tuple[str, ...] = ()


@dataclass(frozen=True)
class Case:
    """An order with the number of its folder, its seed, and whether the joints give a little."""

    number: str
    key: int
    order: Order
    is_elastic: bool

    @property
    def wish(self) -> Wish:
        """What of the scene is not left to chance."""
        order = self.order
        return Wish(order.form, order.tour, order.seconds, order.mass_kg, order.is_quiet, "cable" in order.name, self.is_elastic)


def _plant(
    maker: Maker,
    family: str,
    tour: Tour,
    form: Form,
    wanted: float,
    *,
    seconds: float = SECONDS,
    quiet_kg: Masses | None = None,
    redraw: int = 0,
    defensible: tuple[str, ...] = (),
) -> Order:
    """A single cause; with a quieter sensor and these masses where it would hardly be seen otherwise."""
    return Order(
        kind="single",
        name=maker.__name__,
        tour=tour,
        form=form,
        families=(family,),
        makers=(maker,),
        wanted=(wanted,),
        seconds=seconds,
        mass_kg=quiet_kg or USUAL,
        is_quiet=quiet_kg is not None,
        redraw=redraw,
        defensible=defensible,
    )


def _pair(
    first: Maker, second: Maker, families: tuple[str, str], tour: Tour, form: Form, wanted: tuple[float, float], seconds: float = SECONDS
) -> Order:
    return Order("double", _join(first, second), tour, form, families, (first, second), wanted, seconds=seconds)


def _follow(first: Maker, then: Consequence, families: tuple[str, str], tour: Tour, form: Form, wanted: tuple[float, float]) -> Order:
    return Order("double", _join(first, then), tour, form, families, (first,), wanted, then)


def _join(*makers: Callable[..., Fault]) -> str:
    return "+".join(maker.__name__ for maker in makers)


def _misread(name: str, tour: Tour, form: Form, variant: str, read: Reader | None = None, refer: Referrer | None = None) -> Order:
    return Order("single", name, tour, form, (name,), read=read, refer=refer, variant=variant)


def _plant_unlisted(maker: Maker, tour: Tour, form: Form, wanted: float, seconds: float = SECONDS, redraw: int = 0) -> Order:
    return Order("unknown", maker.__name__, tour, form, makers=(maker,), wanted=(wanted,), seconds=seconds, redraw=redraw)


def _expect_nothing(place: int, tour: Tour, form: Form, seconds: float) -> Order:
    return Order("none", f"none{place}", tour, form, variant=f"sound, {form.name}", seconds=seconds)


POSED = Form(rate=62.5, log="poses")
ROUND_JOINTS = Form(rate=125, joint_step_deg=0.01)
POLLED = Form(rate=500, polled=100)

SINGLES = (
    _plant(zero.drift_soak, "sensor_drift", "poses", Form(poses=30), 14),
    _plant(zero.drift_motors, "sensor_drift", "tour", Form(rate=200), 4, seconds=80),
    _plant(zero.step_tare, "sensor_offset_step", "tour", Form(rate=125, pauses=2, is_moved=True), 15),
    _plant(characteristic.gain_supply, "sensor_gain", "flow", Form(rate=333), 3.5),
    _plant(characteristic.cross_moments, "sensor_crosstalk", "chirp", ROUND_JOINTS, 7),
    _plant(characteristic.nonlin_stop, "sensor_nonlinearity", "tour", Form(rate=200, is_rounded=True), 5),
    _plant(memory.hyst_seal, "sensor_hysteresis", "tour", Form(rate=125), 3.5, quiet_kg=HEAVY),
    _plant(memory.creep_glue, "sensor_creep", "slow", Form(rate=20), 3.2, seconds=95, quiet_kg=HEAVY),
    _plant(characteristic.sat_bridge, "sensor_saturation", "tour", Form(rate=125), 15),
    _plant(timing.delay_resync, "time_delay", "chirp", Form(rate=200), 7),
    _plant(timing.delay_bus, "time_delay", "chirp", Form(rate=62.5, is_rounded=True), 8, seconds=80),
    _plant(timing.lp_adaptive, "sensor_lowpass", "brisk", Form(rate=333), 8),
    _plant(timing.kin_box, "kinematic_lag", "brisk", Form(rate=1000), 7, seconds=45),
    _plant(mounting.rot_gasket, "sensor_rotation", "tour", POSED, 7),
    _plant(mounting.trans_spacer, "sensor_translation", "brisk", Form(rate=200), 5, quiet_kg=HEAVY),
    _plant(mounting.tilt_cart, "base_tilt", "tour", Form(rate=125, pauses=3, is_moved=True), 7, seconds=90),
    _plant(mounting.tilt_plate, "base_tilt", "poses", Form(poses=24, log="attitude"), 12),
    _plant(joints.joff_remaster, "joint_offset", "flow", ROUND_JOINTS, 5.5),
    _plant(joints.elast_windup, "joint_elasticity", "slow", Form(rate=20, is_rounded=True), 6, seconds=90),
    _plant(joints.backlash_worn, "joint_backlash", "tour", Form(rate=200), 3.0, quiet_kg=HEAVY),
    _plant(joints.ripple_cycloid, "gear_ripple", "flow", Form(rate=333), 4.5),
    _plant(payload.loose_granulate, "payload_loose", "jog", Form(rate=62.5), 6, seconds=70),
    _plant(payload.loose_pendulum, "payload_loose", "brisk", Form(rate=200), 12, seconds=50),
    _plant(payload.shift_vacuum, "payload_shift", "brisk", Form(rate=333), 5, seconds=50),
    _plant(payload.mass_dispense, "payload_mass_change", "slow", Form(rate=20, log="attitude"), 5, seconds=95),
    _plant(payload.flex_torsion, "tool_flexibility", "snappy", Form(rate=2000), 9, seconds=44),
    _plant(surroundings.cable_balancer, "cable_drag", "cycle", Form(rate=125, lowpass=220), 7),
    _plant(surroundings.cable_floor, "cable_drag", "jog", POSED, 12, seconds=68),
    _plant(surroundings.contact_fixture, "external_contact", "rounds", POLLED, 16, seconds=82, defensible=("sample_dropout",)),
    _plant(surroundings.contact_lean, "external_contact", "slow", Form(rate=10), 25, seconds=85),
)
BESIDE = (
    _misread("sensor_interference", "tour", Form(rate=333), "a pump's line and its double", read=sensor_interference),
    _misread("sample_dropout", "slow", Form(rate=500), "a sensor asked at 100 Hz in a log of 500 Hz", read=sample_dropout),
    _misread("payload_mismatch", "flow", Form(rate=62.5, pauses=1), "the CAD has other fingers", refer=payload_mismatch),
)
PAIRS = (
    _follow(payload.mass_pick, zero.drift_after_pick, ("payload_mass_change", "sensor_drift"), "tour", Form(rate=62.5), (5, 4.5)),
    _pair(mounting.tilt_shim, characteristic.gain_card, ("base_tilt", "sensor_gain"), "poses", Form(poses=38), (8, 8)),
    _pair(surroundings.contact_nudges, timing.delay_bus, ("external_contact", "time_delay"), "chirp", Form(rate=333), (12, 9)),
    _pair(
        characteristic.cross_lateral,
        surroundings.cable_balancer,
        ("sensor_crosstalk", "cable_drag"),
        "tour",
        Form(rate=125, lowpass=200),
        (5.5, 5.5),
    ),
    _pair(payload.loose_granulate, zero.drift_settling, ("payload_loose", "sensor_drift"), "tour", Form(rate=125, pauses=2), (5.5, 4.5)),
    _pair(
        mounting.rot_gasket,
        surroundings.contact_nudges,
        ("sensor_rotation", "external_contact"),
        "tour",
        Form(rate=200, log="poses"),
        (5.5, 5),
    ),
    _follow(
        payload.shift_regrip,
        zero.tare_after_regrip,
        ("payload_shift", "sensor_offset_step"),
        "tour",
        Form(rate=62.5, pauses=1, is_moved=True),
        (5, 5),
    ),
    _pair(mounting.tilt_shim, zero.drift_settling, ("base_tilt", "sensor_drift"), "slow", Form(rate=10, log="attitude"), (7, 6)),
    _pair(joints.joff_tooth, surroundings.contact_lean, ("joint_offset", "external_contact"), "tour", Form(rate=1000), (5.5, 6), 46),
)
UNLISTED = (
    _plant_unlisted(unlisted.u_unbalance, "tour", Form(rate=200), 5),
    _plant_unlisted(unlisted.u_coriolis, "chirp", Form(rate=125, is_rounded=True), 5),
    _plant_unlisted(unlisted.u_slow_clock, "brisk", Form(rate=333), 5),
    _plant_unlisted(unlisted_arm.u_bent_link, "tour", Form(rate=62.5), 7),
    _plant_unlisted(unlisted_arm.u_coupling, "slow", Form(rate=20), 7, seconds=95),
    _plant_unlisted(unlisted.u_sunlight, "tour", Form(rate=62.5, log="attitude"), 6),
    _plant_unlisted(unlisted.u_added_mass, "brisk", Form(rate=1000), 5, seconds=42),
    _plant_unlisted(unlisted_arm.u_pedestal, "brisk", Form(rate=125), 4.5),
    _plant_unlisted(unlisted_arm.u_weave, "flow", Form(rate=125), 5),
)
NOTHING = (
    _expect_nothing(0, "tour", Form(rate=62.5, is_rounded=True), 60),
    _expect_nothing(1, "brisk", Form(rate=2000), 44),
    _expect_nothing(2, "slow", Form(rate=10), 90),
    _expect_nothing(3, "poses", Form(poses=16), 0),
    _expect_nothing(4, "tour", Form(rate=125, pauses=3, is_moved=True), 85),
    _expect_nothing(5, "flow", Form(rate=200, log="poses"), 60),
    _expect_nothing(6, "jog", Form(rate=333, joint_step_deg=0.01), 55),
    _expect_nothing(7, "slow", Form(rate=20, log="attitude"), 80),
    _expect_nothing(8, "chirp", Form(rate=1000, lowpass=250), 48),
)
GROUPS = (SINGLES, BESIDE, PAIRS, UNLISTED, NOTHING)
"""Orders; a hundred seeds are kept for each."""


def list_cases() -> list[Case]:
    """All of them, by number; the arms of quiet ones are stiff."""
    numbered = number_orders(GROUPS, FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT)
    return [Case(number, key, order, gives and not order.is_quiet) for number, key, order, gives in numbered]
