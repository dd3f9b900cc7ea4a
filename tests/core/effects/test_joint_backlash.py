"""The play of a gear, against physics that is written down here."""

from __future__ import annotations

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import lfilter

from core.effects.joint_backlash import AT_ONCE_S, JointBacklash
from core.effects.play_that_is_held import PlayThatIsHeld
from tests.core.effects.mechanical_truth import T, believed, change, load, rms, truth
from tests.core.effects.planted_mechanics import PLAY


def test_hard_contact_shifts_a_joint_by_all_of_its_play_while_it_is_pushed_to_one_side() -> None:
    """A second derivative from the rows before, twice four of them, sees a change of sides up to seven rows later."""
    pushed = (np.abs(load(T)) > 1.5).all(axis=1)
    settled = np.convolve(~pushed, np.ones(8))[: len(T)] == 0
    true = truth(lambda t: believed(t) - PLAY * np.sign(load(t))).wrench() - truth().wrench()
    found = change(JointBacklash(), np.append(PLAY, [0.1, 0.003, AT_ONCE_S]))
    assert settled.mean() > 0.4
    assert rms(true[settled]) > 0.5
    assert rms((found - true)[settled]) < 0.02 * rms(true[settled])


def test_a_side_that_takes_time_to_cross_follows_the_load_through_two_equal_lags() -> None:
    slow, contact_nm, step = 0.08, 3.0, T[1] - T[0]
    side, gain = np.tanh(load(T) / contact_nm), step / slow
    for _ in range(2):
        side = lfilter([gain, gain], [2.0 + gain, gain - 2.0], side - side[0], axis=0) + side[0]
    leaning = CubicSpline(T, side)
    true = truth(lambda t: believed(t) - PLAY * leaning(np.clip(t, T[0], T[-1]))).wrench() - truth().wrench()
    found, at_once = (change(JointBacklash(), np.append(PLAY, [contact_nm, 0.003, crossing_s])) for crossing_s in (slow, AT_ONCE_S))
    inside = slice(20, -20)
    assert rms((found - true)[inside]) < 0.15 * rms(true[inside])
    assert rms((at_once - true)[inside]) > 0.3 * rms(true[inside])


def test_a_side_that_friction_holds_is_left_only_when_the_load_pushes_the_other_way_by_more() -> None:
    holding, side = 6.0, np.zeros((len(T), 7))
    for j, torque in enumerate(load(T).T):
        leaning = 1.0 if torque[0] > 0.0 else -1.0
        for k, tau in enumerate(torque):
            leaning = float(np.sign(tau)) if abs(tau) > holding else leaning
            side[k, j] = leaning
    crossing = np.abs(np.diff(side, axis=0, prepend=side[:1])).any(axis=1)
    settled = np.convolve(crossing, np.ones(25), mode="same") == 0  # a contact torque of 0.1 N m is felt a few rows before
    settled[:12] = False
    held = truth(lambda t: believed(t) - PLAY * side[np.clip(np.round(62.5 * t).astype(int), 0, len(T) - 1)]).wrench() - truth().wrench()
    theta = np.append(PLAY, [0.1, 0.003, AT_ONCE_S])
    found, not_held = change(PlayThatIsHeld(), np.append(theta, holding)), change(JointBacklash(), theta)
    assert (settled & (np.abs(load(T)) < 0.5 * holding).any(axis=1)).mean() > 0.2
    assert rms((found - held)[settled]) < 0.02 * rms(held[settled])
    assert rms((not_held - held)[settled]) > 0.2 * rms(held[settled])
