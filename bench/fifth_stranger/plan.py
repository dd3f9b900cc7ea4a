"""What is recorded: 45 pairs of 45 combinations, 25 causes that have no name, 20 that have one, and ten times nothing, shuffled."""

from __future__ import annotations

from typing import NamedTuple

from bench.fifth_stranger.causes import (
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
from bench.fifth_stranger.machines import MACHINES
from bench.fourth_stranger.forms import Form
from bench.fourth_stranger.machines import Machine
from bench.fourth_stranger.motion import Kind
from bench.fourth_stranger.plan import SECONDS, Case, Order
from bench.second_stranger.fault import Maker
from bench.second_stranger.plan import number_orders

FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT = 51126, 59, 40
OWN_KEYS = 50_000
"""From which keys are counted, so that no draw is one of the fourth stranger's."""


class Listed(NamedTuple):
    """A cause that a family describes.

    Attributes:
        motion: without which it would hardly be seen; any where empty.
        is_quiet: whether it takes a quiet sensor.
    """

    maker: Maker
    family: str
    motion: Kind | None = None
    is_quiet: bool = False


SUN, MORNING = (Listed(make, "sensor_drift") for make in (zero.drift_sun, zero.drift_morning))
BOND, KNOCK = (Listed(make, "sensor_offset_step") for make in (zero.step_bond, zero.step_knock))
BRIDGE, AGED = (Listed(make, "sensor_gain") for make in (characteristic.gain_bridge, characteristic.gain_aged))
LEAK, BOLTS = (Listed(make, "sensor_crosstalk") for make in (characteristic.cross_leak, characteristic.cross_bolts))
STOP, TENSION = (Listed(make, "sensor_nonlinearity") for make in (characteristic.nonlin_stop, characteristic.nonlin_tension))
SUPPLY = Listed(characteristic.sat_supply, "sensor_saturation")
CLAMP = Listed(memory.hyst_clamp, "sensor_hysteresis", "stairs", is_quiet=True)
GLUE = Listed(memory.creep_glue, "sensor_creep", "crawl", is_quiet=True)
BEAT, QUEUE = (Listed(make, "time_delay", "sines") for make in (timing.delay_beat, timing.delay_queue))
AVERAGE, OIL = Listed(timing.lp_average, "sensor_lowpass", "hasty"), Listed(timing.lp_oil, "sensor_lowpass", "dash")
OBSERVER = Listed(timing.kin_observer, "kinematic_lag", "dash")
DOWEL, BURR = (Listed(make, "sensor_rotation") for make in (mounting.rot_dowel, mounting.rot_burr))
PLATE = Listed(mounting.trans_plate, "sensor_translation", "dash", is_quiet=True)
SHIMS, SINKING = (Listed(make, "base_tilt") for make in (mounting.tilt_shims, mounting.tilt_sinking))
BELT, SWAP = (Listed(make, "joint_offset") for make in (joints.joff_belt, joints.joff_swap))
REDUCER, WRIST = (Listed(make, "joint_elasticity", "stairs") for make in (joints.elast_reducer, joints.elast_wrist))
WORM = Listed(joints.backlash_worm, "joint_backlash", "stairs", is_quiet=True)
CYCLO = Listed(joints.ripple_cyclo, "gear_ripple", "sines", is_quiet=True)
FLAP, BAG = (Listed(make, "payload_loose") for make in (payload.loose_flap, payload.loose_bag))
SLIDE, SNAP = (Listed(make, "payload_shift") for make in (payload.shift_slide, payload.shift_snap))
SPRUE, BUCKET = (Listed(make, "payload_mass_change") for make in (payload.mass_sprue, payload.mass_bucket))
WHIP = Listed(payload.flex_whip, "tool_flexibility", "hasty")
PACK, HOSE = (Listed(make, "cable_drag") for make in (surroundings.cable_pack, surroundings.cable_hose))
HANDS, RAIL = (Listed(make, "external_contact") for make in (surroundings.contact_hands, surroundings.contact_rail))

STEADY: tuple[Kind, ...] = ("stairs", "pick")
"""In which joints that give a little do not ring."""
MOTIONS: tuple[Kind, ...] = ("stairs", "sines", "pick", "stairs", "dash", "sines", "hasty")
FORMS = (
    Form(rate=200, is_labelled=True),
    Form(rate=250, extras="speeds"),
    Form(rate=125, is_labelled=True),
    Form(rate=400, extras="commands"),
    Form(rate=100),
)
ODD_FORMS = (
    Form(rate=200, log="poses", is_labelled=True),
    Form(rate=125, uneven=0.3),
    Form(rate=250, is_epoch=True, is_single=True),
    Form(rate=200, is_halved=True),
    Form(rate=60, stated=0),
    Form(rate=160, is_direction=True, extras="drives"),
    Form(rate=100, log="poses", uneven=0.2, is_epoch=True),
    Form(rate=500, step=0.8),
)
ODD_BY = 5
"""Every so many recordings of a group have an odd form."""
OF_MATRIX, MATRIX = ("sensor_gain", "sensor_rotation", "sensor_translation"), ("sensor_crosstalk",)
"""Families that are special cases of a matrix of six by six, as long as there is one payload, and what that is called."""
FAST = Form(rate=500, is_labelled=True)
"""For what rings or ripples."""
LONG_S, LONG_FORM = 240.0, Form(rate=50, is_labelled=True)
"""For what creeps."""


def _choose_form(place: int, *causes: Listed) -> Form:
    """By the place in a group, but for causes that call for one."""
    families = {cause.family for cause in causes}
    if families & {"gear_ripple", "tool_flexibility"}:
        return FAST
    return ODD_FORMS[place // ODD_BY % len(ODD_FORMS)] if place % ODD_BY == 2 else FORMS[place % len(FORMS)]


def _choose_machine(place: int) -> Machine:
    """One after the other, and in each round from the next one on."""
    return MACHINES[(place + place // len(MACHINES)) % len(MACHINES)]


def _choose_seconds(place: int) -> float:
    """About a minute."""
    return SECONDS + 4 * (place % 5 - 2)


def _plant(place: int, causes: tuple[Listed, ...], wanted: tuple[float, ...], redraw: int = 0) -> Order:
    """One cause or two; the machine goes by the place in the group."""
    motion = next((cause.motion for cause in causes if cause.motion), MOTIONS[place % len(MOTIONS)])
    is_long = motion == "crawl"
    return Order(
        kind="single" if len(causes) == 1 else "double",
        name="+".join(cause.maker.__name__ for cause in causes),
        machine=_choose_machine(place),
        motion=motion,
        form=LONG_FORM if is_long else _choose_form(place, *causes),
        families=tuple(cause.family for cause in causes),
        makers=tuple(cause.maker for cause in causes),
        wanted=wanted,
        seconds=LONG_S if is_long else _choose_seconds(place),
        is_quiet=any(cause.is_quiet for cause in causes),
        redraw=redraw,
        defensible=MATRIX if any(cause.family in OF_MATRIX for cause in causes) else (),
    )


def _plant_unlisted(place: int, maker: Maker, wanted: float, defensible: tuple[str, ...], motion: Kind | None) -> Order:
    return Order(
        kind="unknown",
        name=maker.__name__,
        machine=_choose_machine(place),
        motion=motion or MOTIONS[place % len(MOTIONS)],
        form=_choose_form(place),
        makers=(maker,),
        wanted=(wanted,),
        seconds=_choose_seconds(place),
        defensible=defensible,
    )


def _expect_nothing(place: int) -> Order:
    machine, form, motion = MACHINES[place % len(MACHINES)], NOTHING_FORMS[place], NOTHING_MOTIONS[place]
    seconds = {"once": 14.0, "crawl": 200.0}.get(motion, SECONDS + 3 * (place % 5 - 2))
    return Order("none", f"none{place}", machine, motion, form, variant=f"sound, {machine.name}, {form.name}", seconds=seconds)


SINGLES: tuple[tuple[tuple[Listed, ...], tuple[float, ...]], ...] = (
    ((SUN,), (4,)),
    ((KNOCK,), (9,)),
    ((BRIDGE,), (2,)),
    ((BOLTS,), (7,)),
    ((TENSION,), (3.5,)),
    ((SUPPLY,), (10,)),
    ((CLAMP,), (2,)),
    ((GLUE,), (1.9,)),
    ((BEAT,), (6,)),
    ((AVERAGE,), (40,)),
    ((OBSERVER,), (8,)),
    ((BURR,), (2.2,)),
    ((PLATE,), (2.6,)),
    ((SHIMS,), (1.8,)),
    ((SWAP,), (10,)),
    ((REDUCER,), (4,)),
    ((FLAP,), (5,)),
    ((SLIDE,), (2.8,)),
    ((HOSE,), (7,)),
    ((RAIL,), (25,)),
)
PAIRS: tuple[tuple[tuple[Listed, ...], tuple[float, ...]], ...] = (
    ((SUN, HANDS), (4, 8)),
    ((SHIMS, QUEUE), (6, 6)),
    ((PACK, AGED), (7, 3)),
    ((BAG, MORNING), (6, 6)),
    ((BELT, RAIL), (3, 12)),
    ((DOWEL, FLAP), (5, 5)),
    ((SPRUE, HOSE), (9, 4)),
    ((LEAK, SNAP), (5, 5)),
    ((BOND, SHIMS), (3, 6)),
    ((KNOCK, BEAT), (18, 18)),
    ((BRIDGE, SINKING), (3, 9)),
    ((BOLTS, SUN), (2.2, 2.2)),
    ((STOP, HANDS), (4, 10)),
    ((TENSION, BELT), (3, 5)),
    ((SUPPLY, MORNING), (6, 4)),
    ((SUPPLY, SPRUE), (8, 8)),
    ((CLAMP, SINKING), (2.5, 7)),
    ((CLAMP, RAIL), (2.6, 9)),
    ((GLUE, BUCKET), (2, 6)),
    ((GLUE, SHIMS), (2.2, 4)),
    ((BEAT, FLAP), (7, 4)),
    ((QUEUE, AGED), (2.5, 2.5)),
    ((OIL, SHIMS), (12, 9)),
    ((OIL, BRIDGE), (14, 4)),
    ((OIL, HANDS), (10, 12)),
    ((OBSERVER, DOWEL), (6, 6)),
    ((OBSERVER, SUN), (8, 3)),
    ((OBSERVER, LEAK), (10, 10)),
    ((BURR, SPRUE), (4, 7)),
    ((DOWEL, HOSE), (10, 4)),
    ((PLATE, KNOCK), (2.5, 5)),
    ((PLATE, TENSION), (2.8, 4)),
    ((SWAP, BAG), (5, 5)),
    ((BELT, BOND), (8, 3)),
    ((WRIST, SNAP), (3.5, 3.5)),
    ((REDUCER, MORNING), (3, 7)),
    ((REDUCER, RAIL), (3, 12)),
    ((WORM, AGED), (1.8, 3.5)),
    ((WORM, BOND), (1.9, 5)),
    ((CYCLO, SHIMS), (4, 4)),
    ((CYCLO, MORNING), (2.5, 9)),
    ((SLIDE, PACK), (6, 6)),
    ((BUCKET, HANDS), (15, 15)),
    ((WHIP, SUN), (6, 6)),
    ((WHIP, BELT), (8, 4)),
)
REDRAWN: dict[tuple[Listed, ...], int] = {(DOWEL, HOSE): 2}
"""Pairs whose first draws hid one of the two behind the other."""
UNLISTED: tuple[tuple[Maker, float, tuple[str, ...], Kind | None], ...] = (
    (unlisted.u_triboelectric, 5, (), None),
    (unlisted.u_ground, 6, (), None),
    (unlisted.u_supply_sag, 4, ("sensor_gain",), "dash"),
    (unlisted.u_radio, 7, ("external_contact",), None),
    (unlisted.u_beacon, 2, ("sensor_interference",), None),
    (unlisted.u_weld, 6, ("external_contact",), "stairs"),
    (unlisted.u_charge, 12, ("sensor_creep", "sensor_drift"), "stairs"),
    (unlisted.u_stuck_bit, 4, ("sensor_nonlinearity", "sensor_quantization"), "sines"),
    (unlisted.u_autorange, 5, ("sensor_nonlinearity", "sensor_hysteresis"), "stairs"),
    (unlisted.u_deadband, 5, ("sensor_nonlinearity",), "sines"),
    (unlisted.u_slew, 12, ("sensor_lowpass", "time_delay"), "dash"),
    (unlisted.u_foreign, 8, ("sample_dropout", "sensor_noise"), None),
    (unlisted.u_ratio, 6, ("joint_offset",), "stairs"),
    (unlisted.u_coupling, 8, ("joint_offset",), "sines"),
    (unlisted.u_gantry, 2.5, (), None),
    (unlisted.u_lift, 3, (), "pick"),
    (unlisted_tool.u_valve, 6, ("external_contact", "sensor_offset_step"), "stairs"),
    (unlisted_tool.u_compressor, 2, ("sensor_drift",), None),
    (unlisted_tool.u_unbalance, 4, ("sensor_interference",), None),
    (unlisted_tool.u_runup, 5, ("external_contact",), "sines"),
    (unlisted_tool.u_bath, 12, ("external_contact",), "stairs"),
    (unlisted_tool.u_slider, 4, ("payload_shift", "payload_loose"), None),
    (unlisted_tool.u_film, 2.5, ("external_contact", "cable_drag"), "stairs"),
    (unlisted_tool.u_cycle, 20, ("payload_mass_change",), "pick"),
    (unlisted_tool.u_airlock, 5, ("sensor_drift",), None),
)
NOTHING_MOTIONS: tuple[Kind, ...] = ("stairs", "sines", "pick", "dash", "hasty", "sines", "crawl", "stairs", "once", "dash")
NOTHING_FORMS = (*FORMS, ODD_FORMS[0], LONG_FORM, ODD_FORMS[5], Form(rate=250, extras="speeds"), Form(rate=200))
GROUPS = (
    tuple(_plant(place, causes, wanted) for place, (causes, wanted) in enumerate(SINGLES)),
    tuple(_plant(place, causes, wanted, REDRAWN.get(causes, 0)) for place, (causes, wanted) in enumerate(PAIRS)),
    tuple(_plant_unlisted(place, *each) for place, each in enumerate(UNLISTED)),
    tuple(_expect_nothing(place) for place in range(len(NOTHING_FORMS))),
)
"""Orders; a hundred seeds are kept for each."""


def list_cases() -> list[Case]:
    """All of them, by number; arms give a little in steady motions alone, and not where the sensor is quiet or nothing is planted."""
    numbered = number_orders(GROUPS, FIRST_SEED, ELASTIC_BY, ELASTIC_COUNT)
    return [Case(number, OWN_KEYS + key, order, gives and _may_give(order)) for number, key, order, gives in numbered]


def _may_give(order: Order) -> bool:
    return order.motion in STEADY and not order.is_quiet and order.kind != "none"
