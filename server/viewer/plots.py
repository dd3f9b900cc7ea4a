"""The wrench of the last seconds beside the scene: measured, and as the estimate so far says it should be.

Symbols, no words: one viser server draws for people of every language.
"""

from __future__ import annotations

from collections import deque

import numpy as np
import viser
from viser import uplot

from core.array import Array
from server.runner.live_schemas import LiveBatch

SHOWN_S = 12.0
PERIOD_S = 0.1
"""Each change sends a whole plot again."""
COLOURS = ("#3c5a82", "#be7814", "#646a70")
TIME = "s"
UNKNOWN = "m = ?"


class Plots:
    """Force and torque on one viser server.

    Args:
        server: whose panel they stand in.
    """

    def __init__(self, server: viser.ViserServer) -> None:
        self._rows: deque[Array] = deque()
        with server.gui.add_folder("f, τ, m", expand_by_default=False):
            self._force = _plot(server, "f, N", ("fx", "fy", "fz"))
            self._torque = _plot(server, "τ, N m", ("tx", "ty", "tz"))
            self._mass = server.gui.add_markdown(UNKNOWN)

    def append(self, batch: LiveBatch) -> None:
        """The last sample of a batch; a run that is another one begins anew."""
        fit = batch.reconstructed or [np.nan] * 6
        row = np.array([batch.t_s[-1], *batch.wrench[-1], *fit])
        if self._rows and 0.0 <= row[0] - self._rows[-1][0] < PERIOD_S:
            return
        if self._rows and row[0] < self._rows[-1][0]:
            self._rows.clear()
        self._rows.append(row)
        while row[0] - self._rows[0][0] > SHOWN_S:
            self._rows.popleft()
        t, wrench, fits = np.split(np.array(self._rows).T, (1, 7))
        self._force.data = (t[0], *wrench[:3], *fits[:3])
        self._torque.data = (t[0], *wrench[3:], *fits[3:])
        self._mass.content = mass_so_far(batch)


def mass_so_far(batch: LiveBatch) -> str:
    """The estimate so far with its standard uncertainty."""
    mass, std = batch.phi[0], batch.phi_std[0]
    if mass is None:
        return UNKNOWN
    return f"m = {mass:.3f} kg" if std is None else f"m = {mass:.3f} ± {std:.3f} kg"


def _plot(server: viser.ViserServer, title: str, names: tuple[str, ...]) -> viser.GuiUplotHandle:
    drawn = tuple(zip(names, COLOURS, strict=True))
    measured = [uplot.Series(label=name, stroke=colour, width=1.5) for name, colour in drawn]
    fitted = [uplot.Series(label=f"{name}(φ)", stroke=colour, width=1.0, dash=(4.0, 4.0)) for name, colour in drawn]
    return server.gui.add_uplot(
        data=(np.zeros(1), *np.zeros((6, 1))),
        series=(uplot.Series(label=TIME), *measured, *fitted),
        title=title,
        scales={"x": uplot.Scale(time=False)},
        aspect=1.6,
    )
