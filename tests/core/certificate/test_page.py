"""The page, read back from the PDF: everything is on it, it is one page, and it is always the same."""

from __future__ import annotations

import io
import re
from datetime import datetime

import pypdf
import pytest

from core.certificate.certificate import Certificate, CertifiedSensor, RecordingFacts, certificate_sha256
from core.certificate.conformity import Conformity
from core.certificate.page import SIGNATURE_MM, format_value, render_certificate
from core.certificate.sheet import HEIGHT_MM, MARGIN_MM, POINT_MM, WIDTH_MM, break_lines, measure_mm
from core.estimation.result import ToolPart, TwinSharePart, WorkpiecePart
from core.recording.order_reference import OrderReference
from core.words.message import Message
from tests.core.certificate.made_up_certificates import PLAN, RECORDING, certificate, values

WHY = Message.of("estimation-standing")


def read(page: bytes) -> pypdf.PdfReader:
    return pypdf.PdfReader(io.BytesIO(page))


def text_of(found: Certificate, language: str = "en") -> str:
    """All that the page says, with single spaces."""
    return re.sub(r"\s+", " ", " ".join(page.extract_text() for page in read(render_certificate(found, language)).pages))


def places_of(page: pypdf.PageObject) -> list[tuple[float, float]]:
    """Where its lines begin, mm from the left and from the lower edge."""
    contents = page.get_contents()
    assert contents is not None
    found = re.findall(r"1 0 -?0 1 ([\d.]+) ([\d.]+) cm", contents.get_data().decode("latin-1"))
    return [(POINT_MM * float(x), POINT_MM * float(y)) for x, y in found]


def test_all_that_a_certificate_has_to_say_is_on_the_page() -> None:
    said = text_of(certificate())
    for fact in (
        "steel_block", "JO-2026-004711", "WO-88120", "SN-000482", "2026-03-01 08:00:24 UTC", "019ab1c2d3e44f1c2a9be7", "lwr4_bench",
        "ATI Mini45", "'ft_sensor'", "145 / 145 / 290 N, 5 / 5 / 5 N m", "Schein 4711 of 2026-03-02", "gain u = 0.4–0.6 %",
        "cross-talk u = 0.5 % (assumed)", "Heft 0.1.0+3f9c2ab17d", PLAN, RECORDING, "2.783 ± 0.038 ± 0.00013 kg", "−0.01682 ± 0.00041",
        "sensor gain 74 %, cross-talk 21 %", "U = 1.96 u", "95 %", "The sensor's cross-talk is not stated", "Conforms.",
        "Below a tenth of what it takes", "JCGM 106:2012", "at least 95 %", "a factor of 8.2", "anna", "berta, 2026-03-01 08:03:00 UTC",
        "Name, signature", "certificate/1", "safety_rated: false",
    ):  # fmt: skip
        assert fact in said, fact


def test_the_page_speaks_german_with_its_letters_and_its_decimal_mark() -> None:
    said = text_of(certificate(payload="Prüfkörper Łódź"), "de")
    for fact in ("Konformitätsaussage", "Überdeckungswahrscheinlichkeit", "2,783 ± 0,038", "Prüfkörper Łódź", "0,4–0,6 %", "Konform."):
        assert fact in said, fact


@pytest.mark.parametrize("language", ["en", "de"])
def test_what_nobody_has_stated_says_so(language: str) -> None:
    bare = certificate(
        run=None, cell=None, payload=None, order=OrderReference(), ended_at=None, released_by=None, accepted_by=None, accepted_at=None,
        plan_sha256=None, recording=RecordingFacts(),
    )  # fmt: skip
    said = text_of(bare, language)
    unknown, unaccepted = {"en": ("not stated", "not accepted"), "de": ("nicht angegeben", "nicht angenommen")}[language]
    assert said.count(unknown) >= 14
    assert unaccepted in said


def test_what_is_not_determined_is_in_its_row_with_the_reason() -> None:
    inertia = frozenset({"Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"})
    none = Conformity(conforms=None, statement=Message.of("requirement-not-determined", names=sorted(inertia)))
    said = text_of(certificate(values=values(inertia, WHY), conformity=none))
    assert len(re.findall(r"not determined kg m²", said)) == 6
    assert "Ixx, Ixy, Ixz, Iyy, Iyz, Izz not determined: " + WHY.text in said
    assert "No statement." in said and "cannot be judged" in said


