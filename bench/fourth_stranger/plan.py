"""What is recorded: 24 causes in the wrench, two beside it, eight pairs, eight that have no name and six times nothing, shuffled."""

from __future__ import annotations

from dataclasses import dataclass

from bench.fourth_stranger.causes import (
    characteristic,
    joints,
    memory,
    mounting,
    payload,
    surroundings,
    timing,
    unlisted,
    unlisted_tool,
    zero,
)
from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import DESK, HUNG, LARGE, MOBILE, PLANAR, UPRIGHT, Machine
from bench.fourth_stranger.motion import Kind
from bench.fourth_stranger.reading import Reader, payload_mismatch, sensor_interference
from bench.fourth_stranger.scene import Wish
from bench.second_stranger.fault import Maker
from bench.second_stranger.plan import Kind as Planted
from bench.second_stranger.plan import number_orders
from bench.second_stranger.reading import Referrer

FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT = 281126, 47, 14
SECONDS = 62.0


@dataclass(frozen=True)
class Order:
    """One recording to be made.

    Attributes:
        families: what a diagnosis should call the causes.
        wanted: the rms that each of them is to leave, in noise standard deviations.
        read, refer: what is planted on the reading's side, and on the reference's.
        variant: what it is, where the causes do not say it.
        seconds: about.
        redraw: the first of its seeds with which everything was as wanted.
        defensible: what a diagnosis may say besides.
    """

    kind: Planted
    name: str
    machine: Machine
    motion: Kind
    form: Form
    families: tuple[str, ...] = ()
    makers: tuple[Maker, ...] = ()
    wanted: tuple[float, ...] = ()
    read: Reader | None = None
    refer: Referrer | None = None
    variant: str = ""
    seconds: float = SECONDS
    is_quiet: bool = False
    redraw: int = 0
    defensible: tuple[str, ...] = ()

    @property
    def is_odd(self) -> bool:
        """Whether its log is not that of about a minute, 100 to 500 times in a second, evenly, with joints and all that is stated."""
        return bool(self.form.words) or not (100 <= self.form.rate <= 500 and 40 <= self.seconds <= 90)


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
        return Wish(order.machine, order.form, order.motion, order.seconds, order.is_quiet, self.is_elastic)


def _plant(
    maker: Maker,
    family: str,
    machine: Machine,
    motion: Kind,
    form: Form,
    wanted: float,
    *,
    seconds: float = SECONDS,
    is_quiet: bool = False,
    redraw: int = 0,
    defensible: tuple[str, ...] = (),
) -> Order:
    """A single cause; with a quieter sensor where it would hardly be seen otherwise."""
    return Order(
        kind="single",
        name=maker.__name__,
        machine=machine,
        motion=motion,
        form=form,
        families=(family,),
        makers=(maker,),
        wanted=(wanted,),
        seconds=seconds,
        is_quiet=is_quiet,
        redraw=redraw,
        defensible=defensible,
    )


def _pair(
    first: Maker,
    second: Maker,
    families: tuple[str, str],
    machine: Machine,
    motion: Kind,
    form: Form,
    wanted: tuple[float, float],
    seconds: float = SECONDS,
    defensible: tuple[str, ...] = (),
) -> Order:
    name = f"{first.__name__}+{second.__name__}"
    return Order("double", name, machine, motion, form, families, (first, second), wanted, seconds=seconds, defensible=defensible)


def _misread(
    name: str, machine: Machine, motion: Kind, form: Form, variant: str, read: Reader | None = None, refer: Referrer | None = None
) -> Order:
    return Order("single", name, machine, motion, form, (name,), read=read, refer=refer, variant=variant)


def _plant_unlisted(
    maker: Maker, machine: Machine, motion: Kind, form: Form, wanted: float, seconds: float = SECONDS, defensible: tuple[str, ...] = ()
) -> Order:
    return Order(
        "unknown", maker.__name__, machine, motion, form, makers=(maker,), wanted=(wanted,), seconds=seconds, defensible=defensible
    )


def _expect_nothing(place: int, machine: Machine, motion: Kind, form: Form, seconds: float) -> Order:
    return Order("none", f"none{place}", machine, motion, form, variant=f"sound, {machine.name}, {form.name}", seconds=seconds)


