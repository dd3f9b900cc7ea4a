"""What a parameter of an effect is called: `joint_3_gear_ratio` is "joint 3 gear ratio". Its unit, the end of its name, is left out."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import reduce

from core.words.message import Message

UNIT = re.compile(r"(_(rad|s|m|n|nm|nms|kg|kgm|kgm2|hz|share))?_per_\w+$|_(rad|s|m|n|nm|nms|kg|kgm|kgm2|hz|share)$")
NAME = re.compile(
    r"(?:([ft][xyz]|joint_\d+|bridge_\d+|mode_\d+|jump_\d+|knot_\d+|m|mc_[xyz]|i[xyz]{2})(?:_|$))?(.*?)(?:(?:^|_)([xyz]{1,2}|[ft][xyz]))?$"
)
"""Of what it is, what it is, and along which axis or from which channel."""

NUMBERED = {
    "bridge": Message.of("effect-parameter-bridge"),
    "joint": Message.of("effect-parameter-joint"),
    "jump": Message.of("effect-parameter-jump"),
    "knot": Message.of("effect-parameter-knot"),
    "mode": Message.of("effect-parameter-mode"),
}
PIECES = {
    "about": Message.of("effect-parameter-about"),
    "acceleration": Message.of("effect-parameter-acceleration"),
    "amplitude": Message.of("effect-parameter-amplitude"),
    "asymmetry": Message.of("effect-parameter-asymmetry"),
    "at": Message.of("effect-parameter-at"),
    "contact_torque": Message.of("effect-parameter-contact-torque"),
    "corner": Message.of("effect-parameter-corner"),
    "correlation": Message.of("effect-parameter-correlation"),
    "cos": Message.of("effect-parameter-cos"),
    "coulomb": Message.of("effect-parameter-coulomb"),
    "creep": Message.of("effect-parameter-creep"),
    "crossing": Message.of("effect-parameter-crossing"),
    "cycle": Message.of("effect-parameter-cycle"),
    "damping_ratio": Message.of("effect-parameter-damping-ratio"),
    "delay": Message.of("effect-parameter-delay"),
    "difference": Message.of("effect-parameter-difference"),
    "direct": Message.of("effect-parameter-direct"),
    "drag": Message.of("effect-parameter-drag"),
    "duration": Message.of("effect-parameter-duration"),
    "first_minute": Message.of("effect-parameter-first-minute"),
    "first_moment": Message.of("effect-parameter-first-moment"),
    "force": Message.of("effect-parameter-force"),
    "force_change": Message.of("effect-parameter-force-change"),
    "frequency": Message.of("effect-parameter-frequency"),
    "friction": Message.of("effect-parameter-friction"),
    "from": Message.of("effect-parameter-from"),
    "from_fx_times": Message.of("effect-parameter-from-fx-times"),
    "from_fy_times": Message.of("effect-parameter-from-fy-times"),
    "from_fz_times": Message.of("effect-parameter-from-fz-times"),
    "from_tx_times": Message.of("effect-parameter-from-tx-times"),
    "from_ty_times": Message.of("effect-parameter-from-ty-times"),
    "from_tz_times": Message.of("effect-parameter-from-tz-times"),
    "full_scale_error": Message.of("effect-parameter-full-scale-error"),
    "gain_change": Message.of("effect-parameter-gain-change"),
    "gain_error": Message.of("effect-parameter-gain-error"),
    "gear_ratio": Message.of("effect-parameter-gear-ratio"),
    "grip": Message.of("effect-parameter-grip"),
    "growth": Message.of("effect-parameter-growth"),
    "guide_friction": Message.of("effect-parameter-guide-friction"),
    "half_width": Message.of("effect-parameter-half-width"),
    "halving_speed": Message.of("effect-parameter-halving-speed"),
    "hanging": Message.of("effect-parameter-hanging"),
    "held": Message.of("effect-parameter-held"),
    "holding_load": Message.of("effect-parameter-holding-load"),
    "holding_torque": Message.of("effect-parameter-holding-torque"),
    "hot": Message.of("effect-parameter-hot"),
    "kept": Message.of("effect-parameter-kept"),
    "knee": Message.of("effect-parameter-knee"),
    "lag": Message.of("effect-parameter-lag"),
    "lag_at_rest": Message.of("effect-parameter-lag-at-rest"),
    "lean": Message.of("effect-parameter-lean"),
    "loop_roundness": Message.of("effect-parameter-loop-roundness"),
    "loop_start": Message.of("effect-parameter-loop-start"),
    "lifted": Message.of("effect-parameter-lifted"),
    "lost": Message.of("effect-parameter-lost"),
    "lower_limit": Message.of("effect-parameter-lower-limit"),
    "mass": Message.of("effect-parameter-mass"),
    "moving": Message.of("effect-parameter-moving"),
    "noise_factor": Message.of("effect-parameter-noise-factor"),
    "offset": Message.of("effect-parameter-offset"),
    "of_first": Message.of("effect-parameter-of-first"),
    "opening_factor": Message.of("effect-parameter-opening-factor"),
    "over": Message.of("effect-parameter-over"),
    "overtone_cos": Message.of("effect-parameter-overtone-cos"),
    "overtone_sin": Message.of("effect-parameter-overtone-sin"),
    "phase": Message.of("effect-parameter-phase"),
    "place": Message.of("effect-parameter-place"),
    "pull": Message.of("effect-parameter-pull"),
    "recovery": Message.of("effect-parameter-recovery"),
    "rectification": Message.of("effect-parameter-rectification"),
    "remaining": Message.of("effect-parameter-remaining"),
    "rest": Message.of("effect-parameter-rest"),
    "rubbing_speed": Message.of("effect-parameter-rubbing-speed"),
    "second_degree": Message.of("effect-parameter-second-degree"),
    "second_order": Message.of("effect-parameter-second-order"),
    "settling_rate": Message.of("effect-parameter-settling-rate"),
    "settling_time": Message.of("effect-parameter-settling-time"),
    "sin": Message.of("effect-parameter-sin"),
    "sink": Message.of("effect-parameter-sink"),
    "slack": Message.of("effect-parameter-slack"),
    "slip": Message.of("effect-parameter-slip"),
    "slope_change": Message.of("effect-parameter-slope-change"),
    "slope_error": Message.of("effect-parameter-slope-error"),
    "smoothing": Message.of("effect-parameter-smoothing"),
    "split": Message.of("effect-parameter-split"),
    "start": Message.of("effect-parameter-start"),
    "start_rate": Message.of("effect-parameter-start-rate"),
    "step": Message.of("effect-parameter-step"),
    "step_time": Message.of("effect-parameter-step-time"),
    "stiffness": Message.of("effect-parameter-stiffness"),
    "stiffer_after_turn": Message.of("effect-parameter-stiffer-after-turn"),
    "stiffer_under_load": Message.of("effect-parameter-stiffer-under-load"),
    "stop": Message.of("effect-parameter-stop"),
    "stop_back": Message.of("effect-parameter-stop-back"),
    "stop_forth": Message.of("effect-parameter-stop-forth"),
    "swing": Message.of("effect-parameter-swing"),
    "swinging_inertia": Message.of("effect-parameter-swinging-inertia"),
    "taper": Message.of("effect-parameter-taper"),
    "ten_minutes_ratio": Message.of("effect-parameter-ten-minutes-ratio"),
    "third_degree": Message.of("effect-parameter-third-degree"),
    "time_constant": Message.of("effect-parameter-time-constant"),
    "torque_offset": Message.of("effect-parameter-torque-offset"),
    "turn_back": Message.of("effect-parameter-turn-back"),
    "turn_cos": Message.of("effect-parameter-turn-cos"),
    "turn_sin": Message.of("effect-parameter-turn-sin"),
    "turning_load_log_ratio": Message.of("effect-parameter-turning-load-log-ratio"),
    "turning_spread_log_ratio": Message.of("effect-parameter-turning-spread-log-ratio"),
    "twist_cube": Message.of("effect-parameter-twist-cube"),
    "twist_friction": Message.of("effect-parameter-twist-friction"),
    "twist_linear": Message.of("effect-parameter-twist-linear"),
    "twist_square": Message.of("effect-parameter-twist-square"),
    "upper_limit": Message.of("effect-parameter-upper-limit"),
    "viscous": Message.of("effect-parameter-viscous"),
    "wall": Message.of("effect-parameter-wall"),
    "wind_up": Message.of("effect-parameter-wind-up"),
    "winding_friction": Message.of("effect-parameter-winding-friction"),
    "yield": Message.of("effect-parameter-yield"),
}


def find_title(name: str) -> Message:
    """The title of the parameter of this name; a piece that is not known is said as it is."""
    return reduce(lambda first, then: Message.of("effect-parameter-part", first=first, then=then), _split(name))


def _split(name: str) -> Iterator[Message]:
    match = NAME.match(UNIT.sub("", name))
    of, what, axis = match.groups(default="") if match else ("", name, "")
    kind, _, index = of.partition("_")
    if kind in NUMBERED:
        yield NUMBERED[kind]
        yield Message.of("text", text=index)
    elif of:
        yield Message.of("text", text=of.replace("_", " "))
    if what or not (of or axis):
        yield PIECES.get(what) or Message.of("text", text=(what or name).replace("_", " "))
    if axis:
        yield Message.of("text", text=axis)
