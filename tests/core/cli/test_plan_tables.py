"""`core.cli.plan_tables`: what a plan says on a terminal."""

from __future__ import annotations

from core.cli.plan_tables import torque_lines
from core.planning.summary import LargestTorque, PlanTorques
from core.words.message import Message


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
