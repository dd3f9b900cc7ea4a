"""Who, what, when, where, and made of what: names and values in the order in which the page has them. What nobody has stated says so."""

from __future__ import annotations

from core.certificate.certificate import Certificate, CertifiedSensor
from core.payload.calibration import ASSUMED_CROSSTALK_STD, ASSUMED_GAIN_STD, SensorCalibration
from core.report.record import format_time, name_person
from core.words.wording import Wording

Facts = list[tuple[str, str]]


def list_answerable(certificate: Certificate, words: Wording) -> Facts:
    """What it is about, when, and who let it happen."""
    order = certificate.order
    found = {
        "certificate-payload": certificate.payload,
        "record-date": None if certificate.ended_at is None else format_time(certificate.ended_at),
        "record-run": certificate.run,
        "record-order": order.order_id,
        "record-work-order": order.work_order,
        "record-serial-number": order.serial_number,
        "record-operator": None if certificate.released_by is None else name_person(certificate.released_by),
        "record-cell": certificate.cell,
    }
    return _name_all(found, words)


def list_origin(certificate: Certificate, words: Wording) -> Facts:
    """What measured it, and what it was made with and of."""
    sensor = certificate.recording.sensor
    found = {
        "certificate-sensor": _describe_sensor(sensor, words),
        "certificate-calibration": _describe_calibration(sensor.calibration, words),
        "record-software": words.say("certificate-version", version=certificate.software),
        "record-plan": certificate.plan_sha256,
        "certificate-recording": certificate.recording.sha256,
    }
    return _name_all(found, words)


def _name_all(found: dict[str, str | None], words: Wording) -> Facts:
    return [(words.say(code), value or words.say("certificate-not-stated")) for code, value in found.items()]


def _describe_sensor(sensor: CertifiedSensor, words: Wording) -> str:
    unknown = words.say("certificate-not-stated")
    full = unknown
    if sensor.range is not None:
        units = ((sensor.range[:3], "N"), (sensor.range[3:], "N m"))
        full = ", ".join(f"{words.mark(' / '.join(f'{value:g}' for value in values))} {unit}" for values, unit in units)
    return words.say("certificate-sensor-in-frame", name=sensor.name or unknown, frame=sensor.frame or unknown, range=full)


def _describe_calibration(calibration: SensorCalibration, words: Wording) -> str:
    return words.say(
        "certificate-calibration-stated",
        source=calibration.source or words.say("certificate-not-stated"),
        gain=_format_share(calibration.gain_std, ASSUMED_GAIN_STD, words),
        crosstalk=_format_share(calibration.crosstalk_std, ASSUMED_CROSSTALK_STD, words),
    )


def _format_share(stated: tuple[float, ...] | None, assumed: float, words: Wording) -> str:
    """Six standard uncertainties in percent, from the smallest to the largest."""
    if stated is None:
        return words.say("certificate-calibration-assumed", size=words.mark(f"{100.0 * assumed:.2g} %"))
    least, most = min(stated), max(stated)
    return words.mark(f"{100.0 * most:.2g} %" if least == most else f"{100.0 * least:.2g}–{100.0 * most:.2g} %")
