"""`core.cli.tables`: what a diagnosis and a plan say on a terminal."""

from __future__ import annotations

from core.cli.tables import diagnosis_lines, torque_lines
from core.gap.answer import Also
from core.gap.answering import not_enough
from core.planning.summary import LargestTorque, PlanTorques
from core.words.message import Message


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


def test_a_plans_torques_are_told_with_what_could_not_be_judged() -> None:
    most = LargestTorque(joint="elbow", torque_n_m=30.0, holding_n_m=28.0, limit_n_m=150.0, ratio=0.2, part="home", time_s=1.5)
    told = PlanTorques(
        load=Message.of("planning-load-guessed"),
        mass_kg=1.0,
        largest=most,
        not_judged=[Message.of("planning-joint-without-effort", joint="wrist")],
    )
    first, second = torque_lines(told)
    carried = "1.000 kg (a guessed mass, spread evenly over the payload box)"
    assert first == f"Joint torques with {carried}: at most 30.0 N m of 150.0 N m (20 %), 'elbow' in 'home' after 1.500 s."
    assert second == '  not judged: "wrist": the URDF states no effort'
    assert torque_lines(told.model_copy(update={"largest": None}))[0] == f"Joint torques with {carried}: not judged."
