"""Diagnoses of one cell in the order in which their recordings were made: which effect came when, and which went."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Literal

from pydantic import Field

from core.cell.kinematics import is_same_robot
from core.errors import BadInput
from core.gap.answer import Also, Diagnosis, DiagnosisPart, Explanation, Minor, Value, Values, Verdict
from core.gap.instruction import find_effect_title, find_open, rank_explanations
from core.words.message import Message

State = Literal["present", "possible", "minor", "absent", "unclear"]


class Sighting(DiagnosisPart):
    """One effect in one recording."""

    state: State = Field(
        description="`present`: named by the verdict. `possible`: one of several between which this recording does not decide. "
        "`minor`: detected, but not material. `absent`: not seen, or too small to matter. `unclear`: this recording cannot show it, "
        "names others beside which it may be missed, or has a gap that nothing explains.",
        examples=["present"],
    )
    parameters: Values = Field(description="Its fitted parameters by name; empty where nothing was fitted, or others are named.")


class Onset(DiagnosisPart):
    """When an effect came, or went."""

    change: Literal["came", "went"] = Field(description="Which of the two.", examples=["came"])
    after: int | None = Field(
        description="Index of the last recording that shows the state before, 0 for the first recording; null where there is none.",
        examples=[1],
    )
    by: int = Field(description="Index of the first recording that shows the state after.", examples=[2])
    message: Message = Field(description="The same as a message.")


class EffectTimeline(DiagnosisPart):
    """One effect in all recordings."""

    id: str = Field(description="Name of the effect or symptom.", examples=["time_delay"])
    title: Message = Field(description="What it is called.")
    sightings: list[Sighting] = Field(description="What each recording shows of it, in their order.")
    onsets: list[Onset] = Field(description="When it came and went; empty where that cannot be told.")


class Diagnosed(DiagnosisPart):
    """One of the recordings."""

    name: str = Field(description="What the recording is called.", examples=["2026-11-02"])
    verdict: Verdict = Field(description="The answer in one word.")
    summary: Message = Field(description="The answer in a sentence.")
    gap: float | None = Field(description="The gap before, in multiples of the noise (rms); null where it is not known.", examples=[4.2])


class Timeline(DiagnosisPart):
    """What came when; effects in the order in which they came."""

    recordings: list[Diagnosed] = Field(description="The recordings, in the order in which they were made.")
    effects: list[EffectTimeline] = Field(description="Every effect that any of them names.")
    summary: list[Message] = Field(description="What came and went, the earliest first; that nothing did, where nothing did.")


def trace_effects(names: Sequence[str], diagnoses: Sequence[Diagnosis]) -> Timeline:
    """Follows every effect that any of the diagnoses names through all of them.

    An effect that was there in one recording and not in the one before came between the two. A recording that leaves it open widens the
    time; it decides nothing. So does one that names others: only where no gap matters, an effect that is not seen is not there.

    Args:
        names: of the recordings. diagnoses: of the same, in the order in which the recordings were made.

    Raises:
        BadInput: they are of different robots, or began with different twins, so that what one names another was never asked for.
    """
    check_comparable(names, diagnoses)
    titles: dict[str, Message] = {}
    for diagnosis in diagnoses:
        titles |= {name: title for name, title in _find_named(diagnosis) if name not in titles}
    effects = [_trace(name, title, names, diagnoses) for name, title in titles.items()]
    effects.sort(key=lambda effect: min((onset.by for onset in effect.onsets), default=len(names)))
    told = sorted(((onset.by, onset.message) for effect in effects for onset in effect.onsets), key=lambda row: row[0])
    recordings = [
        Diagnosed(name=name, verdict=d.verdict, summary=d.summary, gap=None if d.gap is None else d.gap.before)
        for name, d in zip(names, diagnoses, strict=True)
    ]
    return Timeline(recordings=recordings, effects=effects, summary=[message for _, message in told] or [Message.of("timeline-nothing")])


def check_comparable(names: Sequence[str], diagnoses: Sequence[Diagnosis]) -> None:
    """Whether they can be held against each other, as far as they say what they are of; there may be more names than diagnoses yet.

    Raises:
        BadInput: they are of different robots, or began with different twins.
    """
    origins = [(name, d.origin) for name, d in zip(names, diagnoses, strict=False) if d.origin is not None]
    for (first, one), (then, other) in pairwise(origins):
        if one.joints != other.joints or (one.robot and other.robot and not is_same_robot(one.robot, other.robot)):
            raise BadInput(then, "timeline-other-robot", first=first)
        if one.twin != other.twin:
            raise BadInput(then, "timeline-other-twin", first=first)


def _find_named(diagnosis: Diagnosis) -> Iterator[tuple[str, Message]]:
    """Everything that its verdict names, and what it sees elsewhere that matters."""
    yield from ((name, find_effect_title(name, diagnosis)) for name in (*_present(diagnosis), *_possible(diagnosis)))
    yield from ((also.id, also.title) for also in diagnosis.also if also.material)


def _present(diagnosis: Diagnosis) -> tuple[str, ...]:
    """Effects that the verdict stands for."""
    ranked = rank_explanations(diagnosis)
    return ranked[0][1] if ranked and diagnosis.verdict == "explained" else ()


def _possible(diagnosis: Diagnosis) -> tuple[str, ...]:
    """Effects between which the recording does not decide, the most probable first."""
    if diagnosis.verdict != "ambiguous" or not rank_explanations(diagnosis):
        return ()
    return tuple(dict.fromkeys(name for ids in find_open(diagnosis) for name in ids))


def _trace(name: str, title: Message, names: Sequence[str], diagnoses: Sequence[Diagnosis]) -> EffectTimeline:
    sightings = [_see(name, d) for d in diagnoses]
    return EffectTimeline(id=name, title=title, sightings=sightings, onsets=list(_find_onsets(title, names, sightings)))


def _see(name: str, diagnosis: Diagnosis) -> Sighting:
    state = _state_of(name, diagnosis)
    # fitted by itself it takes up what the verdict gives to others: that is no size of it
    rejected = state == "unclear" and diagnosis.verdict == "explained"
    return Sighting(state=state, parameters={} if rejected else _parameters_of(name, diagnosis))


def _state_of(name: str, diagnosis: Diagnosis) -> State:
    for also in diagnosis.also:
        if also.id == name:
            return "present" if also.material else "minor"
    if name in _present(diagnosis):
        return "present"
    if name in _possible(diagnosis):
        return "possible"
    if any(minor.id == name for minor in diagnosis.minor):
        return "minor"
    hidden = any(limit.parameters.get("effect") == name for limit in diagnosis.limits)
    # where a recording names other effects, or decides between them only, this one may still be there, missed beside them
    return "absent" if diagnosis.verdict == "no_gap" and not hidden else "unclear"


def _parameters_of(name: str, diagnosis: Diagnosis) -> dict[str, Value]:
    """Beside the other effect where two are named."""
    both = next((pair.parameters for pair in diagnosis.pairs if pair.ids == _present(diagnosis)), {})
    parts: list[Explanation | Also | Minor] = [*diagnosis.effects, *diagnosis.also, *diagnosis.minor]
    return both.get(name) or next((part.parameters for part in parts if part.id == name), {})


def _find_onsets(title: Message, names: Sequence[str], sightings: Sequence[Sighting]) -> Iterator[Onset]:
    """Every change from one state that is certain to the other; what is there from the beginning came before."""
    last: tuple[int, bool] | None = None
    for k, sighting in enumerate(sightings):
        if sighting.state in ("possible", "unclear"):
            continue
        there = sighting.state == "present"
        if last is None and there:
            yield Onset(change="came", after=None, by=k, message=Message.of("timeline-before", effect=title, first=names[k]))
        elif last is not None and there != last[1]:
            code = "timeline-came" if there else "timeline-went"
            message = Message.of(code, effect=title, first=names[last[0]], then=names[k])
            yield Onset(change="came" if there else "went", after=last[0], by=k, message=message)
        last = k, there
