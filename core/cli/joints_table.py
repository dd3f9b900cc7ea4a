"""What was found of each joint, as the command line prints it."""

from __future__ import annotations

from collections.abc import Sequence

from rich.table import Table

from core.cli.tables import INTERVAL, number
from core.cli.terminal import find_wording
from core.estimation.joint_part import JointPart


def joints_table(joints: Sequence[JointPart]) -> Table:
    """Friction, gain with its 95 % half-width, and what is left, of each joint that could be used."""
    words = find_wording()
    table = Table(title=words.say("result-joints-title"))
    table.add_column("", no_wrap=True)
    for heading in (
        words.say("result-joints-coulomb"),
        words.say("result-joints-viscous"),
        words.say("result-joints-gain"),
        words.say("result-joints-residual"),
        words.say("result-joints-windows"),
    ):
        table.add_column(heading, justify="right")
    for joint in joints:
        gain = words.mark(f"{100 * joint.gain:.1f} ± {100 * INTERVAL * joint.gain_std:.1f}")
        friction = (number(joint.coulomb_n_m, 3), number(joint.viscous_n_m_s, 3))
        table.add_row(joint.joint, *friction, gain, number(joint.residual_n_m, 2), str(joint.windows))
    return table
