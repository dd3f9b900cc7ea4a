"""What every effect in the library promises."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import subprocess
import sys

import numpy as np
import pytest

import core.effects
from core.effects.effect import Effect, Parameter, Symptom
from core.effects.library import find_effect, library, wider_shapes
from core.effects.scene import Scene
from tests.core.effects.synthetic_scene import first_rows, poses_only, scene

TABLE = {
    "sensor_drift",
    "sensor_offset_step",
    "sensor_gain",
    "sensor_crosstalk",
    "sensor_nonlinearity",
    "sensor_hysteresis",
    "sensor_creep",
    "sensor_saturation",
    "sensor_quantization",
    "sensor_noise",
    "sensor_interference",
    "time_delay",
    "sensor_lowpass",
    "kinematic_lag",
    "sample_dropout",
    "sensor_rotation",
    "sensor_translation",
    "base_tilt",
    "joint_offset",
    "joint_elasticity",
    "joint_backlash",
    "joint_friction",
    "gear_ripple",
    "payload_mismatch",
    "payload_loose",
    "payload_shift",
    "payload_mass_change",
    "tool_flexibility",
    "cable_drag",
    "external_contact",
    "structure_vibration",
    "torque_offset",
    "velocity_lag",
}
"""The effects of the project's specification, `unknown` apart, and what shakes the structure, which has no name there."""

DIMENSIONLESS = re.compile(r".*(_share|_ratio|_factor|correlation|_n_per_n|_nm_per_nm)$")


def symptoms() -> list[Symptom]:
    """One instance of every symptom in the folder."""
    found = []
    for module in pkgutil.iter_modules(core.effects.__path__):
        for _, kind in inspect.getmembers(importlib.import_module(f"core.effects.{module.name}"), inspect.isclass):
            if issubclass(kind, Symptom) and not inspect.isabstract(kind) and kind.__module__ == f"core.effects.{module.name}":
                found.append(kind())
    return found


@pytest.fixture(scope="module")
def run() -> Scene:
    return scene(seconds=9.0)


every_effect = pytest.mark.parametrize("effect", (*library(), *wider_shapes()), ids=lambda effect: type(effect).__name__)


def drawn(parameters: tuple[Parameter, ...], rng: np.random.Generator) -> np.ndarray:
    """Parameters of plausible size within their bounds."""
    scales = np.array([p.scale for p in parameters])
    centre = np.array([p.absent for p in parameters])
    bounds = np.array([(p.lower, p.upper) for p in parameters]).T
    return np.clip(centre + scales * rng.uniform(-1, 1, len(parameters)), *bounds)


def test_every_effect_of_the_specification_is_there_and_no_other() -> None:
    ids = [effect.id for effect in library()] + [symptom.id for symptom in symptoms()]
    assert len(ids) == len(set(ids))
    assert set(ids) == TABLE


@every_effect
def test_at_its_absent_values_an_effect_changes_nothing(effect: Effect, run: Scene) -> None:
    absent = np.array([p.absent for p in effect.parameters(run)])
    w = run.nominal
    np.testing.assert_allclose(effect.wrench(run, w, absent), w, rtol=0, atol=1e-12)


@every_effect
def test_an_effect_leaves_the_wrench_that_it_was_given_untouched(effect: Effect, run: Scene) -> None:
    w = run.nominal
    before = w.copy()
    effect.wrench(run, w, drawn(effect.parameters(run), np.random.default_rng(3)))
    np.testing.assert_array_equal(w, before)


@every_effect
def test_a_change_of_the_wrench_passes_as_it_is_where_an_effect_only_adds(effect: Effect, run: Scene) -> None:
    rng = np.random.default_rng(5)
    parameters = effect.parameters(run)
    theta = np.clip([p.absent + p.scale * rng.uniform(0.2, 1.0) for p in parameters], *np.array([(p.lower, p.upper) for p in parameters]).T)
    change = 0.3 * rng.normal(size=run.nominal.shape) * np.abs(run.nominal).max(axis=0)
    passed = effect.wrench(run, run.nominal + change, theta) - effect.wrench(run, run.nominal, theta)
    assert np.allclose(passed, change, rtol=0, atol=1e-9) == effect.only_adds


@every_effect
def test_bounds_contain_the_absent_value_and_scales_are_positive(effect: Effect, run: Scene) -> None:
    for p in effect.parameters(run):
        assert np.isfinite([p.lower, p.upper, p.scale, p.absent]).all(), p
        assert p.lower <= p.absent <= p.upper, p
        assert p.lower < p.upper, p
        assert p.scale > 0, p


@every_effect
def test_parameters_carry_their_units_in_their_names(effect: Effect, run: Scene) -> None:
    check_names(effect.parameters(run))


