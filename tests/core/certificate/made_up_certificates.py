"""Certificates of runs that nobody has made, with a name for everything."""

from __future__ import annotations

from datetime import UTC, datetime

from core.certificate.certificate import Certificate, CertifiedSensor, RecordingFacts
from core.certificate.conformity import Conformity
from core.certificate.values import NAMES, UNITS, CertifiedValue, Contribution
from core.payload.calibration import SensorCalibration
from core.recording.order_reference import OrderReference
from core.words.message import Message

VALUES = (2.7834, 0.00001, -0.016823, 0.036471, 0.002441, -0.0000012, 0.0000031, 0.002922, 0.0000092, 0.002549)
STD = (0.0195, 0.000141, 0.000209, 0.000383, 0.000285, 0.000171, 0.000153, 0.000362, 0.000152, 0.000151)
PLAN, RECORDING = "9f86d081" * 8, "5f1dc0de" * 8


def contributions() -> list[Contribution]:
    shares = {"sensor_gain": 0.74, "sensor_crosstalk": 0.21, "gravity": 0.05}
    titles = {name: Message.of(f"estimation-source-{'gravity' if name == 'gravity' else name.replace('_', '-')}") for name in shares}
    return [Contribution(source=name, title=titles[name], share=share) for name, share in shares.items()]


def values(undetermined: frozenset[str] = frozenset(), reason: Message | None = None) -> list[CertifiedValue]:
    found = []
    for name, unit, value, std in zip(NAMES, UNITS, VALUES, STD, strict=True):
        known = name not in undetermined
        each = CertifiedValue(
            name=name, unit=unit, value=value if known else None, standard_uncertainty=std if known else None,
            expanded_uncertainty=1.96 * std if known else None, repeatability=std / 300 if known else None,
            contributions=contributions() if known else [], reason=None if known else reason,
        )  # fmt: skip
        found.append(each)
    return found


def certificate(**changes: object) -> Certificate:
    stated = {
        "run": "019ab1c2d3e44f1c2a9be7", "cell": "lwr4_bench", "payload": "steel_block",
        "order": OrderReference(order_id="JO-2026-004711", work_order="WO-88120", serial_number="SN-000482"),
        "ended_at": datetime(2026, 3, 1, 8, 0, 24, tzinfo=UTC), "released_by": "account:anna", "accepted_by": "account:berta",
        "accepted_at": datetime(2026, 3, 1, 8, 3, tzinfo=UTC), "software": "0.1.0+3f9c2ab17d", "plan_sha256": PLAN,
        "recording": RecordingFacts(
            sha256=RECORDING,
            sensor=CertifiedSensor(
                name="ATI Mini45", frame="ft_sensor", range=[145.0, 145.0, 290.0, 5.0, 5.0, 5.0],
                calibration=SensorCalibration(gain_std=(0.005, 0.005, 0.004, 0.006, 0.006, 0.005), source="Schein 4711 of 2026-03-02"),
            ),
        ),
        "verdict": Message.of("text", text="found"), "values": values(), "phi": [1.0] * 10, "covariance": [[0.0] * 10] * 10,
        "workpiece": None, "twin": [], "assumptions": [Message.of("estimation-assumed-crosstalk")], "warnings": [],
        "conformity": Conformity(
            conforms=True, statement=Message.of("text", text="Below a tenth of what it takes"), margin=8.25, used=0.12,
            rule=Message.of("certificate-rule", probability=0.95, risk=0.05, draws=4096, motion_s=94.0),
        ),
    }  # fmt: skip
    return Certificate.model_validate(stated | changes)
