"""Logs of real arms, read here by numpy alone: KUKA LBR Med 14 (A. Skrede, NTNU, CC BY 4.0) and UR5 (K. Kufieta, NTNU, Apache-2.0)."""

from __future__ import annotations

import gzip
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from core.effects.effect import Effect
from core.effects.library import library
from core.gap.diagnosis import diagnose
from core.recording.recording import Recording

REAL = Path(__file__).parents[4] / "shared" / "real"
GRAVITY = np.array([0.0, 0.0, -9.81])
NEAREST = ("external_contact", "cable_drag", "payload_shift", "sensor_offset_step", "sensor_drift")
RIVALS = tuple(effect for effect in library() if effect.id in NEAREST)
"""A contact, and what comes nearest to it."""


def table(file: Path, skip: int = 0) -> np.ndarray:
    with gzip.open(file, "rt") as text:
        return np.loadtxt(text, delimiter=",", skiprows=skip)


def kuka(name: str) -> Recording:
    """Time in microseconds, orientations of their own clock; the sign of the wrench is opposite to the paper's."""
    wrench = table(REAL / f"logs/kuka-med14/{name}_wrench.csv.gz", skip=1)
    attitude = table(REAL / f"logs/kuka-med14/{name}_orientations.csv.gz", skip=1)
    turned = Slerp(attitude[:, 0], Rotation.from_matrix(attitude[:, 1:].reshape(-1, 3, 3)))
    wrench = wrench[(wrench[:, 0] >= attitude[0, 0]) & (wrench[:, 0] <= attitude[-1, 0])]
    t = (wrench[:, 0] - wrench[0, 0]) * 1e-6
    return Recording(t=t, gravity=GRAVITY, wrench=-wrench[:, 1:], orientation=turned(wrench[:, 0]).as_matrix())


def ur5() -> Recording:
    """Sensor and robot each with seconds from a beginning of their own."""
    folder = REAL / "logs/ur5-pushes"
    begins = [float((folder / name).read_text().split()[0].split(",")[0]) for name in ("log_force_sensor_start_time.csv", "start_time.csv")]
    wrench, pose = table(folder / "log_force_sensor.csv.gz"), table(folder / "log_tool_vector.csv.gz")
    t = wrench[:, 0] + begins[0] - begins[1]
    kept = (t >= pose[0, 0]) & (t <= pose[-1, 0]) & np.append(True, np.diff(t) > 0.0)
    t, wrench = t[kept], wrench[kept, 1:]
    turned = Slerp(pose[:, 0], Rotation.from_rotvec(pose[:, 4:7]))
    position = np.column_stack([np.interp(t, pose[:, 0], pose[:, k]) for k in (1, 2, 3)])
    return Recording(t=t, gravity=GRAVITY, wrench=wrench, orientation=turned(t).as_matrix(), position=position)


@pytest.mark.thorough
def test_a_hand_on_the_tool_is_named_with_its_time_and_the_payload_is_that_of_the_rest() -> None:
    # the readings themselves leave those of the untouched run from 0.60 s on, and are back at 4.15 s
    diagnosis = diagnose(kuka("3-vibrations-contact"))
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "external_contact")
    (contact,) = diagnosis.where.contacts
    assert (contact.begin_s, contact.end_s) == pytest.approx((0.60, 4.15), abs=0.1)
    before, after = (abs(payload.phi[0] - 0.932) for payload in (diagnosis.payload.before, diagnosis.payload.after))
    assert after < 0.03
    assert before > 0.09
    assert diagnosis.gap.after == pytest.approx(2.4, abs=0.2), "of what nobody touched, as the summary says it"
    assert "2.4" in diagnosis.summary.text


def test_a_run_in_which_nothing_happened_has_no_gap_that_matters_and_nothing_beside() -> None:
    diagnosis = diagnose(kuka("1-baseline"))
    assert diagnosis.verdict == "no_gap"
    assert not diagnosis.also
    assert not diagnosis.where.contacts


def test_blows_of_a_hammer_are_a_vibration_with_the_frequency_that_their_author_states_and_no_contact() -> None:
    diagnosis = diagnose(kuka("2-vibrations"), RIVALS)
    assert diagnosis.verdict == "no_gap"
    assert not diagnosis.where.contacts
    (vibration,) = [each for each in diagnosis.also if each.material]
    assert vibration.id == "structure_vibration"
    assert vibration.parameters["frequency_hz"].value == pytest.approx(12.0, abs=0.3)


@pytest.mark.thorough
@pytest.mark.parametrize("effects", [RIVALS, library()], ids=["rivals", "whole library"])
def test_pushes_by_hand_in_a_moving_arm_are_named_and_the_quiet_parts_are_not(effects: tuple[Effect, ...]) -> None:
    recording = ur5()
    diagnosis = diagnose(recording, effects)
    assert (diagnosis.verdict, diagnosis.effects[0].id) == ("explained", "external_contact")
    spans = np.array([(contact.begin_s, contact.end_s) for contact in diagnosis.where.contacts])
    assert max(contact.most_n for contact in diagnosis.where.contacts) == pytest.approx(52.0, abs=3.0)
    read = pushes_as_read(recording)
    assert spans.shape == read.shape == (9, 2)
    off_s = np.abs(spans - read)
    assert np.count_nonzero(off_s > 0.1) <= 1, "one hand comes nearer slowly"
    assert off_s.max() < 0.15


def pushes_as_read(recording: Recording) -> np.ndarray:
    """(n, 2), s: where the force is more than 1.5 N off what it was before the first push, pauses below 0.25 s left out."""
    t, force = recording.t, recording.wrench[:, :3]
    off = np.linalg.norm(force - np.median(force[t < t[0] + 3.5], axis=0), axis=1)
    at = t[off > 1.5]
    runs = np.split(at, np.flatnonzero(np.diff(at) > 0.25) + 1)
    return np.array([(run[0], run[-1]) for run in runs if run[-1] - run[0] > 0.15])