@pytest.mark.parametrize("symptom", symptoms(), ids=lambda symptom: symptom.id)
def test_symptoms_are_named_like_effects(symptom: Symptom) -> None:
    assert re.fullmatch(r"[a-z_]+", symptom.id)
    assert symptom.title.text[0].islower()
    assert not symptom.title.text.endswith(".")


def check_names(parameters: tuple[Parameter, ...]) -> None:
    """Asserts that names are unique and end with their units."""
    names = [p.name for p in parameters]
    assert len(names) == len(set(names))
    for p in parameters:
        if p.unit == "1":
            assert DIMENSIONLESS.match(p.name), p
        else:
            token = re.sub(r"[ ()]", "", p.unit).lower().replace("/", "_per_").removeprefix("1_")
            assert p.name.endswith(f"_{token}") or p.name == token, p


@every_effect
def test_the_wrench_is_finite_at_and_between_the_bounds(effect: Effect, run: Scene) -> None:
    parameters = effect.parameters(run)
    lower, upper = np.array([(p.lower, p.upper) for p in parameters]).T
    absent = np.array([p.absent for p in parameters])
    rng = np.random.default_rng(5)
    corners = [lower, upper, *(np.where(rng.random(len(lower)) < 0.5, lower, upper) for _ in range(6)), rng.uniform(lower, upper)]
    alone = [np.where(np.arange(len(lower)) == k, end, absent) for k in range(len(lower)) for end in (lower, upper)]
    w = run.nominal
    for theta in corners + alone:
        assert np.isfinite(effect.wrench(run, w, theta)).all(), theta


@every_effect
def test_a_row_depends_on_earlier_rows_only(effect: Effect, run: Scene) -> None:
    theta = drawn(effect.parameters(run), np.random.default_rng(7))
    whole = effect.wrench(run, run.nominal, theta)
    for rows in (150, 433, 700):
        part = first_rows(run, rows)
        np.testing.assert_allclose(effect.wrench(part, part.nominal, theta), whole[:rows], rtol=1e-9, atol=1e-9)


@every_effect
def test_starts_lie_within_the_bounds_and_away_from_nonsense(effect: Effect, run: Scene) -> None:
    parameters = effect.parameters(run)
    lower, upper = np.array([(p.lower, p.upper) for p in parameters]).T
    residual = np.random.default_rng(11).standard_normal((len(run), 6))
    starts = effect.starts(run, residual)
    assert starts or effect.wider_shape  # which may see no sign of itself
    for start in starts:
        assert start.shape == lower.shape
        assert (start >= lower).all(), start
        assert (start <= upper).all(), start


@every_effect
def test_a_recording_of_poses_is_either_enough_or_refused_in_words(effect: Effect, run: Scene) -> None:
    bare = poses_only(run)
    missing = effect.explain_absence(bare)
    if missing is None:
        theta = drawn(effect.parameters(bare), np.random.default_rng(13))
        assert np.isfinite(effect.wrench(bare, bare.nominal, theta)).all()
    else:
        assert len(missing.text) > 10
    assert effect.explain_absence(run) is None


@every_effect
def test_advice_is_one_sentence_for_a_person(effect: Effect, run: Scene) -> None:
    assert effect.title.text[0].islower()
    for seed in (17, 18):
        advice = effect.advice(run, drawn(effect.parameters(run), np.random.default_rng(seed))).text
        assert advice[0].isupper()
        assert advice.endswith(".")
        assert "\n" not in advice
        assert "nan" not in advice


ONE_ALONE = """
import sys
from core.effects.library import find_effect
print(find_effect("joint_elasticity").id, "core.effects.hanging" in sys.modules)
"""


def test_an_effect_is_found_by_its_name_without_loading_the_others() -> None:
    said = subprocess.run([sys.executable, "-c", ONE_ALONE], capture_output=True, text=True, check=True).stdout
    assert said.split() == ["joint_elasticity", "False"]
    assert [type(find_effect(effect.id)) for effect in library()] == [type(effect) for effect in library()]


@pytest.mark.parametrize("name", ["sensor_noise", "library", "splines", "no_such_effect", "sensor_gain.py", ""])
def test_what_is_no_effect_on_the_wrench_is_not_found(name: str) -> None:
    with pytest.raises(KeyError):
        find_effect(name)


@pytest.mark.parametrize("effect", wider_shapes(), ids=lambda effect: type(effect).__name__)
def test_a_richer_shape_is_of_its_run_so_that_no_twin_takes_it_for_the_plain_one(effect: Effect, run: Scene) -> None:
    assert effect.explain_tie_to_run(run) is not None
