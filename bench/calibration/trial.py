"""One simulated trial: what was planted, and the evidence that the fits left."""

from __future__ import annotations

import time

import numpy as np
from pydantic import BaseModel, ConfigDict
from threadpoolctl import threadpool_limits

from bench.calibration.planting import Planted, plant_trial
from bench.calibration.trace import Trace, trace_of
from core.effects.library import library
from core.gap.basis import basis_of
from core.gap.closure import gap_of
from core.gap.effect_fit import fit_nominal
from core.gap.evidence import Evidence, gather
from core.gap.fit_all import one_by_one
from core.gap.limits import GAP
from core.gap.materiality import find_farthest, find_margins
from core.gap.windows import Windows
from core.version import code_version


class Trial(BaseModel):
    """What is kept of a trial.

    Args:
        families, variants: of what was planted, sorted by family.
        size: in plausible sizes.
        gap: that the nominal twin leaves.
        matters: whether what was planted lifts the gap above 2, or moves the payload by what matters.
        material: whether the diagnosis took it to.
        margins: by how much, each of `core.gap.materiality.Margins`; None where the reference tells nothing.
        traces: the nominal twin's first.
        seconds: of processor time.
    """

    model_config = ConfigDict(frozen=True)

    seed: int
    families: tuple[str, ...]
    variants: tuple[str, ...]
    size: float
    gap: float
    matters: bool
    material: bool
    margins: tuple[float, float, float | None]
    traces: tuple[Trace, ...]
    seconds: float
    version: str

    @property
    def truth(self) -> str:
        """As traces are named: `none`, `unknown`, or what was planted."""
        return "+".join(self.families) or "none"


def run_trial(seed: int) -> Trial:
    """Plants, records, fits; on one core."""
    began = time.process_time()
    with threadpool_limits(1):
        planted = plant_trial(seed)
        windows = Windows(basis_of(planted.recording))
        evidence = gather(windows, library(), one_by_one)
    margins = find_margins(evidence.windows, evidence.nominal, evidence.best)
    return Trial(
        seed=seed,
        families=planted.families,
        variants=planted.variants,
        size=planted.size,
        gap=gap_of(windows, evidence.nominal),
        matters=bool(planted.families) and does_matter(windows, evidence, planted),
        material=evidence.material,
        margins=(margins.gap, margins.moved, None if np.isnan(margins.reference) else margins.reference),
        traces=tuple(trace_of(fit, planted.phi) for fit in (evidence.nominal, *evidence.singles, *evidence.joined)),
        seconds=time.process_time() - began,
        version=code_version(),
    )


def does_matter(windows: Windows, evidence: Evidence, planted: Planted) -> bool:
    """By the rules of `core.gap.materiality`, against what the same run comes to without what was planted: what noise and background do to
    the payload is none of it. How well that is known is what the fit of what was planted says."""
    nominal, sound = evidence.nominal, fit_nominal(Windows(basis_of(planted.sound)))
    std = next((fit.phi_std for fit in evidence.singles if fit.name in planted.families), sound.phi_std)
    return gap_of(windows, nominal) > GAP or find_farthest(nominal.phi - sound.phi, planted.phi, std) > 1.0
