"""What a fit leaves, in a few numbers: the evidence that probabilities are worked out from, and learnt from."""

from __future__ import annotations

import numpy as np
from pydantic import BaseModel, ConfigDict
from scipy.fft import dct

from core.array import Array
from core.gap.effect_fit import EffectFit

BLOCKS = 10
"""Stretches of the recording, of equal lengths, in which two fits are compared."""
EDGES = (0.1, 0.4)
"""Between low, middle and high frequencies, in halves of the rows' rate."""


class Trace(BaseModel):
    """One fit.

    Args:
        name: identifiers joined by a plus sign; `none` for the nominal twin.
        effects: how many.
        free: how many parameters were fitted.
        at_bound: how many of them ended at a bound of what is plausible.
        size: the largest of them, in plausible sizes.
        rows: how many equations there are.
        by_block: (10,), chi-square on unseen motions, in each stretch of the recording.
        by_channel: (6,), the same by channel.
        by_band: (3,), chi-square per row of the residual at low, middle and high frequencies.
        lag: (6,), correlation between neighbouring rows of the residual.
        log_evidence: Laplace's.
        payload_error, payload_std: (10,), of the payload against the true one, and its standard uncertainty; none in older files.
    """

    model_config = ConfigDict(frozen=True, allow_inf_nan=False)

    name: str
    effects: int
    free: int
    at_bound: int
    size: float
    rows: int
    by_block: tuple[float, ...]
    by_channel: tuple[float, ...]
    by_band: tuple[float, ...]
    lag: tuple[float, ...]
    log_evidence: float
    payload_error: tuple[float, ...] = ()
    payload_std: tuple[float, ...] = ()

    @property
    def further(self) -> int:
        """Effects beyond the first."""
        return max(0, self.effects - 1)

    @property
    def chi_square(self) -> float:
        """On unseen motions, of all rows."""
        return sum(self.by_block)


def trace_of(fit: EffectFit, phi: Array) -> Trace:
    """The numbers of one fit to a recording of the payload phi (10,)."""
    r, held_out = fit.residual, fit.held_out
    fitted = [(v, p) for v, p in zip(fit.theta, fit.parameters, strict=True)][: len(fit.theta) - fit.kept_absent]
    away = [abs(v - p.absent) / p.scale for v, p in fitted]
    bound = [v <= p.lower or v >= p.upper for v, p in fitted]
    power, edges = dct(r, norm="ortho", axis=1) ** 2, [round(share * r.shape[1]) for share in EDGES]
    lag = (r[:, 1:] * r[:, :-1]).sum(axis=1) / np.maximum((r**2).sum(axis=1), 1e-300)
    return Trace(
        name=fit.name,
        effects=len(fit.effects),
        free=fit.free,
        at_bound=sum(bound),
        size=float(max(away, default=0.0)),
        rows=held_out.size,
        by_block=tuple(float(part.sum()) for part in np.array_split(held_out, BLOCKS, axis=1)),
        by_channel=tuple(held_out.sum(axis=1).tolist()),
        by_band=tuple(float(band.mean()) if band.size else 0.0 for band in np.split(power, edges, axis=1)),
        lag=tuple(lag.tolist()),
        log_evidence=fit.log_evidence,
        payload_error=tuple((fit.phi - phi).tolist()),
        payload_std=tuple(fit.phi_std.tolist()),
    )
