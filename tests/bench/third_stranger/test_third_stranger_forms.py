"""`bench.third_stranger`: how rows are polled and rounded, and what is left out in pauses."""

from __future__ import annotations

import numpy as np

from bench.third_stranger.forms import choose_steps
from bench.third_stranger.plan import list_cases
from bench.third_stranger.reading import draw_noise, poll
from bench.third_stranger.scene import Scene, draw_scene


def draw(name: str) -> Scene:
    case = next(case for case in list_cases() if case.order.name == name)
    return draw_scene(np.random.default_rng(5), case.wish)


def test_a_polled_sensor_answers_a_fifth_of_the_rows() -> None:
    places = poll(np.arange(1000) / 500 + 0.004, 100)
    np.testing.assert_array_equal(places, np.arange(1000) // 5 * 5)


def test_steps_of_a_protocol_are_decimal_and_hidden_in_the_noise() -> None:
    np.testing.assert_allclose(choose_steps(np.array([0.07, 0.0026]), is_rounded=True), [0.05, 0.002])


def test_nothing_is_recorded_while_the_recorder_pauses() -> None:
    rig = draw("none4").rig
    gaps = np.diff(rig.times)
    assert np.sum(gaps > 2) == 3
    assert np.sum(gaps > 0.01) == 3


def test_noise_is_as_strong_as_the_rig_says_and_has_a_colour_for_each_channel() -> None:
    scene = draw("none1")
    noise = draw_noise(np.random.default_rng(0), scene) / scene.row_noise
    np.testing.assert_allclose(noise.std(0), 1, atol=0.05)
    np.testing.assert_allclose(np.mean(noise[1:] * noise[:-1], 0), scene.colours, atol=0.05)
