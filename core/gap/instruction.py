"""What the person at the robot has to do, in a sentence without figures of the trade.

Made of the diagnosis alone, so that a diagnosis of an earlier version has it too. Pure data and quick to import: the service makes it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import reduce
from typing import TYPE_CHECKING, Literal, NamedTuple

from pydantic import BaseModel, ConfigDict, Field

from core.words.message import Message

if TYPE_CHECKING:
    from core.gap.answer import Also, Diagnosis, Explanation, Value

Level = Literal["nothing", "act", "measure", "ask"]
"""Nothing to do; something that a person at the robot can do; measure once more; it takes an engineer."""

OPEN = 0.05
"""Probability from which an explanation that is not settled is named."""
SETUP = "setup"
"""File of the messages about slips in a recording's set-up: recording again would repeat them."""
FIRST = ("reference", "reading", "joints")
"""What is seen elsewhere than in the wrench, in this order."""


class Instruction(BaseModel):
    """What the person at the robot has to do."""

    model_config = ConfigDict(frozen=True)

    level: Level = Field(description="Whose it is: nothing to do, act at the robot, measure once more, or ask an engineer.")
    sentence: Message = Field(description="The verdict, for everybody.")
    next: Message = Field(description="What to do, and what then.")
    further: list[Message] = Field(default_factory=list, description="What has to be done besides.")
    at_s: float | None = Field(
        default=None,
        description="When it happened, from the beginning of the recording, s; null where it did not happen at one time.",
        examples=[31.4],
    )


class Said(NamedTuple):
    """What is said of one effect, and where to find its time."""

    level: Level
    sentence: Message
    next: Message


Values = Mapping[str, "Value"]

FIXED: dict[str, Said] = {
    "cable_drag": Said("act", Message.of("instruction-cable-drag"), Message.of("instruction-cable-drag-next")),
    "gear_ripple": Said("ask", Message.of("instruction-gear-ripple"), Message.of("instruction-gear-ripple-next")),
    "joint_backlash": Said("ask", Message.of("instruction-joint-backlash"), Message.of("instruction-joint-backlash-next")),
    "joint_elasticity": Said("ask", Message.of("instruction-joint-elasticity"), Message.of("instruction-joint-elasticity-next")),
    "joint_friction": Said("act", Message.of("instruction-joint-friction"), Message.of("instruction-joint-friction-next")),
    "joint_offset": Said("ask", Message.of("instruction-joint-offset"), Message.of("instruction-joint-offset-next")),
    "kinematic_lag": Said("ask", Message.of("instruction-kinematic-lag"), Message.of("instruction-kinematic-lag-next")),
    "payload_loose": Said("act", Message.of("instruction-payload-loose"), Message.of("instruction-payload-loose-next")),
    "payload_mismatch": Said("act", Message.of("instruction-payload-mismatch"), Message.of("instruction-payload-mismatch-next")),
    "sample_dropout": Said("ask", Message.of("instruction-sample-dropout"), Message.of("instruction-sample-dropout-next")),
    "sensor_creep": Said("act", Message.of("instruction-sensor-creep"), Message.of("instruction-sensor-creep-next")),
    "sensor_crosstalk": Said("ask", Message.of("instruction-sensor-crosstalk"), Message.of("instruction-sensor-crosstalk-next")),
    "sensor_drift": Said("act", Message.of("instruction-sensor-drift"), Message.of("instruction-sensor-drift-next")),
    "sensor_gain": Said("ask", Message.of("instruction-sensor-gain"), Message.of("instruction-sensor-gain-next")),
    "sensor_hysteresis": Said("act", Message.of("instruction-sensor-hysteresis"), Message.of("instruction-sensor-hysteresis-next")),
    "sensor_interference": Said("act", Message.of("instruction-sensor-interference"), Message.of("instruction-sensor-interference-next")),
    "sensor_lowpass": Said("ask", Message.of("instruction-sensor-lowpass"), Message.of("instruction-sensor-lowpass-next")),
    "sensor_noise": Said("act", Message.of("instruction-sensor-noise"), Message.of("instruction-sensor-noise-next")),
    "sensor_nonlinearity": Said("ask", Message.of("instruction-sensor-nonlinearity"), Message.of("instruction-sensor-nonlinearity-next")),
    "sensor_quantization": Said("ask", Message.of("instruction-sensor-quantization"), Message.of("instruction-sensor-quantization-next")),
    "sensor_rotation": Said("ask", Message.of("instruction-sensor-rotation"), Message.of("instruction-sensor-rotation-next")),
    "sensor_saturation": Said("act", Message.of("instruction-sensor-saturation"), Message.of("instruction-sensor-saturation-next")),
    "sensor_translation": Said("ask", Message.of("instruction-sensor-translation"), Message.of("instruction-sensor-translation-next")),
    "structure_vibration": Said("act", Message.of("instruction-structure-vibration"), Message.of("instruction-structure-vibration-next")),
    "time_delay": Said("ask", Message.of("instruction-time-delay"), Message.of("instruction-time-delay-next")),
    "torque_offset": Said("ask", Message.of("instruction-torque-offset"), Message.of("instruction-torque-offset-next")),
    "velocity_lag": Said("ask", Message.of("instruction-velocity-lag"), Message.of("instruction-velocity-lag-next")),
    "tool_flexibility": Said("act", Message.of("instruction-tool-flexibility"), Message.of("instruction-tool-flexibility-next")),
}
"""Effects of which the same is said whatever their size."""


