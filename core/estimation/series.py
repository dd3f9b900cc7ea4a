"""Results as a series of runs takes them: what each has measured, and the reference that they name as something known beforehand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.errors import BadInput
from core.estimation.determination import scales
from core.estimation.result import Result
from core.payload.random_effects import Measured
from core.payload.uncertain_parameters import UncertainParameters


def measure_result(result: Result) -> Measured:
    """What a result says of the payload, and how certainly; nothing where nothing was identified.

    What stays the same from run to run (type B) is shared by all runs that name it: gains of one sensor, zeros of one robot. A twin's part
    is none of that, since its effects are fitted anew to each recording.
    """
    if result.estimate is None:
        return Measured(UncertainParameters(np.full(10, np.nan), np.full((10, 10), np.nan)))
    phi, budget = np.array(result.estimate.phi, dtype=float), result.estimate.budget
    if budget is None:
        return Measured(UncertainParameters(phi, np.array(result.estimate.covariance, dtype=float)))
    shared = {source.name: np.array(source.directions, dtype=float).reshape(-1, 10).T for source in budget.sources if source.name != "twin"}
    return Measured(UncertainParameters(phi, np.array(budget.repeatability, dtype=float)), shared)


def prior_of(results: Sequence[Result], share: float) -> tuple[UncertainParameters, str | None]:
    """The reference that the runs name, known to a share of the size that each parameter is measured by, one standard deviation.

    Returns:
        it in the sensor's frame, and where it is from.

    Raises:
        BadInput: they name none, or different ones.
    """
    references = [result.reference for result in results if result.reference is not None]
    if not references:
        raise BadInput("prior", "estimation-no-reference")
    phi = np.array(references[0].phi, dtype=float)
    for other in references[1:]:
        if not np.allclose(np.array(other.phi, dtype=float), phi, rtol=1e-6, atol=1e-12):
            raise BadInput("prior", "estimation-different-references")
    return UncertainParameters(phi, np.diag((share * scales(phi)) ** 2)), references[0].source
