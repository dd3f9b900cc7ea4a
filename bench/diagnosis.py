"""How long a diagnosis takes: the first screen, the full answer, and how both grow with the recording and the number of effects.

python -m bench.diagnosis
"""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from core.effects.library import library
from core.events import drive
from core.gap.basis import basis_of
from core.gap.effect_fit import fit_nominal
from core.gap.evidence import gather
from core.gap.residual import Residual
from core.gap.windows import Windows
from core.plant.imperfections import Imperfections
from core.procedure.identify import carry_out
from core.recording.recording import Recording
from core.sessions.simulated import SimulatedSession
from core.trial import plan_each_payload


def recorded() -> Recording:
    """A run with 10 ms of delay, every second sample: 500 Hz."""
    cell, plans = plan_each_payload("lwr4_bench")
    carried = cell.payloads["cylinder"]
    session = SimulatedSession(cell, carried.parameters, seed=1, imperfections=Imperfections(wrench_delay_s=0.01))
    return thinned(drive(carry_out(cell, session, carried.box, plans["cylinder"])).recording, slice(None, None, 2))


def thinned(recording: Recording, rows: slice) -> Recording:
    """Some of the samples."""
    columns = ("t", "wrench", "q", "dq", "q_cmd", "tau", "phase")
    return replace(recording, **{name: values[rows] for name in columns if (values := getattr(recording, name)) is not None})


def main() -> None:
    """Prints the table."""
    whole = recorded()
    print(f"{'recording, s':>14}{'effects':>9}{'where, s':>10}{'full answer, s':>16}")
    for share in (0.5, 1.0):
        recording = thinned(whole, slice(0, round(share * len(whole))))
        for effects in (library()[::3], library()):
            began = time.perf_counter()
            windows = Windows(basis_of(recording))
            Residual(windows, fit_nominal(windows)).describe()
            where = time.perf_counter() - began
            gather(windows, effects)
            print(f"{np.ptp(recording.t):14.1f}{len(effects):9d}{where:10.2f}{time.perf_counter() - began:16.1f}", flush=True)


if __name__ == "__main__":
    main()
