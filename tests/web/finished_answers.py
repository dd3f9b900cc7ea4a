"""A diagnosis of each verdict, made up, for screens that show one."""

from __future__ import annotations

from typing import Any

from core.words.message import Message, Parameter
from server.jobs.kinds import DiagnosisOrder
from server.service import utc_now
from server.store.store import Store
from tests.server.finished_diagnosis import SWINGS, explanation, finished_diagnosis
from tests.server.real_service import RealService


def said(code: str, **parameters: Parameter) -> dict[str, Any]:
    """A message as an answer has it."""
    return Message.of(code, **parameters).model_dump(mode="json")


def effect(name: str, probability: float, advice: dict[str, Any]) -> dict[str, Any]:
    """An effect with what to do about it."""
    return explanation(name, probability) | {"advice": advice}


PAYLOAD = {
    "before": {"phi": [2.8, 0.01, 0.02, 0.3, *[0.01] * 6], "std": [0.001] * 10},
    "after": {"phi": [2.7, 0.01, 0.02, 0.28, *[0.008] * 6], "std": [0.001] * 10},
}
LEVEL = said("advice-base-tilt", first_rad=0.01, first_axis="x", second_rad=0.0, second_axis="y")
ONE_CLOCK = said("advice-time-delay", delay_s=0.004)
FASTER_FILTER = said("advice-sensor-lowpass", cutoff_hz=40.0, delay_s=0.004)
MOTION = said("experiment-swings", axis="x", down="y")
TIE = {"ids": ["time_delay", "sensor_lowpass"], "distance_sigma": 2.0, "why": said("gap-tied", distance_sigma=2.0), "splits": MOTION}
MINOR = {"id": "sensor_noise", "parameters": {}, "message": said("gap-minor")}
NOISY = {
    "id": "sensor_noise", "title": said("effect-sensor-noise-title"), "side": "reading", "times_expected": 2.03, "material": True,
    "parameters": {"tz_noise_factor": {"value": 2.03, "std": 0.01, "unit": "1"}},
    "message": said("symptom-noisier", channel="tz", times=2.03, correlation=0.02),
    "advice": said("advice-sensor-noise", channel="tz", times=2.03),
}  # fmt: skip
OTHER_PAYLOAD = {
    "id": "payload_mismatch", "title": said("effect-payload-mismatch-title"), "side": "reference", "times_expected": 4.0, "material": True,
    "parameters": {"m_difference_kg": {"value": -0.04, "std": 0.0001, "unit": "kg"}},
    "message": said(
        "symptom-other-payload", reference=Message.of("symptom-reference"),
        differences=[Message.of("symptom-lighter", mass_share=0.04), Message.of("symptom-inertia-off", inertia_share=0.035)],
    ),
    "advice": said("advice-payload-mismatch"),
}  # fmt: skip
FRICTION = Message.of("symptom-friction", coulomb_nm=2.03, coulomb_std_nm=0.01, viscous_nms_per_rad=4.86, viscous_std_nms_per_rad=0.02)
RUBBING = {
    "id": "joint_friction", "title": said("effect-joint-friction-title"), "side": "joints", "times_expected": 1.02, "material": False,
    "parameters": {}, "advice": said("advice-joint-friction"),
    "message": said(
        "symptom-friction-as-stated", joint="5", friction=FRICTION,
        stated=Message.of("symptom-stated-friction", coulomb_nm=2.0, viscous_nms_per_rad=5.0),
    ),
}  # fmt: skip
NO_PATH = said("planning-disputed-speed", body="payload", speed_m_s=0.26, limit_m_s=0.25, time_s=1.0, part="home")
ANSWERS: dict[str, dict[str, Any]] = {
    "explained": {"effects": [effect("base_tilt", 0.95, LEVEL)], "payload": PAYLOAD, "minor": [MINOR], "also": [NOISY, RUBBING]},
    "ambiguous": {
        "effects": [effect("time_delay", 0.6, ONE_CLOCK), effect("sensor_lowpass", 0.4, FASTER_FILTER)], "indistinguishable": [TIE],
        "next_experiment": SWINGS | {"motion": MOTION, "planned": False, "refused": NO_PATH, "refused_kind": "plan-disputed"},
        "payload": PAYLOAD,
    },
    "unknown": {"effects": [effect("base_tilt", 0.1, LEVEL)], "unknown_probability": 0.9, "payload": PAYLOAD},
    "no_gap": {"none_probability": 0.99, "payload": PAYLOAD, "also": [OTHER_PAYLOAD, RUBBING]},
    "not_enough": {"lacking": said("gap-too-short", lasts_s=2.1)},
}  # fmt: skip


def diagnosed(service: RealService, verdict: str) -> str:
    """A diagnosis with that answer, as its job leaves it."""
    store = Store(service.store_url)
    found = ANSWERS[verdict] | {"verdict": verdict, "summary": said("gap-unknown"), "consequence": said("gap-payload-in-doubt")}
    order = DiagnosisOrder(recording=service.data / "nowhere", cell="lwr4_bench")
    diagnosis = finished_diagnosis(store, utc_now(), order, **found)
    store.close()
    return diagnosis
