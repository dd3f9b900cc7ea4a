"""Probabilities of the diagnosis, learnt from simulated trials: `python -m bench.calibration FOLDER`, which says the rest."""
