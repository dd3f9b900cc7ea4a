"""A diagnosis of each verdict, made up, for screens that show one."""

from __future__ import annotations

from typing import Any

from server.jobs.kinds import DiagnosisOrder
from server.service import utc_now
from server.store.store import Store
from tests.server.finished_diagnosis import SWINGS, explanation, finished_diagnosis
from tests.server.real_service import RealService

ENGLISH = "The engine says this in English."
PAYLOAD = {
    "before": {"phi": [2.8, 0.01, 0.02, 0.3, *[0.01] * 6], "std": [0.001] * 10},
    "after": {"phi": [2.7, 0.01, 0.02, 0.28, *[0.008] * 6], "std": [0.001] * 10},
}
TIE = {"ids": ["time_delay", "sensor_lowpass"], "distance_sigma": 2.0, "why": "both come late", "splits": SWINGS["motion"]}
MINOR = {"id": "sensor_noise", "parameters": {}, "sentence": "detected, but too small to matter"}
NOISY = {
    "id": "sensor_noise", "title": "noise of the sensor above what is stated", "side": "reading", "times_expected": 2.03, "material": True,
    "parameters": {"tz_noise_factor": {"value": 2.03, "std": 0.01, "unit": "1"}}, "remark": "noisier",
    "values": {"channel": "tz", "times": 2.03, "correlation": 0.02}, "sentence": "The noise of tz is 2.03 times the stated one.",
    "advice": "Check the sensor's supply.",
}  # fmt: skip
OTHER_PAYLOAD = {
    "id": "payload_mismatch", "title": "a payload that is not the reference", "side": "reference", "times_expected": 4.0, "material": True,
    "parameters": {"m_difference_kg": {"value": -0.04, "std": 0.0001, "unit": "kg"}}, "remark": "other_payload",
    "values": {"mass_share": -0.04, "inertia_share": 0.035}, "sentence": "The payload is not the reference: 4.0 % lighter.",
    "advice": "Check that the right payload is mounted.",
}  # fmt: skip
RUBBING = {
    "id": "joint_friction", "title": "friction in the joints", "side": "joints", "times_expected": 1.02, "material": False,
    "parameters": {}, "remark": "friction_as_stated", "sentence": "Friction in the joints is as the cell states it.", "advice": "Warm up.",
    "values": {"joint": "5", "coulomb_nm": 2.03, "viscous_nms": 4.86, "stated_coulomb_nm": 2.0, "stated_viscous_nms": 5.0},
}  # fmt: skip
NO_PATH = "the robot stands with 'link3' 0.0100 m from 'bench' (limit 0.030 m). Clear the cell."
ANSWERS: dict[str, dict[str, Any]] = {
    "explained": {"effects": [explanation("base_tilt", 0.95)], "payload": PAYLOAD, "minor": [MINOR], "also": [NOISY, RUBBING]},
    "ambiguous": {
        "effects": [explanation("time_delay", 0.6), explanation("sensor_lowpass", 0.4)], "indistinguishable": [TIE],
        "next_experiment": SWINGS | {"planned": False, "refused": NO_PATH, "refused_kind": "no-path"}, "payload": PAYLOAD,
    },
    "unknown": {"effects": [explanation("base_tilt", 0.1)], "unknown_probability": 0.9, "payload": PAYLOAD},
    "no_gap": {"none_probability": 0.99, "payload": PAYLOAD, "also": [OTHER_PAYLOAD, RUBBING]},
    "not_enough": {"lacking": {"id": "too_short", "sentence": "too short", "values": {"lasts_s": 2.1}}},
}  # fmt: skip


def diagnosed(service: RealService, verdict: str) -> str:
    """A diagnosis with that answer, as its job leaves it."""
    store = Store(service.store_url)
    found = ANSWERS[verdict] | {"verdict": verdict, "summary": ENGLISH, "consequence": ENGLISH}
    order = DiagnosisOrder(recording=service.data / "nowhere", cell="lwr4_bench")
    diagnosis = finished_diagnosis(store, utc_now(), order, **found)
    store.close()
    return diagnosis
