"""The certificate as a page that one can sign and file: A4, PDF."""

from __future__ import annotations

from itertools import groupby

from core.certificate.certificate import Certificate, certificate_sha256
from core.certificate.facts import list_answerable, list_origin
from core.certificate.sheet import HEIGHT_MM, MARGIN_MM, Column, Sheet
from core.certificate.values import COVERAGE_FACTOR, CertifiedValue
from core.estimation.result import WorkpiecePart
from core.report.record import format_time, name_person
from core.report.rows import round_to_uncertainty, sentence
from core.words.catalogue import Language
from core.words.wording import Wording

SMALLER = 0.97
"""Letters of a page that came out too long, against those of the attempt before."""
SIGNATURE_MM = 42.0
"""At the foot of the page, for signature and what the page is to be held against."""
FACT = (Column(38.0), Column(136.0))
HASH = (Column(38.0), Column(136.0, face="digits"))
VALUES = (Column(15.0), Column(28.0, "right"), Column(26.0, "right"), Column(26.0, "right"), Column(5.0), Column(13.0), Column(61.0))
HEADINGS = (
    "certificate-symbol", "certificate-value", "certificate-expanded", "certificate-repeatability", "", "certificate-unit",
    "certificate-mostly",
)  # fmt: skip
"""Of `VALUES`; nothing stands over the gap before the unit."""
NAMED_SHARE = 0.1
"""Of a value's variance, from which a contribution is named."""
GREY = 0.35


def render_certificate(certificate: Certificate, language: Language) -> bytes:
    """One page of A4 as PDF; the more there is to say, the smaller the letters. The same certificate gives the same bytes."""
    words, scale = Wording(language), 1.0
    sheet = _write_page(certificate, words, scale)
    while sheet.y_mm > HEIGHT_MM - MARGIN_MM - SIGNATURE_MM:
        scale *= SMALLER
        sheet = _write_page(certificate, words, scale)
    _write_foot(sheet, certificate, words)
    subject = f"{certificate.format} SHA-256 {certificate_sha256(certificate)}"
    return sheet.render(title=words.say("certificate-title"), subject=subject)


def _write_page(certificate: Certificate, words: Wording, scale: float) -> Sheet:
    sheet = Sheet(scale)
    sheet.write(words.say("certificate-title"), 15.0, face="bold")
    sheet.skip(2.0)
    for name, value in list_answerable(certificate, words):
        sheet.row(FACT, (name, value))
    for name, value in list_origin(certificate, words):
        sheet.row(HASH if len(value) == 64 else FACT, (name, value))
    _write_values(sheet, certificate, words)
    _write_remarks(sheet, certificate, words)
    _write_conformity(sheet, certificate, words)
    return sheet


def _write_heading(sheet: Sheet, text: str) -> None:
    sheet.skip(3.0)
    sheet.rule()
    sheet.skip(1.0)
    sheet.write(text, 9.5, face="bold")
    sheet.skip(0.8)


def _write_values(sheet: Sheet, certificate: Certificate, words: Wording) -> None:
    _write_heading(sheet, words.say("certificate-values"))
    sheet.row(VALUES, [words.say(code) if code else "" for code in HEADINGS], 7.0, grey=GREY)
    for value in certificate.values:
        sheet.row(VALUES, _format_row(value, words))
    sheet.skip(1.0)
    missing = [value for value in certificate.values if value.reason is not None]
    for why, of in groupby(missing, key=lambda value: value.reason):
        names = ", ".join(format_symbol(each.name) for each in of)
        sheet.write(sentence(words.say("certificate-reason", names=names, reason=why or ""), words), 7.0)
    frame = certificate.recording.sensor.frame or words.say("certificate-not-stated")
    sheet.write(words.say("certificate-frame", frame=frame, factor=certificate.coverage_factor), 7.0, grey=GREY)
    if certificate.workpiece is not None:
        sheet.write(_describe_workpiece(certificate.workpiece, words), 7.5)
    if certificate.twin:
        sheet.write(words.say("certificate-twin", effects=[each.title for each in certificate.twin]), 7.0, grey=GREY)


def _format_row(value: CertifiedValue, words: Wording) -> list[str]:
    unit = format_unit(value.unit)
    if value.value is None or value.expanded_uncertainty is None:
        return [format_symbol(value.name), words.say("certificate-not-determined"), "", "", "", unit, ""]
    half = value.expanded_uncertainty
    alone = None if value.repeatability is None else COVERAGE_FACTOR * value.repeatability
    return [
        format_symbol(value.name),
        words.mark(format_value(value.value, half)),
        words.mark(f"± {round_to_uncertainty(half, half)}"),
        words.say("certificate-not-stated") if alone is None else words.mark(f"± {round_to_uncertainty(alone, alone)}"),
        "",
        unit,
        ", ".join(
            words.say("certificate-contribution", source=each.title, share=each.share)
            for each in value.contributions
            if each.share >= NAMED_SHARE
        )
        or words.say("certificate-not-stated"),
    ]


