"""`core.cli.tables`: what a diagnosis says on a terminal."""

from __future__ import annotations

from core.cli.tables import diagnosis_lines, diagnosis_table
from core.gap.answer import Also
from core.gap.answering import not_enough
from core.words.message import Message
from tests.core.gap.test_instruction import diagnosis, found
from tests.core.report.made_up_diagnoses import with_verdict


def say(text: str) -> Message:
    return Message.of("text", text=text)


def seen(name: str, *, material: bool) -> Also:
    return Also(
        id=name, title=say(name), side="reading", parameters={}, times_expected=2.0, material=material,
        message=say(f"There is {name}."), advice=say("Check the cable."),
    )  # fmt: skip


def test_what_stands_beside_the_verdict_is_told_with_what_to_do_where_it_matters() -> None:
    also = [seen("sensor_noise", material=True), seen("sensor_interference", material=False)]
    lines = diagnosis_lines(not_enough(Message.of("gap-too-short", lasts_s=1.0), 0.1).model_copy(update={"also": also}))
    assert "Also, in the sensor's readings: sensor_noise: There is sensor_noise. To do: Check the cable." in lines
    assert "Also, in the sensor's readings: sensor_interference: There is sensor_interference. It does not matter." in lines


def test_the_answers_between_which_it_lies_are_said_where_they_are_several() -> None:
    open_ = with_verdict("ambiguous", likely=["time_delay", "time_delay+base_tilt", "unknown"])
    assert "In nine of ten cases like this it is one of these: time_delay, time_delay + base_tilt, unknown." in diagnosis_lines(open_)
    assert not any("nine of ten" in line for line in diagnosis_lines(with_verdict("explained", likely=["time_delay"])))


def test_effects_are_told_with_their_parameters_in_everyday_units_and_improbable_ones_without() -> None:
    late, level = found("time_delay", 0.9, delay_s=0.02), found("base_tilt", 0.001, about_x_rad=0.01)
    names, *_, told = (list(column.cells) for column in diagnosis_table(diagnosis("explained", effects=[late, level])).columns)
    assert list(zip(names, told, strict=True))[:2] == [("time_delay", "delay 0.0200 ± 0.0010"), ("base_tilt", "")]
