"""The check of a recording's set-up: first what is dead, then geometry, clock and units, then what is stated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.estimation.setup.channels import find_dead_channel, find_dead_wrench, remarks_on_force, remarks_on_rows
from core.estimation.setup.clock import check_clock, remark_on_rate
from core.estimation.setup.payload_fit import PayloadFit, fit_payload
from core.estimation.setup.relations import explain_relations, sign_by_motion
from core.estimation.setup.search import BAD, FEWEST, LONGEST_LEVER_M, SetupExplanation, explain_motion, explain_stances
from core.estimation.setup.stances import Stances, stances_of
from core.estimation.setup.stated_figures import FAR_BEYOND, beyond_range, units_by_figures
from core.estimation.setup.units import FORCE_UNITS, TORQUE_UNITS
from core.recording.recording import Recording
from core.words.message import Message

HEAVIEST_KG = 2000.0
SHORTEST_LEVER_M = 0.003
SAME_AS = {"setup-torque-about-another-point": "sensor_translation"}
"""Effects of the library that do the same as a slip, by its message."""


@dataclass(frozen=True)
class SetUp:
    """What the check found.

    Args:
        contradiction: why nothing can be estimated before the set-up is corrected, with the likely slip; None where nothing speaks against.
        remarks: what should be known before the numbers are used.
        weighed: what the simplest model makes of the poses; None where there are none.
    """

    contradiction: Message | None = None
    remarks: tuple[Message, ...] = ()
    weighed: PayloadFit | None = None

    @property
    def effect(self) -> str | None:
        """Identifier of the effect that does the same as the one slip which is named, so that a diagnosis can hold others against it."""
        slip = None if self.contradiction is None else self.contradiction.parameters.get("slip")
        return SAME_AS.get(slip.code) if isinstance(slip, Message) else None


def check_setup(recording: Recording) -> SetUp:
    """Whether the recording is what it states to be; the recording is only read."""
    dead = find_dead_wrench(recording)
    if dead is not None:
        return SetUp(dead)
    rate = remark_on_rate(recording)
    remarks = (*remarks_on_rows(recording), *([] if rate is None else [rate]))
    stances = stances_of(recording)
    if stances is None or recording.wrench is None:
        return SetUp(None, remarks)
    fit = fit_payload(stances)
    contradiction = (
        find_dead_channel(recording, stances) or _check_geometry(stances, fit) or _check_clock_and_units(recording, stances, fit)
    )
    beyond = beyond_range(recording)
    return SetUp(contradiction, (*remarks, *([] if beyond is None else [beyond]), *remarks_on_force(stances)), fit)


def _check_geometry(stances: Stances, fit: PayloadFit) -> Message | None:
    found = explain_stances(stances, fit)
    if found is None:
        return None
    if fit.misfit >= BAD:
        return Message.of("setup-fits-better", times=found.times, slip=_either(found.names))
    sign = sign_by_motion(fit) if stances.position is not None else 0
    wrench, gravity = found.names
    names = {0: found.names, -1: (wrench,), 1: (gravity,)}[sign]
    return Message.of("setup-mass-negative", mass_kg=fit.mass, slip=_either(names))


def _check_clock_and_units(recording: Recording, stances: Stances, fit: PayloadFit) -> Message | None:
    figures = units_by_figures(recording, fit)
    moving = stances.moves and stances.position is not None and fit.misfit < BAD and stances.distinct >= FEWEST
    related = explain_relations(fit) if moving else None
    if related is not None:
        return Message.of("setup-motion-agrees", slip=_either(_narrow(related, figures)))
    moved = explain_motion(stances, fit) if moving else None
    if moved is not None:
        return Message.of("setup-fits-better", times=moved.times, slip=_either(moved.names))
    clock = check_clock(recording)
    if clock is not None:
        return clock
    if figures:
        return Message.of("setup-figures-agree", slip=_both(figures))
    return beyond_range(recording, FAR_BEYOND) or _check_size(fit)


def _narrow(found: SetupExplanation, figures: tuple[Message, ...]) -> tuple[Message, ...]:
    """Of slips that motion does not tell apart, those that what is stated speaks for."""
    return tuple(name for name in found.names if name in figures) or found.names


def _check_size(fit: PayloadFit) -> Message | None:
    """A payload that no robot carries, with the units that would make it one that it does."""
    if not (fit.upright and fit.misfit < BAD):
        return None
    if fit.mass > HEAVIEST_KG:
        fitting = [unit for unit, k in FORCE_UNITS.items() if k > 1.0 and fit.mass / k < HEAVIEST_KG / 10.0]
        return Message.of("setup-mass-too-large", mass_kg=fit.mass, units=fitting)
    lever_std = float(np.sqrt(np.trace(fit.covariance[2:5, 2:5]))) / fit.mass
    if fit.lever_m < LONGEST_LEVER_M or fit.lever_m < 5.0 * lever_std:
        return None
    fitting = [unit for unit, k in TORQUE_UNITS.items() if k > 2.0 and SHORTEST_LEVER_M < fit.lever_m / k < 0.5]
    return Message.of("setup-lever-too-long", lever_m=fit.lever_m, units=fitting)


def _either(names: tuple[Message, ...]) -> Message:
    said = names[0]
    for name in names[1:]:
        said = Message.of("setup-either", first=said, second=name)
    return said


def _both(names: tuple[Message, ...]) -> Message:
    said = names[0]
    for name in names[1:]:
        said = Message.of("setup-both", first=said, second=name)
    return said
