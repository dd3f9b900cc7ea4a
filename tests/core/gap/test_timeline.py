"""Which effect came when, told from diagnoses that are made up here."""

from __future__ import annotations

import pytest

from core.errors import BadInput
from core.gap.answer import Diagnosis, Minor, Origin, Tied
from core.gap.timeline import EffectTimeline, trace_effects
from core.words.message import Message
from tests.core.gap.test_instruction import diagnosis, found, seen, several

DELAY, TILT = "time_delay", "base_tilt"
WEEKS = ["week 1", "week 2", "week 3", "week 4"]
NOTHING = diagnosis("no_gap")


def late(delay_s: float = 0.005) -> Diagnosis:
    return diagnosis("explained", effects=[found(DELAY, delay_s=delay_s)])


def tilted() -> Diagnosis:
    return diagnosis("explained", effects=[found(TILT)])


def minor(name: str, **values: float) -> Minor:
    return Minor(id=name, parameters=found(name, **values).parameters, message=Message.of("gap-minor"))


def open_between(*names: str) -> Diagnosis:
    return diagnosis("ambiguous", effects=[found(name, 0.5) for name in names])


def follow(*diagnoses: Diagnosis) -> dict[str, EffectTimeline]:
    return {effect.id: effect for effect in trace_effects(WEEKS[: len(diagnoses)], diagnoses).effects}


def states(effect: EffectTimeline) -> list[str]:
    return [sighting.state for sighting in effect.sightings]


def onsets(effect: EffectTimeline) -> list[tuple[str, int | None, int]]:
    return [(onset.change, onset.after, onset.by) for onset in effect.onsets]


def test_an_effect_came_between_the_last_recording_without_and_the_first_with_it() -> None:
    delay = follow(NOTHING, NOTHING, late(), late(0.006))[DELAY]
    assert states(delay) == ["absent", "absent", "present", "present"]
    assert onsets(delay) == [("came", 1, 2)]
    assert delay.onsets[0].message.text == "Came between week 2 and week 3: a delay of the wrench against the joints."
    assert delay.sightings[3].parameters["delay_s"].value == 0.006


def test_what_is_there_from_the_beginning_came_before_and_may_go() -> None:
    assert onsets(follow(late(), late(), NOTHING)[DELAY]) == [("came", None, 0), ("went", 1, 2)]


@pytest.mark.parametrize("open_one", [diagnosis("unknown"), diagnosis("not_enough"), open_between(DELAY, TILT)])
def test_a_recording_that_leaves_it_open_widens_the_time(open_one: Diagnosis) -> None:
    assert onsets(follow(NOTHING, open_one, late())[DELAY]) == [("came", 0, 2)]


def test_what_only_open_recordings_name_has_no_time() -> None:
    effects = follow(NOTHING, open_between(DELAY, TILT), NOTHING)
    assert {name: onsets(effect) for name, effect in effects.items()} == {DELAY: [], TILT: []}
    assert states(effects[TILT]) == ["absent", "possible", "absent"]


def test_a_tied_effect_is_possible_however_improbable() -> None:
    tied = Tied(ids=(DELAY, TILT), distance_sigma=1.0, why=Message.of("text", text=""), splits=Message.of("text", text=""))
    unsettled = diagnosis("ambiguous", effects=[found(DELAY, 0.9), found(TILT, 0.01)], indistinguishable=[tied])
    assert states(follow(unsettled, NOTHING)[TILT]) == ["possible", "absent"]


def test_both_of_a_pair_are_there_with_their_own_values() -> None:
    parameters = {name: found(name, **{"size": size}).parameters for name, size in ((DELAY, 1.0), (TILT, 2.0))}
    pair = several(DELAY, TILT).model_copy(update={"parameters": parameters})
    both = diagnosis("explained", effects=[found(DELAY, 0.05, size=7.0), found(TILT, 0.01, size=8.0)], pairs=[pair])
    effects = follow(NOTHING, both)
    assert onsets(effects[TILT]) == [("came", 0, 1)]
    assert [effects[name].sightings[1].parameters["size"].value for name in (DELAY, TILT)] == [1.0, 2.0]