def _say_tilt(values: Values, _clock: str) -> Said:
    angle = math.hypot(*(each.value for each in values.values()))
    return Said("act", Message.of("instruction-base-tilt"), Message.of("instruction-base-tilt-next", angle_rad=angle))


def _say_mass_change(values: Values, clock: str) -> Said:
    mass_kg = values["mass_kg"].value if "mass_kg" in values else 0.0
    code = "instruction-payload-mass-lost" if mass_kg < 0 else "instruction-payload-mass-gained"
    return Said("act", Message.of(code, at=clock), Message.of("instruction-payload-mass-change-next", mass_kg=abs(mass_kg)))


def _say_contact(_values: Values, clock: str) -> Said:
    return Said("act", Message.of("instruction-external-contact", at=clock), Message.of("instruction-external-contact-next"))


def _say_slip(_values: Values, clock: str) -> Said:
    return Said("act", Message.of("instruction-payload-shift", at=clock), Message.of("instruction-payload-shift-next"))


def _say_step(_values: Values, clock: str) -> Said:
    return Said("act", Message.of("instruction-sensor-offset-step", at=clock), Message.of("instruction-sensor-offset-step-next"))


SIZED: dict[str, Callable[[Values, str], Said]] = {
    "base_tilt": _say_tilt,
    "external_contact": _say_contact,
    "payload_mass_change": _say_mass_change,
    "payload_shift": _say_slip,
    "sensor_offset_step": _say_step,
}
"""Effects of which is said how large they are, or when they happened."""


SHAKES = "structure_vibration"
"""Where nothing explains the gap, and this is there, it is to be stopped before an engineer looks at the rest."""


def instruct(diagnosis: Diagnosis) -> Instruction:
    """What the person at the robot has to do about a diagnosis."""
    beside = [_say(each.id, each.parameters, diagnosis) for each in _material(diagnosis)]
    match diagnosis.verdict:
        case "explained":
            parts = _find_best(diagnosis)
            found = [_say(name, values, diagnosis) for name, values in parts]
            at_s = next((at for name, values in parts if (at := _when(name, values, diagnosis)) is not None), None)
            return _lead([*(found or [_say_unknown(diagnosis)]), *beside], at_s)
        case "ambiguous" if rank_explanations(diagnosis):
            return _settle(diagnosis, beside)
        case "ambiguous" | "unknown":
            unknown, shakes = _say_unknown(diagnosis), any(each.id == SHAKES for each in _material(diagnosis))
            return _lead([*beside, unknown]) if shakes else _lead([unknown, *beside], _begin_of_worst(diagnosis))
        case "not_enough":
            return _record_again(diagnosis, beside)
        case _:
            return _lead(beside) if beside else _nothing()


def _record_again(diagnosis: Diagnosis, beside: list[Said]) -> Instruction:
    """What a recording lacks, or has wrong; where the joints alone were recorded, what is seen there goes first."""
    reason = diagnosis.lacking or diagnosis.summary
    if diagnosis.summary.code == "gap-joints-alone":
        return _lead([*beside, Said("measure", Message.of("instruction-joints-alone"), Message.of("instruction-joints-alone-next"))])
    if reason.code.partition("-")[0] == SETUP:
        corrected = Message.of("instruction-correct-recording-next", reason=reason)
        return _lead([Said("ask", Message.of("instruction-correct-recording"), corrected)])
    return _lead([Said("measure", Message.of("instruction-record-again"), Message.of("instruction-record-again-next", reason=reason))])


def explains(effect: str) -> bool:
    """Whether an effect has words for the person at the robot."""
    return effect in FIXED or effect in SIZED


def _nothing() -> Instruction:
    return _lead([Said("nothing", Message.of("instruction-nothing"), Message.of("instruction-nothing-next"))])


def _lead(said: list[Said], at_s: float | None = None) -> Instruction:
    """The first as the verdict, the others besides."""
    first, *others = said
    return Instruction(level=first.level, sentence=first.sentence, next=first.next, further=[each.sentence for each in others], at_s=at_s)


def _settle(diagnosis: Diagnosis, beside: list[Said]) -> Instruction:
    """Measure once more where the robot has a motion that settles it; ask an engineer where it has none."""
    names = [reduce(_and, [find_effect_title(name, diagnosis) for name in ids]) for ids in find_open(diagnosis)]
    effects = reduce(lambda first, second: Message.of("effect-or", first=first, second=second), names)
    motion = diagnosis.next_experiment
    if motion is not None and motion.planned:
        first = Said("measure", Message.of("instruction-measure-again"), Message.of("instruction-measure-again-next", effects=effects))
    else:
        first = Said("ask", Message.of("instruction-not-settled"), Message.of("instruction-not-settled-next", effects=effects))
    return _lead([first, *beside])


