"""The parameters of effects in words and everyday units."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping

from core.gap.answer import Value
from core.report.rows import round_to_uncertainty
from core.words.wording import ENGLISH, Wording

SHOWN = 6
"""Of one effect; a cross-talk has thirty."""
UNIT_SUFFIX = re.compile(r"(_(rad|s|m|n|nm|nms|kg|kgm|kgm2|hz|share))?_per_\w+$|_(rad|s|m|n|nm|nms|kg|kgm|kgm2|hz|share)$")
PIECES = re.compile(
    r"^(?:([ft][xyz]|m|mc_[xyz]|i[xyz]{2}|joint_\d+|bridge_\d+|jump_\d+|mode_\d+)(?:_|$))?(.*?)(?:(?:^|_)([xyz]{1,2}|[ft][xyz]))?$"
)
"""A name without its unit: what it belongs to, what it is of, along which axis or from which channel."""
SCALES = {"rad": (math.degrees(1.0), "°"), "m": (1e3, "mm"), "rad/(N m)": (1e3, "mrad/(N m)")}
SMALL = {"s": "ms", "kg": "g", "kg m": "g m", "kg m2": "g m²"}
"""Units that become a thousandth below 1."""
CODES = {
    "about": "report-of-about",
    "acceleration": "report-of-acceleration",
    "amplitude": "report-of-amplitude",
    "asymmetry": "report-of-asymmetry",
    "at": "report-of-at",
    "bridge": "report-of-bridge",
    "contact_torque": "report-of-contact-torque",
    "corner": "report-of-corner",
    "correlation": "report-of-correlation",
    "cos": "report-of-cos",
    "coulomb": "report-of-coulomb",
    "creep": "report-of-creep",
    "crossing": "report-of-crossing",
    "cycle": "report-of-cycle",
    "damping_ratio": "report-of-damping-ratio",
    "delay": "report-of-delay",
    "difference": "report-of-difference",
    "direct": "report-of-direct",
    "drag": "report-of-drag",
    "drift": "report-of-drift",
    "duration": "report-of-duration",
    "first_minute": "report-of-first-minute",
    "first_moment": "report-of-first-moment",
    "force": "report-of-force",
    "force_change": "report-of-force-change",
    "frequency": "report-of-frequency",
    "friction": "report-of-friction",
    "from": "report-of-from",
    "from_fx_times": "report-of-from-fx-times",
    "from_fy_times": "report-of-from-fy-times",
    "from_fz_times": "report-of-from-fz-times",
    "from_tx_times": "report-of-from-tx-times",
    "from_ty_times": "report-of-from-ty-times",
    "from_tz_times": "report-of-from-tz-times",
    "full_scale_error": "report-of-full-scale-error",
    "gain_change": "report-of-gain-change",
    "gain_error": "report-of-gain-error",
    "gear_ratio": "report-of-gear-ratio",
    "grip": "report-of-grip",
    "growth": "report-of-growth",
    "guide_friction": "report-of-guide-friction",
    "half_width": "report-of-half-width",
    "halving_speed": "report-of-halving-speed",
    "hanging": "report-of-hanging",
    "held": "report-of-held",
    "holding_load": "report-of-holding-load",
    "holding_torque": "report-of-holding-torque",
    "joint": "report-of-joint",
    "jump": "report-of-jump",
    "hot": "report-of-hot",
    "kept": "report-of-kept",
    "knee": "report-of-knee",
    "lag": "report-of-lag",
    "lag_at_rest": "report-of-lag-at-rest",
    "lean": "report-of-lean",
    "loop_roundness": "report-of-loop-roundness",
    "loop_start": "report-of-loop-start",
    "lifted": "report-of-lifted",
    "lost": "report-of-lost",
    "lower_limit": "report-of-lower-limit",
    "mass": "report-of-mass",
    "mode": "report-of-mode",
    "moving": "report-of-moving",
    "noise_factor": "report-of-noise-factor",
    "offset": "report-of-offset",
    "of_first": "report-of-of-first",
    "opening_factor": "report-of-opening-factor",
    "over": "report-of-over",
    "overtone_cos": "report-of-overtone-cos",
    "overtone_sin": "report-of-overtone-sin",
    "phase": "report-of-phase",
    "place": "report-of-place",
    "pull": "report-of-pull",
    "recovery": "report-of-recovery",
    "rectification": "report-of-rectification",
    "remaining": "report-of-remaining",
    "rest": "report-of-rest",
    "rubbing_speed": "report-of-rubbing-speed",
    "second_degree": "report-of-second-degree",
    "second_order": "report-of-second-order",
    "settling_rate": "report-of-settling-rate",
    "settling_time": "report-of-settling-time",
    "sin": "report-of-sin",
    "sink": "report-of-sink",
    "slack": "report-of-slack",
    "slip": "report-of-slip",
    "slope_change": "report-of-slope-change",
    "slope_error": "report-of-slope-error",
    "smoothing": "report-of-smoothing",
    "split": "report-of-split",
    "start": "report-of-start",
    "start_rate": "report-of-start-rate",
    "step": "report-of-step",
    "step_time": "report-of-step-time",
    "stiffness": "report-of-stiffness",
    "stiffer_after_turn": "report-of-stiffer-after-turn",
    "stiffer_under_load": "report-of-stiffer-under-load",
    "stop": "report-of-stop",
    "stop_back": "report-of-stop-back",
    "stop_forth": "report-of-stop-forth",
    "swing": "report-of-swing",
    "swinging_inertia": "report-of-swinging-inertia",
    "taper": "report-of-taper",
    "ten_minutes_ratio": "report-of-ten-minutes-ratio",
    "third_degree": "report-of-third-degree",
    "time_constant": "report-of-time-constant",
    "torque_offset": "report-of-torque-offset",
    "turn_back": "report-of-turn-back",
    "turn_cos": "report-of-turn-cos",
    "turn_sin": "report-of-turn-sin",
    "turning_load_log_ratio": "report-of-turning-load-log-ratio",
    "turning_spread_log_ratio": "report-of-turning-spread-log-ratio",
    "twist_cube": "report-of-twist-cube",
    "twist_friction": "report-of-twist-friction",
    "twist_linear": "report-of-twist-linear",
    "twist_square": "report-of-twist-square",
    "upper_limit": "report-of-upper-limit",
    "viscous": "report-of-viscous",
    "wall": "report-of-wall",
    "wind_up": "report-of-wind-up",
    "winding_friction": "report-of-winding-friction",
    "yield": "report-of-yield",
}


def parameter_texts(parameters: Mapping[str, Value], words: Wording = ENGLISH) -> tuple[str, ...]:
    """The parameters in their order; of many, those that stand out most from their uncertainty."""
    names = list(parameters)
    if len(names) > SHOWN:
        clearest = sorted(names, key=lambda name: -_clearness(parameters[name]))[:SHOWN]
        names = [name for name in names if name in clearest]
    more = len(parameters) - len(names)
    told = tuple(value_text(name, parameters[name], words) for name in names)
    return (*told, words.say("report-gap-more-parameters", count=more)) if more else told


def _clearness(value: Value) -> float:
    return abs(value.value) / value.std if value.std else math.inf


def value_text(name: str, value: Value, words: Wording = ENGLISH) -> str:
    """A parameter with its uncertainty in everyday units."""
    factor, unit = _scale(name, value)
    number = round_to_uncertainty(factor * value.value, None if value.std is None else factor * value.std)
    if value.std is not None and value.std > 0:
        number += f" ± {round_to_uncertainty(factor * value.std, factor * value.std)}"
    text = f"{name_parameter(name, words)} {words.mark(number)}" + (unit if unit == "°" else f" {unit}").rstrip()
    return words.say("report-gap-at-bound", parameter=text) if value.at_bound else text


def name_parameter(name: str, words: Wording) -> str:
    """Without its unit: `joint_3_gear_ratio` is "joint 3 gear ratio"."""
    found = PIECES.match(UNIT_SUFFIX.sub("", name))
    belongs, of, axis = (found[k] or "" for k in (1, 2, 3)) if found else ("", name, "")
    part, _, index = belongs.partition("_")
    return " ".join(piece for piece in (_name_piece(part, words), index, _name_piece(of, words), axis) if piece)


def _name_piece(piece: str, words: Wording) -> str:
    return words.say(CODES[piece]) if piece in CODES else piece.replace("_", " ")


def _scale(name: str, value: Value) -> tuple[float, str]:
    if value.unit == "1":
        return (100.0, "%") if name.endswith("share") else (1.0, "")
    if value.unit in SMALL and abs(value.value) < 1.0:
        return 1e3, SMALL[value.unit]
    factor, unit = SCALES.get(value.unit, (1.0, value.unit))
    return factor, unit.replace("m2", "m²").replace("s2", "s²")
