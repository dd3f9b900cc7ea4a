"""Windows so fine that what rings faster than arms move shows in them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array

from core.gap.closure import gap_of
from core.gap.effect_fit import EffectFit, fit_nominal
from core.gap.limits import GAP
from core.gap.singles import fit_again
from core.gap.weighing import find_left_share
from core.gap.windows import Rows, Windows, window_rows

FINE_S = 0.025
"""Between them: tools ring up to some 20 Hz."""
MOST = 0.5
"""Share of what the nominal twin leaves there that an effect explains, at least, where it is to be diagnosed there."""


def refine(windows: Windows) -> Windows:
    """Finer ones where these are, each of the stretch of the one that it is nearest to; the same where they are as fine."""
    if windows.step <= FINE_S:
        return windows
    basis, centres = windows.basis, windows.centres
    rows = window_rows(basis.poses, basis.scene.t, basis.rows.every, FINE_S)
    after = np.clip(np.searchsorted(centres, rows.centres), 1, len(centres) - 1)
    nearest = after - (rows.centres - centres[after - 1] < centres[after] - rows.centres)
    kept = np.flatnonzero(np.abs(rows.centres - centres[nearest]) <= basis.rows.step)
    stretch = basis.rows.part[nearest[kept]]
    fine = Rows(rows.centres[kept], rows.step, csr_array(rows.average[kept]), stretch, rows.every, basis.rows.at_rest)
    return Windows(replace(basis, rows=fine, scene=replace(basis.scene, residual_window=fine.step)), windows.held)


def find_what_rings(windows: Windows, nominal: EffectFit, best: EffectFit) -> Windows | None:
    """Finer windows, where an effect that does not matter in these explains a gap there that does."""
    if not best.effects or windows.basis.scene.apart or gap_of(windows, nominal) > GAP:
        return None
    fine = refine(windows)
    if fine.step >= windows.step:
        return None
    seen = fit_nominal(fine)
    if gap_of(fine, seen) <= GAP:
        return None
    explained = fit_again(best, seen).run(fine)
    return fine if find_left_share(seen, explained) < 1.0 - MOST else None