def _describe_workpiece(found: WorkpiecePart, words: Wording) -> str:
    tools = [tool.title for tool in found.tools]
    if found.phi[0] is None:
        return words.say("certificate-workpiece-unknown", tools=tools)
    mass = _list_values([found.phi[0]], [found.std[0]], "kg", words)
    com = _list_values(found.com_m, found.com_std_m, "m", words)
    inertia = _list_values(found.inertia_com_kg_m2, found.inertia_com_std_kg_m2, "kg m2", words)
    return words.say("certificate-workpiece", tools=tools, mass=mass, com=com, inertia=inertia)


def _list_values(values: list[float | None], stds: list[float | None], unit: str, words: Wording) -> str:
    texts = []
    for value, std in zip(values, stds, strict=True):
        half = COVERAGE_FACTOR * (std or 0.0)
        known = value is not None and half > 0.0
        texts.append(
            words.mark(f"{format_value(value or 0.0, half)} ± {round_to_uncertainty(half, half)}")
            if known
            else words.say("certificate-not-determined")
        )
    listed = "; ".join(texts)
    return f"({listed}) {format_unit(unit)}" if len(texts) > 1 else f"{listed} {format_unit(unit)}"


def _write_remarks(sheet: Sheet, certificate: Certificate, words: Wording) -> None:
    _write_heading(sheet, words.say("certificate-remarks"))
    remarks = [*certificate.assumptions, *certificate.warnings]
    if certificate.workpiece is not None:
        remarks += certificate.workpiece.remarks
    for each in remarks:
        sheet.write(f"– {sentence(each, words)}", 7.5)
    if not remarks:
        sheet.write(words.say("certificate-no-remarks"), 7.5)


def _write_conformity(sheet: Sheet, certificate: Certificate, words: Wording) -> None:
    found = certificate.conformity
    code = {True: "certificate-conforms", False: "certificate-not-shown", None: "certificate-not-judged-at-all"}[found.conforms]
    if found.conforms and found.assumed:
        code = "certificate-conforms-to-assumed"
    _write_heading(sheet, words.say("certificate-conformity"))
    sheet.write(words.say(code), 9.0, face="bold")
    margin = "" if found.margin is None else f" {words.say('certificate-margin', margin=found.margin)}"
    sheet.write(f"{sentence(found.statement, words)}{margin}", 7.5)
    if found.assumed:
        sheet.write(words.say("requirement-assumed"), 7.5)
    if found.rule is not None:
        sheet.write(words.quote(found.rule), 7.0, grey=GREY)


def _write_foot(sheet: Sheet, certificate: Certificate, words: Wording) -> None:
    """At the foot whatever stands above, in letters of full size."""
    sheet.scale, sheet.y_mm = 1.0, HEIGHT_MM - MARGIN_MM - SIGNATURE_MM
    _write_heading(sheet, words.say("certificate-acceptance"))
    accepted = words.say("record-not-accepted")
    if certificate.accepted_by is not None:
        accepted = name_person(certificate.accepted_by)
        if certificate.accepted_at is not None:
            accepted = f"{accepted}, {format_time(certificate.accepted_at)}"
    sheet.row(FACT, (words.say("record-accepted"), accepted))
    sheet.skip(11.0)
    half = 0.45 * sheet.width_mm
    sheet.rule(length_mm=half, grey=0.0)
    sheet.rule(x_mm=sheet.width_mm - half, grey=0.0)
    names = words.say("certificate-place"), "", words.say("certificate-signature")
    sheet.row((Column(half), Column(sheet.width_mm - 2.0 * half), Column(half)), names, 7.0, grey=GREY)
    sheet.skip(1.5)
    sheet.write(words.say("certificate-data", format=certificate.format), 6.5, grey=GREY)
    sheet.write(certificate_sha256(certificate), 6.5, face="digits", grey=GREY)
    sheet.write(words.say("certificate-disclaimer"), 6.0, grey=GREY)


def format_value(value: float, half_width: float) -> str:
    """With the digits that its uncertainty leaves, and a sign that is none of a hyphen; zero has no sign."""
    text = round_to_uncertainty(value, half_width)
    return text.lstrip("-") if float(text) == 0.0 else text.replace("-", "−")


def format_symbol(name: str) -> str:
    """Such as c x of c_x, I xy of Ixy: as the report writes them."""
    return name.replace("_", " ")


def format_unit(unit: str) -> str:
    """With its exponent as it is printed."""
    return unit.replace("m2", "m²")
