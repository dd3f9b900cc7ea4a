"""Cost of the on-line estimation per sample, beside bare filterpy of the same size in the same run: `python -m bench.online`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from time import perf_counter

import numpy as np
from filterpy.kalman import KalmanFilter

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from core.estimation.online import OnlineEstimator
from tests.synthetic import GRAVITY, NOISE_STD, payload, record, run_of


def main() -> None:
    """Prints microseconds per sample and the ratio."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=10_000)
    count = parser.parse_args().count
    run = run_of("lwr4_bench", 0)
    recording = record(run, payload("steel_block"), np.random.default_rng(0))
    assert recording.q is not None and recording.wrench is not None
    estimator = OnlineEstimator(run.robot, GRAVITY, period=1e-3, noise_std=NOISE_STD, encoder_std=2e-6)
    bare = KalmanFilter(dim_x=18, dim_z=6)
    bare.H[:6, :6] = np.eye(6)
    z = np.zeros(6)
    ours, theirs = [], []
    for k in range(min(count, len(recording))):
        start = perf_counter()
        estimator.update(recording.q[k], recording.wrench[k])
        middle = perf_counter()
        bare.predict()
        bare.update(z)
        ours.append(middle - start)
        theirs.append(perf_counter() - middle)
    mine, other = (1e6 * float(np.median(x)) for x in (ours, theirs))
    print(f"on-line estimation, filter and recursions: {mine:.1f} us a sample (median), 99 %: {1e6 * np.quantile(ours, 0.99):.1f} us")
    print(f"bare filterpy predict + update, 18 states, 6 measurements: {other:.1f} us; ratio {mine / other:.2f}")


if __name__ == "__main__":
    main()
