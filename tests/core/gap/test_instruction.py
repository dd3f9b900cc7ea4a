"""What the person at the robot is told, made of diagnoses that are made up here."""

from __future__ import annotations

import pytest

from core.effects.library import library, symptoms
from core.gap.answer import Also, Diagnosis, Experiment, Explanation, Origin, Pair, Value
from core.gap.instruction import explains
from core.words.catalogue import LANGUAGES
from core.words.message import Message
from tests.core.report.made_up_diagnoses import explained

EVERY = [*(effect.id for effect in library()), *(symptom.id for symptom in symptoms())]
TIMES = {"at_s": 31.4, "step_time_s": 31.4}
MOTION = Experiment(id="x", motion=Message.of("gap-no-cell"), stops=[], splits=[], sigma_before=2.0, sigma_after=9.0, seconds=9.0)


def found(name: str, probability: float = 0.95, **values: float) -> Explanation:
    """An effect of the library with some parameters."""
    base = explained().effects[0]
    parameters = {key: Value(value=value, std=0.001, unit="1") for key, value in values.items()}
    title = next((effect.title for effect in library() if effect.id == name), base.title)
    return base.model_copy(update={"id": name, "title": title, "probability": probability, "parameters": parameters})


def seen(name: str, side: str, *, material: bool = True) -> Also:
    """What is seen elsewhere than in the wrench."""
    text = Message.of("text", text=name)
    words = {"title": text, "message": text, "advice": text}
    return Also.model_validate({"id": name, "side": side, "parameters": {}, "times_expected": 2.0, "material": material, **words})


def several(*names: str, probability: float = 0.95) -> Pair:
    """Effects that explain the gap together."""
    return Pair(ids=names, probability=probability, gap_after=1.0, closure=0.99)


def diagnosis(verdict: str, **changes: object) -> Diagnosis:
    """Read from JSON again, as the service has it."""
    made = explained().model_copy(update={"verdict": verdict, "effects": [], "pairs": [], "indistinguishable": [], "also": [], **changes})
    return Diagnosis.model_validate_json(made.model_dump_json())


@pytest.mark.parametrize("name", EVERY)
def test_every_effect_has_a_sentence_and_a_next_step_of_its_own_in_every_language(name: str) -> None:
    assert explains(name)
    told = diagnosis("explained", effects=[found(name, **TIMES)]).instruction
    for language in LANGUAGES:
        sentence, following = told.sentence.say(language), told.next.say(language)
        assert sentence[0].isupper() or sentence[0].isdigit()
        assert not sentence.endswith(".")
        assert following.endswith(".")
        assert "{" not in sentence + following
        assert "-" not in told.sentence.code or told.sentence.code not in sentence


def test_nothing_material_is_nothing_to_do() -> None:
    told = diagnosis("no_gap", also=[seen("sensor_noise", "reading", material=False)]).instruction
    assert (told.level, told.sentence.text, told.further, told.at_s) == ("nothing", "Nothing to do", [], None)


@pytest.mark.parametrize(
    ("name", "values", "sentence"),
    [
        ("external_contact", {"at_s": 31.4}, "Somebody or something touched the robot at 0:31"),
        ("payload_shift", {"at_s": 71.9}, "The payload slipped at 1:11"),
        ("payload_mass_change", {"at_s": 5.0, "mass_kg": -0.2}, "The payload lost something at 0:05"),
        ("payload_mass_change", {"at_s": 5.0, "mass_kg": 0.2}, "The payload became heavier at 0:05"),
        ("sensor_offset_step", {"step_time_s": 600.0}, "The sensor jumped at 10:00"),
    ],
)
def test_what_happened_once_has_its_time_in_the_sentence_and_as_a_number(name: str, values: dict[str, float], sentence: str) -> None:
    told = diagnosis("explained", effects=[found(name, **values)]).instruction
    assert told.sentence.text == sentence
    assert told.at_s == pytest.approx(values.get("at_s", values.get("step_time_s")))


def test_a_clock_that_does_not_begin_at_zero_is_told_from_the_beginning_of_the_recording() -> None:
    origin = Origin(recording="log", sha256="0" * 64, cell=None, joints=7, begins_s=1.7e9, twin={})
    told = diagnosis("explained", effects=[found("external_contact", at_s=1.7e9 + 31.0)], origin=origin).instruction
    assert (told.at_s, told.sentence.text) == (31.0, "Somebody or something touched the robot at 0:31")


def test_a_tilt_is_told_with_the_angle_of_both_its_parts() -> None:
    told = diagnosis("explained", effects=[found("base_tilt", about_x_rad=0.03, about_y_rad=-0.04)]).instruction
    assert told.sentence.text == "Level the base"
    assert "2.86° off level" in told.next.text