@pytest.mark.parametrize("known", [True, False])
def test_the_workpiece_alone_stands_beside_the_whole_with_what_has_to_be_known_of_it(known: bool) -> None:
    numbers = [1.8624, *[0.001] * 9] if known else [None] * 10
    std = [0.0061, *[0.0005] * 9] if known else [None] * 10
    workpiece = WorkpiecePart(
        phi=numbers, std=std, covariance=[], com_m=[0.01234, -0.0252, None], com_std_m=[0.0003, 0.0003, None],
        inertia_com_kg_m2=[None] * 6, inertia_com_std_kg_m2=[None] * 6, consistent=True, reference=None,
        tools=[ToolPart(name="gripper", title="Gripper GR-2", phi=[0.9, *[0.0] * 9], std=[None] * 10)],
        remarks=[Message.of("workpiece-tool-without-std", tool="gripper", keys=["mass_std_kg"])],
    )  # fmt: skip
    said = text_of(certificate(workpiece=workpiece, twin=[share()]))
    if known:
        assert "Without Gripper GR-2: m = 1.862 ± 0.012 kg; c = (0.01234 ± 0.00059; −0.02520 ± 0.00059; not determined) m;" in said
    else:
        assert "Without Gripper GR-2: not determined." in said
    assert "mass_std_kg" in said
    assert "as the cell's twin has them: delayed wrench." in said


def share() -> TwinSharePart:
    return TwinSharePart(effect="time_delay", title=Message.of("text", text="delayed wrench"), recording="sha256:5f1d", change=[])


@pytest.mark.parametrize(
    ("conforms", "assumed", "words"),
    [
        (True, True, "Conforms to an assumed threshold."),
        (False, False, "Conformity is not shown."),
        (False, True, "Conformity is not shown."),
    ],
)
def test_the_statement_says_no_more_than_was_shown(conforms: bool, assumed: bool, words: str) -> None:
    found = certificate().conformity.model_copy(update={"conforms": conforms, "assumed": assumed})
    said = text_of(certificate(conformity=found))
    assert words in said and "Conforms." not in said


@pytest.mark.parametrize("count", [0, 12])
def test_it_is_one_page_however_long_the_names_and_however_many_the_remarks(count: int) -> None:
    names = ("payload", "cell", "released_by", "accepted_by")
    inertia = frozenset({"Ixx", "Izz"})
    long = certificate(
        **{name: f"{name} " + "Wiederholgenauigkeitsbestimmung" * 3 for name in names},
        order=OrderReference(order_id="O" * 100, work_order="W" * 100, serial_number="S" * 100),
        values=values(inertia, WHY),
        warnings=[Message.of("text", text=f"warning {k} " + "of many words " * 20) for k in range(count)],
        recording=RecordingFacts(sha256=RECORDING, sensor=CertifiedSensor(name="N" * 200, frame="f" * 64)),
    )
    pages = read(render_certificate(long, "de")).pages
    assert len(pages) == 1
    said = pages[0].extract_text()
    for k in range(count):
        assert f"Warning {k} " in said
    assert "S" * 20 in said and PLAN in said
    places = places_of(pages[0])
    for x_mm, y_mm in places:
        assert MARGIN_MM - 0.01 <= x_mm <= WIDTH_MM - MARGIN_MM
        assert 10.0 <= y_mm <= HEIGHT_MM - MARGIN_MM
    foot = {y_mm for _, y_mm in places if y_mm < MARGIN_MM + SIGNATURE_MM}
    assert len(foot) <= 9  # nothing of the body reaches into the room for the signature


def test_the_same_certificate_gives_the_same_bytes_which_name_its_data() -> None:
    found = certificate()
    page = render_certificate(found, "en")
    assert page == render_certificate(certificate(), "en")
    assert certificate_sha256(found) in text_of(found)
    information = read(page).metadata
    assert information is not None
    assert certificate_sha256(found) in (information.subject or "")
    assert information.creation_date is None


def test_the_data_come_back_as_they_were() -> None:
    found = certificate()
    assert Certificate.model_validate_json(found.model_dump_json()) == found
    assert certificate(accepted_at=datetime.fromisoformat("2026-03-01T08:03:01+00:00")) != found


def test_letters_that_the_font_does_not_have_are_spelt_out() -> None:
    assert "\\u6c34" in text_of(certificate(payload="水"))
    assert "$x_1$" in text_of(certificate(payload="$x_1$"))


@pytest.mark.parametrize("text", ["a few words that need several lines to be said", "a" * 90, "", "word " + "b" * 70])
def test_lines_are_no_wider_than_they_may_be_and_lose_nothing(text: str) -> None:
    lines = break_lines(text, 8.0, "plain", 20.0)
    assert all(measure_mm(line, 8.0, "plain") <= 20.0 for line in lines)
    assert "".join(lines).replace(" ", "") == text.replace(" ", "")


def test_what_a_no_break_space_joins_stands_on_one_line() -> None:
    assert break_lines("about U\u00a0=\u00a02\u00a0u", 8.0, "plain", 18.0) == ["about", "U\u00a0=\u00a02\u00a0u"]


@pytest.mark.parametrize(("value", "half", "text"), [(-0.0000004, 0.00012, "0.00000"), (-0.0168, 0.0004, "−0.01680"), (2.0, 0.1, "2.00")])
def test_a_value_has_the_digits_that_its_uncertainty_leaves_and_zero_no_sign(value: float, half: float, text: str) -> None:
    assert format_value(value, half) == text