LABELLED = Form(rate=250, is_labelled=True)
USUAL = Form(rate=200, is_labelled=True)
NOISY, COARSE = ("sensor_noise",), ("sensor_quantization",)
"""Where the file states less noise than there is, and where its steps are coarse."""

SINGLES = (
    _plant(zero.drift_coolant, "sensor_drift", LARGE, "stairs", Form(rate=50), 6, seconds=360),
    _plant(zero.step_connector, "sensor_offset_step", DESK, "once", Form(rate=250), 8, seconds=9),
    _plant(characteristic.gain_span, "sensor_gain", HUNG, "sines", Form(rate=200, extras="speeds", is_labelled=True), 5),
    _plant(characteristic.cross_helical, "sensor_crosstalk", MOBILE, "dash", Form(rate=250, stated=0.7), 5, seconds=50, defensible=NOISY),
    _plant(
        characteristic.nonlin_radial,
        "sensor_nonlinearity",
        LARGE,
        "stairs",
        Form(rate=125, log="attitude", is_labelled=True),
        3.5,
        seconds=75,
        is_quiet=True,
    ),
    _plant(characteristic.sat_recovery, "sensor_saturation", DESK, "pick", Form(rate=200, uneven=0.3, has_range=False), 9, seconds=52),
    _plant(memory.hyst_bolts, "sensor_hysteresis", HUNG, "stairs", USUAL, 4, seconds=75, is_quiet=True),
    _plant(memory.creep_lopsided, "sensor_creep", LARGE, "crawl", Form(rate=50, is_labelled=True), 3.2, seconds=420, is_quiet=True),
    _plant(timing.delay_traffic, "time_delay", PLANAR, "sines", Form(rate=200, extras="commands", is_labelled=True), 6),
    _plant(timing.lp_chebyshev, "sensor_lowpass", DESK, "sines", Form(rate=333, is_epoch=True), 14, seconds=50),
    _plant(timing.kin_oneeuro, "kinematic_lag", MOBILE, "dash", Form(rate=500), 6, seconds=45),
    _plant(mounting.rot_slack, "sensor_rotation", HUNG, "stairs", Form(rate=100, log="poses", stated=0), 6),
    _plant(mounting.trans_cover, "sensor_translation", DESK, "dash", Form(rate=250, extras="speeds"), 3.2, seconds=60, is_quiet=True),
    _plant(mounting.tilt_rocking, "base_tilt", MOBILE, "stairs", Form(rate=100, is_direction=True), 7, seconds=80),
    _plant(joints.joff_rod, "joint_offset", UPRIGHT, "pick", Form(rate=125, extras="drives", is_labelled=True), 4.5, seconds=70),
    _plant(joints.elast_balanced, "joint_elasticity", LARGE, "stairs", Form(rate=125, is_labelled=True), 6, seconds=80),
    _plant(joints.backlash_stages, "joint_backlash", HUNG, "stairs", LABELLED, 3.0, seconds=80, is_quiet=True),
    _plant(joints.ripple_belt, "gear_ripple", DESK, "sines", Form(rate=400), 4, seconds=50, is_quiet=True),
    _plant(payload.loose_lid, "payload_loose", HUNG, "stairs", Form(rate=125, is_single=True, step=2.0), 6, defensible=COARSE),
    _plant(payload.shift_pull, "payload_shift", PLANAR, "once", Form(rate=250, extras="speeds"), 4.5, seconds=11.5),
    _plant(payload.mass_drain, "payload_mass_change", MOBILE, "stairs", Form(rate=100), 6),
    _plant(payload.flex_beating, "tool_flexibility", LARGE, "hasty", Form(rate=500, is_labelled=True), 7, seconds=42),
    _plant(surroundings.cable_spiral, "cable_drag", UPRIGHT, "pick", Form(rate=62.5, uneven=0.35), 6, seconds=330),
    _plant(surroundings.contact_snag, "external_contact", PLANAR, "stairs", Form(rate=200, is_halved=True), 10),
)
BESIDE = (
    _misread("sensor_interference", HUNG, "stairs", LABELLED, "two fans that beat", read=sensor_interference),
    _misread("payload_mismatch", MOBILE, "sines", Form(rate=125, is_epoch=True), "the CAD has another origin", refer=payload_mismatch),
)
PAIRS = (
    _pair(mounting.tilt_bracket, timing.delay_traffic, ("base_tilt", "time_delay"), HUNG, "sines", USUAL, (6, 6)),
    _pair(
        zero.drift_battery,
        surroundings.contact_door,
        ("sensor_drift", "external_contact"),
        MOBILE,
        "stairs",
        Form(rate=60, is_epoch=True),
        (5, 7),
        seconds=310,
    ),
    _pair(
        surroundings.cable_chain,
        characteristic.gain_span,
        ("cable_drag", "sensor_gain"),
        PLANAR,
        "stairs",
        USUAL,
        (6, 5),
    ),
    _pair(
        payload.loose_tray,
        zero.drift_coolant,
        ("payload_loose", "sensor_drift"),
        LARGE,
        "stairs",
        Form(rate=125, stated=0.7),
        (6, 5),
        seconds=75,
        defensible=NOISY,
    ),
    _pair(joints.joff_key, surroundings.contact_snag, ("joint_offset", "external_contact"), DESK, "stairs", LABELLED, (6, 7)),
    _pair(mounting.rot_slack, payload.loose_lid, ("sensor_rotation", "payload_loose"), HUNG, "dash", Form(rate=250, log="poses"), (6, 6)),
    _pair(
        payload.mass_drain,
        surroundings.cable_spiral,
        ("payload_mass_change", "cable_drag"),
        LARGE,
        "pick",
        Form(rate=100, is_halved=True),
        (6, 6),
        seconds=75,
    ),
    _pair(
        characteristic.cross_helical,
        payload.shift_pull,
        ("sensor_crosstalk", "payload_shift"),
        HUNG,
        "sines",
        Form(rate=400, extras="speeds"),
        (5, 6),
        seconds=50,
    ),
)
UNLISTED = (
    _plant_unlisted(unlisted.u_furnace, MOBILE, "stairs", Form(rate=125, log="poses"), 6, defensible=("sensor_drift",)),
    _plant_unlisted(unlisted.u_mux, DESK, "dash", Form(rate=500), 6, seconds=45, defensible=("time_delay",)),
    _plant_unlisted(unlisted.u_partner, LARGE, "sines", Form(rate=100, uneven=0.3), 5, defensible=("cable_drag",)),
    _plant_unlisted(unlisted.u_wobble, UPRIGHT, "pick", USUAL, 4.5),
    _plant_unlisted(unlisted.u_zero_tracking, HUNG, "crawl", Form(rate=50), 9, seconds=300, defensible=("sensor_creep", "sensor_drift")),
    _plant_unlisted(unlisted_tool.u_jet, PLANAR, "dash", Form(rate=250), 6, seconds=50),
    _plant_unlisted(unlisted_tool.u_freewheel, HUNG, "once", Form(rate=333), 4, seconds=12, defensible=("payload_loose",)),
    _plant_unlisted(unlisted_tool.u_turret, MOBILE, "stairs", Form(rate=100, stated=0), 6, defensible=("payload_shift", "payload_loose")),
)
NOTHING = (
    _expect_nothing(0, DESK, "sines", Form(rate=250, extras="speeds", is_labelled=True), 60),
    _expect_nothing(1, LARGE, "stairs", Form(rate=50, uneven=0.3), 320),
    _expect_nothing(2, UPRIGHT, "pick", Form(rate=125, extras="commands"), 65),
    _expect_nothing(3, PLANAR, "once", Form(rate=200), 10),
    _expect_nothing(4, MOBILE, "dash", Form(rate=100, is_halved=True, is_epoch=True, stated=0.77), 50),
    _expect_nothing(5, HUNG, "stairs", Form(rate=200, log="poses", step=0.9), 62),
)
GROUPS = (SINGLES, BESIDE, PAIRS, UNLISTED, NOTHING)
"""Orders; a hundred seeds are kept for each."""


def list_cases() -> list[Case]:
    """All of them, by number; the arms of quiet ones are stiff."""
    numbered = number_orders(GROUPS, FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT)
    return [Case(number, key, order, gives and not order.is_quiet) for number, key, order, gives in numbered]
