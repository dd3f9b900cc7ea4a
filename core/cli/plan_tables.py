"""The tables of a plan that the command line prints, in the terminal's language; whoever prints a result waits for no planner."""

from __future__ import annotations

import numpy as np
from rich.table import Table

from core.cli.tables import format_decimals
from core.cli.terminal import find_wording
from core.planning.plan import Plan
from core.planning.settings import Scope
from core.planning.summary import PlanTorques
from core.second_opinion.opinion import Opinion
from core.second_opinion.pairs import PairKind
from core.words.message import Message
from core.words.wording import Wording

PAIRS = {
    PairKind.ENVIRONMENT: Message.of("result-pairs-environment"),
    PairKind.FIRST_LINK: Message.of("result-pairs-first-link"),
    PairKind.MOUNT: Message.of("result-pairs-mount"),
    PairKind.PAYLOAD: Message.of("result-pairs-payload"),
    PairKind.LINKS: Message.of("result-pairs-links"),
    PairKind.NEAR: Message.of("result-pairs-near"),
    PairKind.JOINED: Message.of("result-pairs-joined"),
}


def plan_table(plan: Plan) -> Table:
    """Where each pose is, how close it gets, and how long it takes."""
    words = find_wording()
    table = Table(title=words.say("result-plan-title"))
    table.add_column(words.say("result-axis"))
    table.add_column(words.say("result-joints"))
    table.add_column(words.say("result-clearance"), justify="right")
    table.add_column(words.say("result-nearest"))
    for heading in (
        words.say("result-manipulability"),
        words.say("result-transfer"),
        words.say("result-least-margin"),
        words.say("result-rotation"),
    ):
        table.add_column(heading, justify="right")
    for leg in plan.legs:
        table.add_row(
            leg.axis,
            " ".join(f"{v:.0f}" for v in np.degrees(leg.start.q)),
            format_decimals(leg.start.clearance_m, 3),
            words.quote(leg.start.nearest),
            format_decimals(leg.start.manipulability, 3),
            format_decimals(leg.transfer.trajectory.duration, 1),
            format_decimals(leg.transfer.least_margin_m, 3),
            format_decimals(leg.moving_s, 1) if leg.moving_s else "",
        )
    home = plan.home
    times = format_decimals(home.trajectory.duration, 1), format_decimals(home.least_margin_m, 3)
    table.add_row(words.say("result-home"), "", "", "", "", *times, "")
    return table


def wave_lines(plan: Plan) -> list[str]:
    """What all joints do at a stop, a line for each wave."""
    waves = [(leg.axis, leg.stop.wave, leg.wave) for leg in plan.legs if leg.stop.wave is not None and leg.wave is not None]
    return [
        find_wording().say(
            "result-plan-wave",
            axis=axis,
            lowest_hz=wave.lowest_hz,
            highest_hz=wave.highest_hz,
            wrist=wave.wrist or 1.0,
            swing_rad=float(np.abs(trajectory.q - trajectory.q[0]).max()),
        )
        for axis, wave, trajectory in waves
    ]


def not_excited_lines(scope: Scope) -> list[str]:
    """What a part of the procedure does not show, those with the same reason in one line."""
    words, left_out = find_wording(), scope.not_excited
    return [
        words.say("result-not-excited", names=[name for name in left_out if left_out[name] == why], reason=why)
        for why in dict.fromkeys(left_out.values())
    ]


def opinion_lines(opinion: Opinion) -> list[str]:
    """What the second opinion found, a line for each kind of pair and one for the fastest point."""
    words, fast, lost = find_wording(), opinion.fastest, opinion.lost_load
    lines = [
        words.say(
            "result-opinion-pair",
            kind=PAIRS[each.kind],
            first=each.first,
            second=each.second,
            distance_m=each.distance_m,
            required_m=each.required_m,
            part=each.part,
            time_s=each.time_s,
        )
        for each in opinion.approaches
    ]
    lines.append(
        words.say(
            "result-opinion-fastest",
            body=fast.body,
            speed_m_s=fast.speed_m_s,
            limit_m_s=fast.limit_m_s,
            part=fast.part,
            time_s=fast.time_s,
        )
    )
    left_out = _list_left_out(opinion, words)
    said = [words.say("result-opinion", samples=opinion.samples), *(f"  {line}" for line in lines)]
    said += [words.say("result-opinion-left-out"), *(f"  {line}" for line in left_out)] if left_out else []
    if lost is None:
        return said
    flight = words.say("result-opinion-lost-load", zone=lost.zone, distance_m=lost.distance_m, part=lost.part, time_s=lost.time_s)
    return [*said, f"  {flight}"]


def _list_left_out(opinion: Opinion, words: Wording) -> list[str]:
    """The pairs of which nothing is asked, those with the same reason in one line."""
    return [
        words.say(
            "result-opinion-left-out-because",
            pairs=[
                Message.of("result-opinion-left-out-pair", first=pair.first, second=pair.second)
                for pair in opinion.left_out
                if pair.why == why
            ],
            reason=why,
        )
        for why in dict.fromkeys(pair.why for pair in opinion.left_out)
    ]


def torque_lines(torques: PlanTorques) -> list[str]:
    """What the plan asks of the joints, and which of them could not be judged."""
    words, most = find_wording(), torques.largest
    if most is None:
        line = words.say("result-torques-not-judged", mass_kg=torques.mass_kg, load=torques.load)
    else:
        line = words.say(
            "result-torques",
            mass_kg=torques.mass_kg,
            load=torques.load,
            torque_n_m=most.torque_n_m,
            limit_n_m=most.limit_n_m,
            ratio=most.ratio,
            joint=most.joint,
            part=most.part,
            time_s=most.time_s,
        )
    return [line, *(f"  {words.say('result-joint-not-judged', reason=why)}" for why in torques.not_judged)]
