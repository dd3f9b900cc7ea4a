"""Diagnoses made up for the report: one of each verdict, and what the worst motion is drawn from."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from core.effects.effect import Side
from core.gap.answer import (
    Also,
    Change,
    Diagnosis,
    Experiment,
    Explanation,
    GapPart,
    Minor,
    Pair,
    PatchPart,
    PayloadPart,
    PhiPart,
    Tied,
    Value,
    Where,
)
from core.report.diagnosis_page import Overlay
from core.words.message import Message

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")
PHI = [2.0, 0.1, 0.0, 0.0, 0.02, 0.0, 0.0, 0.04, 0.0, 0.03]


def say(text: str) -> Message:
    """Words that stand in no catalogue."""
    return Message.of("text", text=text)


def effect(name: str, title: str, probability: float, closure: float, **parameters: Value) -> Explanation:
    interval = (closure - 0.02, closure + 0.01)
    advice = f"fix {title}"
    return Explanation(
        id=name, title=say(title), stage="timing", probability=probability, parameters=parameters, gap_after=1.25,
        closure=closure, closure_interval=interval, advice=say(advice),
    )  # fmt: skip


def seen(name: str, title: str, side: Side, *, material: bool = False) -> Also:
    """Something beside the verdict."""
    return Also(
        id=name, title=say(title), side=side, parameters={}, times_expected=2.03, material=material, message=say(f"there is {title}"),
        advice=say(f"do without {title}"),
    )  # fmt: skip


@cache
def explained() -> Diagnosis:
    """A delay, clearly; two rivals that are not."""
    delay = effect("time_delay", "a late wrench", 0.93, 0.97, delay_s=Value(value=0.0123, std=0.0004, unit="s"))
    lag = effect("kinematic_lag", "a lag of the motion", 0.04, 0.6, lag_s=Value(value=0.1, std=None, unit="s", at_bound=True))
    tilt = effect("base_tilt", "a tilted base", 0.003, 0.12, about_x_rad=Value(value=0.01, std=0.001, unit="rad"))
    cells = [("tx", "rotate:y", (0.0, 2.0), 14.2, 0.5), ("tx", "rotate:y", (2.0, 8.0), 3.0, 0.1), ("fz", "hold:x+", (0.0, 2.0), 1.5, 0.05)]
    shifted = [PHI[0], PHI[1], 0.0, 0.0, 0.022, *PHI[5:]]
    return Diagnosis(
        verdict="explained",
        summary=say("The gap is explained by a late wrench"),
        effects=[delay, lag, tilt],
        none_probability=0.0,
        unknown_probability=0.02,
        pairs=[Pair(ids=("time_delay", "base_tilt"), probability=0.007, gap_after=1.1, closure=0.98)],
        minor=[
            Minor(
                id="joint_friction", parameters={"joint_1_coulomb_nm": Value(value=3.0, std=0.1, unit="N m")}, message=say("joint 1 rubs")
            )
        ],
        also=[seen("sensor_noise", "noise above what is stated", "reading", material=True), seen("joint_friction", "friction", "joints")],
        indistinguishable=[],
        where=Where(
            cells=[PatchPart(channel=c, phase=p, band_hz=b, times_noise=n, share=s) for c, p, b, n, s in cells],
            channel="tx",
            phase="rotate:y",
            stage="timing",
            by_time=[0.1, 0.7, 0.2],
            by_direction={"positive": 4.0, "still": 1.0},
            message=say("the gap is largest in tx"),
        ),
        gap=GapPart(
            before=9.8,
            after=1.25,
            held_out=["hold:x+", "rotate:y"],
            by_channel={c: Change(before=9.0 - k, after=2.5 if c == "ty" else 1.0) for k, c in enumerate(CHANNELS)},
        ),
        payload=PayloadPart(before=PhiPart(phi=shifted, std=[1e-4] * 10), after=PhiPart(phi=PHI, std=[1e-4] * 10)),
        consequence=say("left out, it changes the inertia"),
        next_experiment=None,
        limits=[say("drift of the sensor's offset: no temperature was recorded")],
        seconds=6.1,
    )


def with_verdict(verdict: str, **changes: Any) -> Diagnosis:
    return explained().model_copy(update={"verdict": verdict, "summary": say(f"this is {verdict}"), **changes})


@cache
def overlay() -> Overlay:
    """The middle motion is the worst, there in fz and tx."""
    random = np.random.default_rng(0)
    t = np.linspace(0.0, 30.0, 300)
    noise = np.array([0.02, 0.02, 0.03, 0.001, 0.001, 0.001])
    after = np.sin(t)[:, None] * np.array([5, 5, 5, 0.3, 0.3, 0.3])
    before = after.copy()
    before[:100] += 5 * noise
    before[100:200, [2, 3]] += 40 * noise[[2, 3]]
    return Overlay(
        t, np.repeat(["hold:x+", "rotate:y", "hold:x+"], 100), after + random.normal(size=(300, 6)) * noise, before, after, noise
    )


AMBIGUOUS = {
    "indistinguishable": [
        Tied(ids=("time_delay", "kinematic_lag"), distance_sigma=2.14, why=say("both are late"), splits=say("a wide-band motion"))
    ],
    "next_experiment": Experiment(
        id="swings_about_horizontal_x",
        stops=[],
        sigma_before=2.0,
        sigma_after=9.0,
        motion=say("rotate about a horizontal axis"),
        splits=[("time_delay", "kinematic_lag")],
        seconds=12.3,
    ),
}
NOTHING: dict[str, Any] = {
    "effects": [], "pairs": [], "minor": [], "also": [], "where": None, "gap": None, "payload": None, "consequence": None,
    "none_probability": 0.0, "unknown_probability": 0.0, "limits": [say("no wrench was recorded")],
}  # fmt: skip
AGREES: dict[str, Any] = {
    "effects": [], "pairs": [], "none_probability": 1.0, "unknown_probability": 0.0,
    "gap": GapPart(before=1.1, after=1.1, held_out=["hold:x+"], by_channel={"fx": Change(before=1.1, after=1.1)}),
    "payload": PayloadPart(before=PhiPart(phi=PHI, std=[1e-4] * 10), after=PhiPart(phi=PHI, std=[1e-4] * 10)),
}  # fmt: skip
CASES = {
    "explained": with_verdict("explained"),
    "ambiguous": with_verdict("ambiguous", **AMBIGUOUS),
    "unknown": with_verdict("unknown", unknown_probability=0.9),
    "no_gap": with_verdict("no_gap", **AGREES),
    "not_enough": with_verdict("not_enough", **NOTHING),
}
