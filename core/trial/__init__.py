"""The blind check: faults planted in the virtual robot, sealed, diagnosed, and only then compared with the truth.

The faults (`core.plant.faults`) share no code with the effects that are fitted. Small imperfections are always on, so that "none" is never
perfectly none; half of the faults have another shape than the models, and some are of a kind that the library does not have.
"""

from __future__ import annotations

from core.trial.draw import CELLS, DrawnTrial, Sealed, draw, plan_each_payload
from core.trial.outcome import TrialOutcome
from core.trial.run import run_trial

__all__ = ["CELLS", "DrawnTrial", "Sealed", "TrialOutcome", "draw", "plan_each_payload", "run_trial"]