def find_effect_title(name: str, diagnosis: Diagnosis) -> Message:
    """What an effect is called: as the diagnosis has it, else as the library does; one that neither has is said as it is."""
    told: list[Explanation | Also] = [*diagnosis.effects, *diagnosis.also]
    if titles := [each.title for each in told if each.id == name]:
        return titles[0]
    from core.effects.library import find_effect  # noqa: PLC0415 - numerics, for what was fitted beside another alone

    try:
        return find_effect(name).title
    except KeyError:
        return Message.of("text", text=name.replace("_", " "))


def _and(first: Message, second: Message) -> Message:
    return Message.of("effect-and", first=first, second=second)


def find_open(diagnosis: Diagnosis) -> list[tuple[str, ...]]:
    """The most probable explanation, and whatever else is probable or cannot be told from it."""
    ranked = rank_explanations(diagnosis)
    best = ranked[0][1]
    tied = {name for tie in diagnosis.indistinguishable if "+".join(best) in tie.ids for name in tie.ids}
    return [ids for k, (p, ids) in enumerate(ranked) if k == 0 or p >= OPEN or "+".join(ids) in tied]


def rank_explanations(diagnosis: Diagnosis) -> list[tuple[float, tuple[str, ...]]]:
    """Effects and pairs by their identifiers, the most probable first."""
    singles = [(effect.probability, (effect.id,)) for effect in diagnosis.effects]
    pairs = [(pair.probability, tuple(pair.ids)) for pair in diagnosis.pairs]
    return sorted([*singles, *pairs], key=lambda each: -each[0])


def find_advice(diagnosis: Diagnosis, ids: tuple[str, ...]) -> dict[str, Message]:
    """What to do about each effect of an explanation, as large as it is in that."""
    alone = {effect.id: effect.advice for effect in diagnosis.effects}
    beside = next((pair.advice for pair in diagnosis.pairs if pair.ids == ids), {})
    advice = alone | beside
    return {name: advice[name] for name in ids if name in advice}


def _find_best(diagnosis: Diagnosis) -> list[tuple[str, Values]]:
    """The effects of the most probable explanation with their parameters."""
    ranked = rank_explanations(diagnosis)
    if not ranked:
        return []
    _, best = ranked[0]
    if len(best) == 1:
        return [(effect.id, effect.parameters) for effect in diagnosis.effects if effect.id == best[0]]
    pair = next(pair for pair in diagnosis.pairs if tuple(pair.ids) == best)
    return [(name, pair.parameters.get(name, {})) for name in best]


def _material(diagnosis: Diagnosis) -> list[Also]:
    """What matters elsewhere than in the wrench, most important first."""
    return sorted((each for each in diagnosis.also if each.material), key=lambda each: FIRST.index(each.side))


def _say(name: str, values: Values, diagnosis: Diagnosis) -> Said:
    """What is said of one effect; one that has no words of its own is an engineer's."""
    if name in FIXED:
        return FIXED[name]
    if name in SIZED:
        return SIZED[name](values, _clock(_when(name, values, diagnosis)))
    title = find_effect_title(name, diagnosis)
    return Said("ask", Message.of("instruction-other", effect=title), Message.of("instruction-other-next"))


def _when(name: str, values: Values, diagnosis: Diagnosis) -> float | None:
    """When something happened, from the beginning of the recording, s."""
    if "step_time_s" in values:
        return values["step_time_s"].value
    if name not in SIZED or "at_s" not in values:
        return None
    return max(0.0, values["at_s"].value - _begin(diagnosis))


def _begin_of_worst(diagnosis: Diagnosis) -> float | None:
    """The beginning of the tenth of the recording that holds most of the gap, from the beginning, s."""
    where = diagnosis.where
    return None if where is None or where.worst_s is None else max(0.0, where.worst_s[0] - _begin(diagnosis))


def _begin(diagnosis: Diagnosis) -> float:
    return 0.0 if diagnosis.origin is None else diagnosis.origin.begins_s


def _say_unknown(diagnosis: Diagnosis) -> Said:
    sentence, where = Message.of("instruction-unknown"), diagnosis.where
    if where is None or where.worst_s is None:
        return Said("ask", sentence, Message.of("instruction-unknown-next"))
    begin, end = (_clock(max(0.0, at - _begin(diagnosis))) for at in where.worst_s)
    return Said("ask", sentence, Message.of("instruction-unknown-next-at", begin=begin, end=end))


def _clock(at_s: float | None) -> str:
    """Minutes and seconds, as every clock shows them: 0:31."""
    whole = 0 if at_s is None else math.floor(at_s)
    return f"{whole // 60}:{whole % 60:02d}"
