"""`core.gap.answer`: what a diagnosis says, written and read again, of this version and of earlier ones."""

from __future__ import annotations

from core.gap.answer import SIDES, Also, Diagnosis, Experiment
from core.gap.answering import not_enough
from core.words.message import Message

SHORT = Message.of("gap-too-short", lasts_s=1.25)


def test_a_diagnosis_comes_back_from_json_as_it_was_and_says_itself_in_both_languages() -> None:
    told = not_enough(SHORT, 0.1)
    again = Diagnosis.model_validate_json(told.model_dump_json())
    assert again == told
    assert again.lacking == SHORT
    assert str(again.summary) == "Nothing can be said about the gap: 1.2 s are too short to say anything."
    assert again.summary.say("de") == "Über die Abweichung lässt sich nichts sagen: 1,2 s sind zu kurz, um etwas zu sagen."


def test_sentences_of_an_earlier_version_are_said_as_they_are() -> None:
    lacking = {"id": "too_short", "sentence": "1.2 s are too short", "values": {"lasts_s": 1.2}}
    ratio = {"joint_3_gear_ratio": {"value": 100.0, "std": 0.1, "unit": "1"}}
    seen = {"id": "sensor_noise", "title": "noise", "side": "reading", "parameters": ratio, "times_expected": None, "material": True}
    also = {**seen, "sentence": "It is noisy.", "advice": "Look.", "remark": "noisier", "values": {"times": 2.0}}
    earlier = not_enough(SHORT, 0.1).model_dump(mode="json")
    read = Diagnosis.model_validate(
        earlier | {"summary": "Nothing.", "consequence": "", "limits": ["a: b"], "lacking": lacking, "also": [also]}
    )
    assert [str(each) for each in (read.summary, read.lacking, read.limits[0], read.also[0].message)] == [
        "Nothing.", "1.2 s are too short", "a: b", "It is noisy.",
    ]  # fmt: skip
    assert read.consequence is None
    title = read.also[0].parameters["joint_3_gear_ratio"].title
    assert title is not None
    assert (title.say("en"), title.say("de")) == ("joint 3 gear ratio", "Gelenk 3 Übersetzung")


def test_an_experiment_says_why_it_is_not_planned_where_it_is_not() -> None:
    asked = Experiment(
        id="revisit", motion=Message.of("text", text="once more"), stops=[], splits=[], sigma_before=1.0, sigma_after=4.0, seconds=3.0
    )
    assert str(asked.refused) == "no cell was given to plan it in"
    assert Experiment.model_validate(asked.model_dump(mode="json") | {"refused": ""}).refused is None


def test_where_something_is_seen_has_words_in_both_languages() -> None:
    assert [SIDES[side].say("de") for side in ("joints", "reading", "reference")] == [
        "an den Gelenken", "in den Messwerten des Sensors", "gegen die Referenzlast",
    ]  # fmt: skip
    assert Also.model_fields["message"].is_required()
