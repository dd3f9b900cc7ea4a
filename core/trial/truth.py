"""The truth in the words of the diagnosis: a fault's parameters as those of the effect that models it, and the payload that was there.

Only faults whose shape is the model's shape have such parameters. Faults are given in the plant's conventions (body and site frames of
the mechanism, sampled filters); both sides of every line of the table are held together by tests that let the one act and ask the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias

import mujoco
import numpy as np

from core.array import Array
from core.cell.cell import Cell
from core.effects.channels import SUFFIXES
from core.payload.channels import CHANNELS
from core.payload.inertia import PHI_NAMES, PHI_UNITS, InertialParameters
from core.plant.arm import arm_of_cell
from core.plant.faults import Fault, Setting
from core.plant.links import Links
from core.plant.mechanics import PERIOD, Drives, build_spec

Truth: TypeAlias = dict[str, Any]
Parameters: TypeAlias = dict[str, float]

MINUTE_S = 60.0


def translate_truth(name: str, variant: str, truth: Truth, setting: Setting) -> Parameters:
    """An effect's parameters by name, as the fault has them; empty where the fault has another shape than the model.

    Args:
        name, variant, truth: of the fault, as sealed.
        setting: where it was planted.
    """
    told = TOLD.get((name, variant))
    return {} if told is None else told(truth, setting)


def name_by_channel(values: list[float], what: str) -> Parameters:
    """`fx_<what>` and so on."""
    return {f"{channel}_{what}": value for channel, value in zip(CHANNELS, values, strict=True)}


def name_amplitudes(values: list[float], what: str) -> Parameters:
    """`fx_<what>_n` to `tz_<what>_nm`."""
    return {f"{c}_{what}_{suffix}": value for c, suffix, value in zip(CHANNELS, SUFFIXES, values, strict=True)}


def name_by_axis(values: list[float], before: str, after: str) -> Parameters:
    """One parameter for each axis."""
    return {f"{before}{axis}{after}": value for axis, value in zip("xyz", values, strict=False)}


def joints(values: list[float]) -> Parameters:
    """`joint_1_rad` and so on."""
    return {f"joint_{j + 1}_rad": value for j, value in enumerate(values)}


def lag(time_constant_s: float) -> float:
    """How late a low-pass of first order that is sampled each period is for slow signals, s: half a period less than its time constant."""
    return PERIOD / math.expm1(PERIOD / time_constant_s)


def _butterworth(truth: Truth, _: Setting) -> Parameters:
    if truth["cut_off_hz"] * PERIOD > 0.45:
        return {}
    time_constant = PERIOD / (math.sqrt(2.0) * math.tan(math.pi * truth["cut_off_hz"] * PERIOD))
    return {"time_constant_s": time_constant, "second_order_share": 0.5}


def _exponential_drift(truth: Truth, _: Setting) -> Parameters:
    share = -math.expm1(-MINUTE_S / truth["time_constant_s"])
    minute = name_amplitudes([share * drift for drift in truth["drift_wrench"]], "first_minute")
    return {**minute, "settling_rate_per_s": 1.0 / truth["time_constant_s"]}


def _linear_drift(truth: Truth, _: Setting) -> Parameters:
    minute = name_amplitudes([MINUTE_S / truth["duration_s"] * drift for drift in truth["drift_wrench"]], "first_minute")
    return {**minute, "settling_rate_per_s": 0.0}


def _crosstalk(truth: Truth, _: Setting) -> Parameters:
    return {
        f"{CHANNELS[i]}_from_{CHANNELS[j]}_{SUFFIXES[i]}_per_{SUFFIXES[j]}": truth["coupling"][i][j]
        for i in range(6)
        for j in range(6)
        if i != j
    }


def _mass_step(truth: Truth, _: Setting) -> Parameters:
    return {"at_s": truth["begin_s"], "mass_kg": truth["change_kg"], **name_by_axis(truth["at_m"], "place_", "_m")}


def _slip(truth: Truth, setting: Setting) -> Parameters:
    part = truth["part_share"] * setting.payload.mass
    return {"at_s": truth["at_s"], **name_by_axis([part * shift for shift in truth["shift_m"]], "first_moment_", "_kgm")}


TOLD: dict[tuple[str, str], Callable[[Truth, Setting], Parameters]] = {
    ("time_delay", "constant"): lambda t, _: {"delay_s": t["delay_s"]},
    ("kinematic_lag", "first_order"): lambda t, _: {"lag_s": lag(t["lag_s"])},
    ("sensor_lowpass", "first_order"): lambda t, _: {"time_constant_s": lag(0.5 / (math.pi * t["cut_off_hz"])), "second_order_share": 0.0},
    ("sensor_lowpass", "second_order"): _butterworth,
    ("sensor_gain", "linear"): lambda t, _: name_by_channel(t["gain_share"], "gain_error_share"),
    ("sensor_nonlinearity", "quadratic"): lambda t, _: name_by_channel(t["share_of_range"], "full_scale_error_share"),
    ("sensor_crosstalk", "linear"): _crosstalk,
    ("sensor_drift", "exponential"): _exponential_drift,
    ("sensor_drift", "linear"): _linear_drift,
    ("sensor_offset_step", "step"): lambda t, _: name_amplitudes(t["step_wrench"], "step"),
    ("sensor_creep", "exponential"): lambda t, _: {
        **name_by_channel([t["creep_share"]] * 6, "creep_share"),
        "time_constant_s": lag(t["time_constant_s"][0]),
    },
    ("sensor_rotation", "sensor_alone"): lambda t, _: name_by_axis(t["rotation_rad"], "about_", "_rad"),
    ("sensor_rotation", "with_payload"): lambda t, _: name_by_axis(t["rotation_rad"], "about_", "_rad"),
    ("sensor_translation", "sensor_alone"): lambda t, _: name_by_axis(t["translation_m"], "", "_m"),
    ("sensor_translation", "with_payload"): lambda t, _: name_by_axis(t["translation_m"], "", "_m"),
    ("base_tilt", "fixed"): lambda t, _: name_by_axis(t["tilt_rad"], "about_", "_rad"),
    ("joint_offset", "fixed"): lambda t, _: joints(t["offset_rad"]),
    ("payload_mass_change", "step"): _mass_step,
    ("payload_shift", "step"): _slip,
    ("sensor_noise", "white"): lambda t, _: name_by_channel([t["factor"]] * 6, "noise_factor"),
    ("sensor_interference", "sine"): lambda t, _: {
        "frequency_hz": t["frequency_hz"],
        **name_amplitudes(t["amplitude_wrench"], "amplitude"),
    },
    ("sensor_quantization", "rounded"): lambda t, _: name_amplitudes(t["step_wrench"], "step"),
    ("sample_dropout", "held"): lambda t, _: {"held_share": t["lost_share"]},
    ("sample_dropout", "slow_rate"): lambda t, _: {"held_share": 1.0 - 1.0 / t["every"]},
}
"""Identifier and variant of a fault to the parameters of the effect with that identifier."""


def difference_of(payload: Array, nominal: Array) -> Parameters:
    """Parameters of `payload_mismatch`: payload less reference, (10,) each."""
    suffixes = {"kg": "kg", "kg m": "kgm", "kg m2": "kgm2"}
    return {
        f"{name.lower()}_difference_{suffixes[unit]}": float(value)
        for name, unit, value in zip(PHI_NAMES, PHI_UNITS, payload - nominal, strict=True)
    }


def true_payload_of(cell: Cell, nominal: InertialParameters, faults: tuple[Fault, ...]) -> InertialParameters:
    """What the wrist sensor carries when the run begins, in its true axes about its true origin: what an ideal identification finds.

    A fault may have made the payload another one, or may have turned or shifted the sensor against it; what slips, falls off or is put
    on later is as it was at the start. Loose parts count where their springs are relaxed, or at the point from which they hang: that is
    where their weight acts, and what effects take them from.

    Args:
        nominal: the payload as the cell has it, sensor frame.
    """
    arm = arm_of_cell(cell)
    links = Links(arm, build_spec(arm, nominal, cell.gravity, Drives()), Setting(cell, nominal), faults)
    links.rest(np.array(cell.robot.home_rad))
    model, data = links.machine.model, links.machine.data
    loose = model.jnt_bodyid >= links.machine.body("payload")
    for start, kind in zip(model.jnt_qposadr[loose], model.jnt_type[loose], strict=True):
        place = slice(start, start + (4 if kind == mujoco.mjtJoint.mjJNT_BALL else 1))
        data.qpos[place] = model.qpos0[place]
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    site = data.site("ft")
    R, origin = site.xmat.reshape(3, 3), site.xpos
    phi = np.zeros(10)
    for body in _hanging_on(model, links.machine.body("payload")):
        axes = R.T @ data.ximat[body].reshape(3, 3)
        inertia, place = axes @ np.diag(model.body_inertia[body]) @ axes.T, data.xipos[body]
        if model.body_jntnum[body] and model.jnt_type[model.body_jntadr[body]] == mujoco.mjtJoint.mjJNT_BALL:  # turns nothing
            inertia, place = np.zeros((3, 3)), data.xpos[body]
        phi += InertialParameters.from_com(float(model.body_mass[body]), R.T @ (place - origin), inertia).phi
    return InertialParameters(phi)


def _hanging_on(model: mujoco.MjModel, root: int) -> list[int]:
    """A body with all that it carries; MuJoCo numbers children after their parents."""
    found = [root]
    for body in range(root + 1, model.nbody):
        if int(model.body_parentid[body]) in found:
            found.append(body)
    return found
