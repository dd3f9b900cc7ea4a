"""The answer to a recording without a wrist wrench: nothing of the wrench's gap, but what the joints show, in words."""

from __future__ import annotations

from functools import reduce

from core.estimation.joint_torques.identification import identify_by_torques
from core.gap.answer import Diagnosis
from core.gap.answering import not_enough
from core.gap.symptoms import observe_joints
from core.recording.recording import Recording
from core.words.message import Message


def answer_joints(recording: Recording, reason: Message) -> Diagnosis:
    """Friction, offsets and late velocities, and what the torques tell of a load; the verdict, which is about the wrench, stays
    `not_enough`, with the reason."""
    plain, also = not_enough(reason, 0.0), observe_joints(recording)
    load, remarks = _describe_load(recording)
    seen = [*load, *(each.message for each in also if each.material)]
    if not also and not load:
        return plain
    said = (
        reduce(lambda first, more: Message.of("gap-summary-and", said=first, more=more), seen) if seen else Message.of("gap-joints-as-ever")
    )
    limits = [*remarks, *([] if recording.tau is None else [Message.of("gap-joints-two")])]
    return plain.model_copy(update={"summary": Message.of("gap-joints-alone", seen=said), "also": also, "limits": limits})


def _describe_load(recording: Recording) -> tuple[list[Message], list[Message]]:
    """What the torques tell of the load, and what has to be known of that; nothing where they cannot."""
    if recording.tau is None:
        return [], []
    found = identify_by_torques(recording)
    return ([], []) if found.estimate is None else ([found.verdict], list(found.warnings))