@pytest.mark.parametrize("verdict", ["explained", "ambiguous"])
def test_an_effect_that_was_fitted_beside_another_alone_has_its_title(verdict: str) -> None:
    clipped = follow(NOTHING, diagnosis(verdict, pairs=[several("sensor_saturation", TILT)]))["sensor_saturation"]
    assert (clipped.title.text, clipped.title.say("de")) == ("clipping of the sensor", "Begrenzung des Sensors")


def test_what_another_effect_may_hide_has_neither_gone_nor_come() -> None:
    tilt = follow(tilted(), late(), NOTHING, tilted())[TILT]
    assert states(tilt) == ["present", "unclear", "absent", "present"]
    assert onsets(tilt) == [("came", None, 0), ("went", 0, 2), ("came", 2, 3)]
    assert onsets(follow(NOTHING, tilted(), late())[DELAY]) == [("came", 0, 2)]
    assert onsets(follow(late(), late(), tilted())[TILT]) == [("came", None, 2)]


def test_what_an_effect_would_be_in_the_place_of_the_one_that_is_named_is_no_size_of_it() -> None:
    rival = diagnosis("explained", effects=[found(DELAY), found(TILT, 0.01, about_x_rad=0.3)])
    assert follow(tilted(), rival)[TILT].sightings[1].parameters == {}


def test_what_is_found_beside_another_effect_and_does_not_matter_has_gone() -> None:
    slight = late().model_copy(update={"minor": [minor(TILT)]})
    sound = late().model_copy(update={"also": [seen("joint_backlash", "joints", material=False)]})
    assert onsets(follow(tilted(), slight)[TILT]) == [("came", None, 0), ("went", 0, 1)]
    worn = diagnosis("no_gap", also=[seen("joint_backlash", "joints")])
    assert onsets(follow(worn, sound)["joint_backlash"]) == [("came", None, 0), ("went", 0, 1)]


def test_what_does_not_matter_yet_has_not_come_but_is_shown() -> None:
    slight = diagnosis("no_gap", minor=[minor(DELAY, delay_s=0.001)])
    delay = follow(slight, late())[DELAY]
    assert states(delay) == ["minor", "present"]
    assert onsets(delay) == [("came", 0, 1)]
    assert delay.sightings[0].parameters["delay_s"].value == 0.001


def test_what_a_recording_cannot_show_is_not_absent() -> None:
    blind = diagnosis("no_gap", limits=[Message.of("gap-not-shown", effect=DELAY, title=Message.of("gap-minor"), reason="")])
    assert onsets(follow(NOTHING, blind, late())[DELAY]) == [("came", 0, 2)]


def test_what_is_seen_elsewhere_than_in_the_wrench_comes_and_goes_too() -> None:
    worn, new = seen("joint_backlash", "joints"), seen("joint_backlash", "joints", material=False)
    backlash = follow(diagnosis("no_gap", also=[new]), diagnosis("no_gap", also=[worn]))["joint_backlash"]
    assert states(backlash) == ["minor", "present"]
    assert onsets(backlash) == [("came", 0, 1)]


def test_effects_stand_in_the_order_in_which_they_came_and_so_does_the_summary() -> None:
    told = trace_effects(WEEKS, [NOTHING, tilted(), NOTHING, late()])
    assert [effect.id for effect in told.effects] == [TILT, DELAY]
    assert [message.code for message in told.summary] == ["timeline-came", "timeline-went", "timeline-came"]
    assert [recording.verdict for recording in told.recordings] == ["no_gap", "explained", "no_gap", "explained"]
    assert [message.code for message in trace_effects(WEEKS[:2], [NOTHING, NOTHING]).summary] == ["timeline-nothing"]


def origin(**changes: object) -> Origin:
    return Origin.model_validate({"recording": "r", "sha256": "0", "cell": None, "joints": 7, "twin": {}, **changes})


@pytest.mark.parametrize(("changes", "code"), [({"joints": 6}, "timeline-other-robot"), ({"twin": {TILT: "a"}}, "timeline-other-twin")])
def test_what_cannot_be_held_against_each_other_is_refused(changes: dict[str, object], code: str) -> None:
    one, other = (diagnosis("no_gap", origin=each) for each in (origin(), origin(**changes)))
    with pytest.raises(BadInput) as refused:
        trace_effects(WEEKS[:2], [one, other])
    assert refused.value.message.code == code
