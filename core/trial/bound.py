"""What any method could tell of a trial: the fault's own size against the noise, by the same run without it.

Two simulations with one seed, with and without the fault, share their noise sample by sample. Their difference, the nominal prediction
from what the joints reported taken off each, is what the fault does to the residual, free of noise. It is whitened as the diagnosis
whitens, and the nominal twin is fitted to it: what another payload, another offset and small imperfections make up for does not count.
"""

from __future__ import annotations

from copy import copy

import numpy as np
from pydantic import BaseModel, ConfigDict

from core.array import Array
from core.effects.library import symptoms
from core.gap.basis import basis_of
from core.gap.effect_fit import EffectFit, fit_effects, fit_nominal
from core.gap.evidence import Evidence
from core.gap.fit_all import pair_of
from core.gap.limits import GAP
from core.gap.materiality import find_farthest, is_material
from core.gap.tie import distance_sigma
from core.gap.windows import PHI, Windows
from core.recording.recording import Recording

RIVALS = 4
"""The nearest rival is among so many that explain the recording best."""


class Bound(BaseModel):
    """Distances in standard deviations of the noise; None where the trial has none (effects that are read off the recording directly).

    Two hypotheses that are d apart are confused by the best possible test in a share `Phi(-d / 2)` of all cases.

    Args:
        fault_sigma: from "nothing". Below about 3 nothing can find the fault.
        material_sigma: the `fault_sigma` at which this fault, were it made larger or smaller in proportion, becomes material.
        nearest_rival_sigma: what the nearest other effect cannot follow of the true one's prediction (`core.gap.tie`).
        undescribed_sigma: what the library's best single effect leaves over beyond the run without the fault.
        second_sigma: two faults: what the weaker one adds to the fit of the other.
        second_material: two faults: whether leaving out the weaker one matters.
        added_noise: faults that are read off the recording directly: what they add to the readings, root mean square over the run in the
            channel that has most of it, in standard deviations of a sample's noise.
    """

    model_config = ConfigDict(frozen=True)

    fault_sigma: float | None = None
    material_sigma: float | None = None
    nearest_rival_sigma: float | None = None
    undescribed_sigma: float | None = None
    second_sigma: float | None = None
    second_material: bool | None = None
    added_noise: float | None = None

    @property
    def materiality(self) -> float | None:
        """1 where the fault just becomes material; None where it has no measure in the wrench."""
        if self.fault_sigma is None or self.material_sigma is None:
            return None
        return self.fault_sigma / self.material_sigma


def bound_of(ids: tuple[str, ...], recording: Recording, evidence: Evidence, clean: Recording, nominal: Array, payload: Array) -> Bound:
    """The bound of one trial.

    Args:
        ids: what was planted.
        recording, evidence: with the fault.
        clean: the same run without it.
        nominal, payload: (10,), as the cell has it, and as it truly was.
    """
    if not ids:
        return Bound()
    windows = Windows(basis_of(clean))
    if set(ids) <= {symptom.id for symptom in symptoms()}:
        return Bound(added_noise=_measure_added_noise(recording, clean, windows.basis.noise.std))
    if len(windows) != len(evidence.windows):  # the guard has stopped one of them: other motions, nothing to compare
        return _derive_bound(ids, evidence, None)
    seen = copy(evidence.windows)  # its kinematics, which a fault may have made wrong
    seen.held = ()
    change = seen.whiten((_residual(seen, nominal) - _residual(windows, nominal))[..., None])[..., 0]
    seen.target = change + seen.X[:, :, PHI] @ nominal
    fooled = fit_nominal(seen)
    sigma = _root(fooled.cost)
    std = next((fit.phi_std for fit in evidence.singles if fit.name in ids), fooled.phi_std)
    found = _derive_bound(ids, evidence, fit_nominal(windows).cost)
    material = sigma / max(_materiality(seen, fooled, payload, std), 1e-12)
    return found.model_copy(update={"fault_sigma": sigma, "material_sigma": material})


def _measure_added_noise(recording: Recording, clean: Recording, noise_std: Array) -> float | None:
    """What a fault adds to the readings of a run; None where the guard has stopped one of the two.

    Args:
        noise_std: (6,), of a sample without the fault, N and N m; what the sensor states counts first.
    """
    if recording.wrench is None or clean.wrench is None or len(recording) != len(clean):
        return None
    stated = noise_std if clean.sensor.noise_std is None else np.asarray(clean.sensor.noise_std)
    return float((np.sqrt(np.square(recording.wrench - clean.wrench).mean(axis=0)) / stated).max())


def _residual(windows: Windows, nominal: Array) -> Array:
    """(K, 6), measured less what the nominal payload asks of the sensor in the reported motion, N and N m."""
    return windows.unwhiten(windows.target - windows.X[:, :, PHI] @ nominal)


def _materiality(windows: Windows, fooled: EffectFit, payload: Array, std: Array) -> float:
    """By the rules of `core.gap.materiality`, 1 where the fault just becomes material: the gap that it lifts, or the payload it fakes.

    Args:
        fooled: the nominal twin fitted to what the fault does.
        payload, std: (10,), as it truly was, and how well the true effect's fit knows it.
    """
    gap = float(fooled.held_out.mean()) / windows.samples_per_row / (GAP**2 - 1.0)
    return max(_root(gap), find_farthest(fooled.phi - payload, payload, std))


def _derive_bound(ids: tuple[str, ...], evidence: Evidence, clean_cost: float | None) -> Bound:
    """What the fits tell."""
    fits = {fit.name: fit for fit in evidence.singles}
    true = [fits[name] for name in ids if name in fits]
    best = min((fit.cost for fit in fits.values()), default=evidence.nominal.cost)
    undescribed = None if clean_cost is None else _root(best - clean_cost)
    if len(ids) == 1 and true:
        rivals = sorted((fit for fit in fits.values() if fit is not true[0]), key=lambda fit: fit.cost)[:RIVALS]
        nearest = min((distance_sigma(evidence.windows, true[0], fit) for fit in rivals), default=None)
        return Bound(undescribed_sigma=undescribed, nearest_rival_sigma=nearest)
    if len(true) == 2:
        sigma, material = _second(evidence.windows, true)
        return Bound(undescribed_sigma=undescribed, second_sigma=sigma, second_material=material)
    return Bound(undescribed_sigma=undescribed)


def _second(windows: Windows, true: list[EffectFit]) -> tuple[float, bool]:
    """What the weaker of two effects adds, and whether leaving it out matters."""
    alone = min(true, key=lambda fit: fit.cost)
    both = fit_effects(windows, *pair_of(*true))
    return _root(alone.cost - both.cost), is_material(windows, alone, both)


def _root(chi_square: float) -> float:
    return float(np.sqrt(max(0.0, chi_square)))
