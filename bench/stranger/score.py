"""When an answer is right, and how many are, by kind."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from bench.stranger.answer import Answer

BESIDE = frozenset({"sensor_noise", "sensor_interference", "sensor_quantization", "sample_dropout", "payload_mismatch", "joint_friction"})
"""What is read off the recording beside the verdict on the wrench."""
OTHER_PAYLOAD = frozenset({"payload_mass_change", "payload_mismatch", "payload_loose", "payload_shift", "sensor_rotation"})
"""Where these are planted, the recording's reference is not what the payload is throughout, or is in the axes that the sensor should have:
strangers differ in that."""
HELD_STD = 1.96
"""Half of a 95 % interval, in standard uncertainties."""
TRUTHS = "truth.json"
"""In a set's folder, by the number of its recordings."""
NO_NAME = ("no_gap", "unknown")
"""Verdicts on the wrench that name nothing."""
KINDS = ("single in the wrench", "read off beside", "unknown", "pair", "none")


class Planted(BaseModel):
    """What the score has to know of the truth."""

    model_config = ConfigDict(frozen=True)

    kind: str
    families: tuple[str, ...]
    variant: str
    visible_sigma: float
    also_defensible: tuple[str, ...] = ()


def read_truths(folder: Path) -> dict[str, dict[str, object]]:
    """All that is told of the recordings that are there whole."""
    path = folder / TRUTHS
    return json.loads(path.read_text()) if path.exists() else {}


def read_planted(folder: Path) -> dict[str, Planted]:
    """What the score has to know of them."""
    return {number: Planted.model_validate(truth) for number, truth in read_truths(folder).items()}


def find_kind(truth: Planted) -> str:
    """One of `KINDS`."""
    if truth.kind == "double":
        return "pair"
    if truth.kind != "single":
        return truth.kind
    return "read off beside" if BESIDE.issuperset(truth.families) else "single in the wrench"


def is_right(truth: Planted, answer: Answer) -> bool:
    """Whether the verdict names what is in the wrench and nothing else, and what is to be read off beside it is there as material.

    Where all of it is read off beside, the verdict may be any that gives no other name: whether there is a gap or not is the same to
    whoever reads it. Friction of the joints may be left out there, since the recordings state none that it could be compared with.
    """
    if truth.kind == "unknown":
        return answer.named == "unknown"
    material = {name for name, is_material in answer.also if is_material}
    if truth.kind == "none":
        return answer.named == "no_gap" and not material
    beside = BESIDE.intersection(truth.families)
    in_wrench = sorted(set(truth.families) - beside)
    if in_wrench:
        return answer.named == "+".join(in_wrench) and beside <= material
    is_silent = answer.named in NO_NAME or answer.named in beside
    return is_silent and beside - {"joint_friction"} <= material


def count_right(truths: Mapping[str, Planted], answers: Mapping[str, Answer]) -> dict[str, tuple[int, int]]:
    """By kind: how many answers are right, and how many there are. Both arguments are by the case's number."""
    tally = {}
    for kind in KINDS:
        of_kind = [is_right(truths[case], answer) for case, answer in answers.items() if find_kind(truths[case]) == kind]
        tally[kind] = sum(of_kind), len(of_kind)
    return tally


def count_held(truths: Mapping[str, Planted], answers: Mapping[str, Answer]) -> tuple[int, int]:
    """Of the payload's parameters: how many 95 % intervals hold what they are, and how many there are; where nothing planted is known to
    change it, so none of the causes that no effect describes count."""
    same = [
        answer
        for case, answer in answers.items()
        if truths[case].kind != "unknown" and not OTHER_PAYLOAD.intersection(truths[case].families)
    ]
    off = [abs(each) for answer in same for each in answer.payload_off]
    return sum(each <= HELD_STD for each in off), len(off)


def print_held(truths: Mapping[str, Planted], answers: Mapping[str, Answer]) -> None:
    """A line on the payload's intervals, where the recordings' references are what their payloads are."""
    held, count = count_held(truths, answers)
    print(f"95 % intervals of the payload hold {held} of {count} parameters")


def print_score(truths: Mapping[str, Planted], answers: Mapping[str, Answer]) -> None:
    """A line for each kind, then one for each answer that is not right."""
    for kind, (right, count) in count_right(truths, answers).items():
        print(f"{kind:22s}{right:4d} of {count}")
    for case, answer in sorted(answers.items()):
        if not is_right(truths[case], answer):
            print(_describe(case, truths[case], answer))


def _describe(case: str, truth: Planted, answer: Answer) -> str:
    """What is so, and what was said instead."""
    gap = "" if answer.gap is None else f" gap {answer.gap[0]:.2f} -> {answer.gap[1]:.2f};"
    said = [f"{name} {probability:.2f}" for name, probability, _ in answer.effects[:3]]
    said += [f"{'+'.join(names)} {probability:.2f}" for names, probability, _ in answer.pairs[:2]]
    said += [f"none {answer.none:.2f}", f"unknown {answer.unknown:.2f}"]
    also = [name for name, is_material in answer.also if is_material]
    beside = f"; beside: {', '.join(also)}" if also else ""
    minor = f"; minor: {', '.join(answer.minor)}" if answer.minor else ""
    defensible = f" (defensible: {', '.join(truth.also_defensible)})" if truth.also_defensible else ""
    verdict = answer.verdict if answer.named == answer.verdict else f"{answer.verdict}, {answer.named}"
    truly = "+".join(sorted(truth.families)) or truth.kind
    return (
        f"{case} {truly}{defensible}: {truth.variant}, {truth.visible_sigma:.0f} sigma\n"
        f"    said {verdict};{gap} {', '.join(said)}{beside}{minor}"
    )
