"""`bench.stranger.score`: when an answer is right."""

from __future__ import annotations

import pytest

from bench.stranger.answer import Answer
from bench.stranger.score import KINDS, Planted, count_held, count_right, find_kind, is_right


def planted(*families: str, kind: str = "single") -> Planted:
    return Planted(kind=kind, families=families, variant="", visible_sigma=100.0)


def answer(verdict: str, *names: str, also: dict[str, bool] | None = None) -> Answer:
    """A verdict; names of what explains the gap, the most probable first, several at once joined by plus signs."""
    probabilities = {name: 0.9 / (place + 1) for place, name in enumerate(names)}
    return Answer(
        case="001",
        verdict=verdict,
        summary="",
        gap=(3.0, 1.0),
        none=0.0,
        unknown=0.0,
        effects=tuple((name, probability, 0.99) for name, probability in probabilities.items() if "+" not in name),
        pairs=tuple((tuple(name.split("+")), probability, 0.99) for name, probability in probabilities.items() if "+" in name),
        also=tuple((also or {}).items()),
        minor=(),
        tied=(),
        cpu=1.0,
    )


def test_a_single_cause_is_right_where_it_is_the_most_probable() -> None:
    gain = planted("sensor_gain")
    assert is_right(gain, answer("explained", "sensor_gain"))
    assert is_right(gain, answer("ambiguous", "sensor_gain", "sensor_nonlinearity"))
    assert not is_right(gain, answer("ambiguous", "sensor_nonlinearity", "sensor_gain"))
    assert not is_right(gain, answer("explained", "base_tilt+sensor_gain"))
    assert not is_right(gain, answer("unknown", "sensor_gain"))


def test_a_pair_is_right_where_both_are_named_in_any_order() -> None:
    pair = planted("time_delay", "base_tilt", kind="double")
    assert is_right(pair, answer("explained", "time_delay+base_tilt"))
    assert is_right(pair, answer("explained", "base_tilt+time_delay", "time_delay"))
    assert not is_right(pair, answer("explained", "time_delay", "base_tilt"))


@pytest.mark.parametrize("verdict", ["no_gap", "unknown"])
def test_what_is_read_off_beside_is_right_as_material_while_nothing_else_is_named(verdict: str) -> None:
    noise = planted("sensor_noise")
    assert is_right(noise, answer(verdict, also={"sensor_noise": True}))
    assert not is_right(noise, answer(verdict, also={"sensor_noise": False}))
    assert not is_right(noise, answer(verdict))
    assert not is_right(noise, answer("explained", "sensor_creep", also={"sensor_noise": True}))


def test_friction_may_be_left_out_but_nothing_else_be_named() -> None:
    friction = planted("joint_friction")
    assert is_right(friction, answer("no_gap", also={"joint_friction": False}))
    assert is_right(friction, answer("no_gap"))
    assert not is_right(friction, answer("explained", "time_delay", also={"joint_friction": False}))


def test_nothing_is_right_without_a_gap_and_without_anything_beside() -> None:
    nothing = planted(kind="none")
    assert is_right(nothing, answer("no_gap", also={"joint_backlash": False}))
    assert not is_right(nothing, answer("no_gap", also={"joint_backlash": True}))
    assert not is_right(nothing, answer("explained", "sensor_drift"))


def test_what_has_no_name_is_right_as_unknown_alone() -> None:
    nameless = planted(kind="unknown")
    assert is_right(nameless, answer("unknown"))
    assert not is_right(nameless, answer("explained", "cable_drag"))
    assert not is_right(nameless, answer("no_gap"))


def test_answers_are_counted_by_kind() -> None:
    truths = {
        "001": planted("sensor_gain"),
        "002": planted("sensor_gain"),
        "003": planted("payload_mismatch"),
        "004": planted("time_delay", "base_tilt", kind="double"),
        "005": planted(kind="none"),
    }
    assert {find_kind(truth) for truth in truths.values()} == set(KINDS) - {"unknown"}
    answers = {case: answer("explained", "sensor_gain") for case in truths}
    answers["005"] = answer("no_gap")
    assert list(count_right(truths, answers).values()) == [(2, 2), (0, 1), (0, 0), (0, 1), (1, 1)]


def test_the_payloads_intervals_count_where_the_reference_is_what_it_is() -> None:
    truths = {"001": planted("sensor_gain"), "002": planted("payload_shift"), "003": planted(kind="unknown"), "004": planted(kind="none")}
    off = {"001": (0.5, -1.9, 2.0), "002": (9.0,), "003": (9.0,), "004": ()}
    answers = {case: answer("unknown").model_copy(update={"payload_off": each}) for case, each in off.items()}
    assert count_held(truths, answers) == (2, 3)
