"""The diagnosis of one recording: where the gap lies, which effect causes it, how far it shrinks once that effect is added."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from core.cell.kinematics import joint_axes
from core.effects.effect import Effect
from core.effects.library import find_effect, library
from core.estimation.setup.check import check_setup
from core.gap.answer import Diagnosis, Origin
from core.gap.answering import answer, not_enough
from core.gap.basis import TooLittleError, basis_of
from core.gap.contact_answer import answer_touched, find_touched, with_contacts
from core.gap.evidence import Evidence, gather
from core.gap.fine_windows import find_what_rings
from core.gap.fit_all import FitAll, on_all_cores
from core.gap.joint_answer import answer_joints
from core.gap.moments import spare_moments
from core.gap.proposal import proposals
from core.gap.singles import describe_limits
from core.gap.sound_gears import describe_gears
from core.gap.windows import Windows
from core.recording.folder import recording_sha256
from core.recording.held_readings import drop_repeated_rows
from core.recording.recording import Recording
from core.twin.model import explain_lacks, find_terms
from core.twin.twin import NOMINAL, Twin
from core.words.message import Message


def diagnose(recording: Recording, effects: Sequence[Effect] | None = None, twin: Twin = NOMINAL) -> Diagnosis:
    """Answers the three questions for one recording, which is only read.

    Args:
        recording: with a wrist wrench and motion; anything less is answered with what is missing.
        effects: candidates; the whole library where absent.
        twin: of the cell; its effects are always on, and a candidate that it has already is sought as a change of it.
    """
    return examine(recording, effects, twin)[0]


def examine(
    recording: Recording,
    effects: Sequence[Effect] | None = None,
    twin: Twin = NOMINAL,
    *,
    folder: Path | None = None,
    fit_all: FitAll = on_all_cores,
) -> tuple[Diagnosis, Evidence | None]:
    """The diagnosis together with everything that was fitted; None where the recording is not enough.

    Args:
        folder: that the recording was read from; without it, nothing that is found can go into a twin.
    """
    began = time.perf_counter()
    recording = drop_repeated_rows(recording)
    try:
        basis = basis_of(recording)
    except TooLittleError as reason:
        told = not_enough(reason.message, 0.0) if recording.wrench is not None else answer_joints(recording, reason.message)
        origin = None if folder is None or not told.also else find_origin(recording, folder, twin)
        return told.model_copy(update={"origin": origin, "seconds": time.perf_counter() - began}), None
    setup, candidates = check_setup(recording), library() if effects is None else effects
    if setup.contradiction is not None and setup.effect not in {effect.id for effect in candidates}:
        return not_enough(setup.contradiction, time.perf_counter() - began), None
    terms = find_terms(twin, basis.scene)
    windows = Windows(basis, terms)
    evidence = gather(windows, candidates, fit_all)
    others = {effect.id for effect in evidence.named.effects}
    if setup.contradiction is not None and (not others or setup.effect in others):
        return not_enough(setup.contradiction, time.perf_counter() - began), None
    fine = None if evidence.material else find_what_rings(evidence.windows, evidence.nominal, evidence.best)
    if fine is not None:
        evidence = gather(fine, candidates, fit_all)
    if evidence.verdict == "ambiguous":
        evidence = replace(evidence, proposals=proposals(recording, evidence.windows, evidence.rivals))
    touched = find_touched(evidence, candidates, fit_all) if evidence.in_doubt else None
    if evidence.in_doubt and touched is None:
        evidence = spare_moments(evidence) or evidence
    told = answer(recording, evidence) if touched is None else answer_touched(recording, evidence, touched)
    lacking = describe_limits({find_effect(name): reason for name, reason in explain_lacks(twin, basis.scene).items()})
    apart = _describe_poses(recording) if basis.scene.apart else []
    level = [Message.of("gap-hardly-turns")] if basis.scene.hardly_turns else []
    swings = [describe_gears(term) for term in evidence.windows.held[len(terms) :]]
    held = {"twin": [term.effect.id for term in terms], "limits": [*swings, *apart, *level, *told.limits, *lacking]}
    origin = None if folder is None else find_origin(recording, folder, twin)
    shown = evidence if touched is None else with_contacts(evidence, touched)
    return told.model_copy(update={**held, "origin": origin, "seconds": time.perf_counter() - began}), shown


def _describe_poses(recording: Recording) -> list[Message]:
    stated = recording.sensor.noise_std is not None
    return [Message.of("gap-of-poses"), *([] if stated else [Message.of("gap-noise-of-poses")])]


def find_origin(recording: Recording, folder: Path, twin: Twin) -> Origin:
    """What a diagnosis is of; the recording was read from the folder."""
    robot = recording.robot
    return Origin(
        recording=folder.resolve().name,
        sha256=recording_sha256(folder),
        cell=recording.cell,
        joints=0 if recording.q is None else recording.q.shape[1],
        robot=None if robot is None else joint_axes(robot.urdf, robot.joints, robot.base_frame, str(folder)),
        begins_s=float(recording.t[0]),
        twin=twin.hashes,
    )