def test_what_matters_besides_comes_after_the_verdict_and_leads_where_the_wrench_says_nothing() -> None:
    beside = [seen("sensor_noise", "reading"), seen("payload_mismatch", "reference")]
    told = diagnosis("explained", effects=[found("base_tilt", about_x_rad=0.03)], also=beside).instruction
    assert [told.sentence.text, *(each.text for each in told.further)] == [
        "Level the base", "Check the payload: it is not the one that was expected", "Check the cable of the sensor",
    ]  # fmt: skip
    alone = diagnosis("no_gap", also=beside).instruction
    assert (alone.level, alone.sentence.text) == ("act", "Check the payload: it is not the one that was expected")


@pytest.mark.parametrize(("planned", "level", "sentence"), [(True, "measure", "Measure once more"), (False, "ask", "Ask an engineer")])
def test_what_is_not_settled_asks_for_the_motion_only_where_it_is_planned(planned: bool, level: str, sentence: str) -> None:
    effects = [found("base_tilt", 0.5), found("joint_offset", 0.4), found("time_delay", 0.01)]
    told = diagnosis("ambiguous", effects=effects, next_experiment=MOTION.model_copy(update={"planned": planned})).instruction
    assert told.level == level
    assert told.sentence.text.startswith(sentence)
    assert "a base that is not level or joint encoders whose zero is off" in told.next.text
    assert "delay" not in told.next.text


@pytest.mark.parametrize("alone", [[], ["time_delay"]])
def test_an_effect_that_was_fitted_beside_others_alone_has_its_title_where_nothing_is_settled(alone: list[str]) -> None:
    pairs = [several("time_delay", "sensor_saturation", probability=0.5), several("time_delay", "base_tilt", probability=0.4)]
    told = diagnosis("ambiguous", effects=[found(name, 0.01) for name in alone], pairs=pairs).instruction
    late = "a delay of the wrench against the joints"
    assert f"{late} and clipping of the sensor or {late} and a base that is not level" in told.next.text
    assert "Begrenzung des Sensors" in told.next.say("de")


def test_an_effect_without_words_has_the_title_that_its_diagnosis_gives_it_or_its_name() -> None:
    title = Message.of("text", text="a made-up effect")
    alone = diagnosis("explained", effects=[found("made_up").model_copy(update={"title": title})]).instruction
    beside = diagnosis("explained", pairs=[several("made_up", "base_tilt")]).instruction
    assert [told.sentence.text for told in (alone, beside)] == ["Ask an engineer: a made-up effect", "Ask an engineer: made up"]


def test_what_shakes_the_robot_is_stopped_before_an_engineer_looks_for_an_unknown_cause() -> None:
    told = diagnosis("unknown", also=[seen("structure_vibration", "reading")]).instruction
    assert (told.level, told.sentence.text, told.at_s) == ("act", "Stop what shakes the robot", None)
    assert [each.code for each in told.further] == ["instruction-unknown"]
    noisy = diagnosis("unknown", also=[seen("sensor_noise", "reading")]).instruction
    assert noisy.sentence.code == "instruction-unknown"


def test_an_unknown_cause_is_an_engineers_and_says_when_most_of_it_was() -> None:
    where = explained().where
    assert where is not None
    told = diagnosis("unknown", where=where.model_copy(update={"worst_s": (31.0, 37.2)})).instruction
    assert told.level == "ask"
    assert "between 0:31 and 0:37" in told.next.text
    assert told.at_s == 31.0
    assert "between" not in diagnosis("unknown", where=where.model_copy(update={"worst_s": None})).instruction.next.text


def test_a_slip_in_the_set_up_is_corrected_and_not_recorded_again() -> None:
    told = diagnosis("not_enough", lacking=Message.of("setup-wrench-zero")).instruction
    assert (told.level, told.sentence.code) == ("ask", "instruction-correct-recording")
    assert "the sensor was not connected" in told.next.text and "nicht angeschlossen" in told.next.say("de")


def test_a_recording_that_is_not_enough_is_to_be_made_again_with_the_reason() -> None:
    told = diagnosis("not_enough", lacking=Message.of("gap-no-motion")).instruction
    assert (told.level, told.sentence.text) == ("measure", "Record again")
    assert Message.of("gap-no-motion").text in told.next.text


def test_a_difference_inside_either_interval_is_below_one() -> None:
    payload = explained().payload
    assert payload is not None
    before = payload.before.model_copy(update={"phi": [3.0, *[0.0] * 9], "std": [0.5, *[0.0] * 9]})
    after = payload.after.model_copy(update={"phi": [3.09, *[0.0] * 9], "std": [0.005, *[0.0] * 9]})
    times = payload.model_copy(update={"before": before, "after": after}).change_over_interval
    assert times[0] == pytest.approx(0.09 / (1.96 * 0.500025), rel=1e-4)  # 9.2 of the interval after alone
    assert times[1] is None
