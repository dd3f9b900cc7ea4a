"""The payload from the torques of the joints: of one recording with the arm's model, or beside a recording of the same arm without it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.array import Array
from core.estimation.budget import Budget, Source
from core.estimation.consistency import NO_SUCH_BODY, distance_from_bodies, nearest_consistent
from core.estimation.determination import find_determined, reasons, scales
from core.estimation.estimate import Bools, DriftEstimate, Estimate, Identification, JointTorque, PaperEstimate, TimeSeries
from core.estimation.joint_torques.arm_prior import ASSUMED_LINK_STD, link_modes
from core.estimation.joint_torques.fit import TorqueFit, TorqueSolver
from core.estimation.joint_torques.torque_regressor import TorqueRegressor
from core.estimation.joint_torques.torque_scale import LEAST, MOST, find_scale
from core.estimation.joint_torques.unknowns import Recorded, TorqueModel
from core.estimation.joint_torques.windows import TorqueWindows, cut_into_windows
from core.estimation.kinematics import poses_of, smooth_motion
from core.estimation.segments import Segment, cut_at_gaps, segments_of_motion, segments_of_phase
from core.estimation.verdict import verdict_of
from core.payload.inertia import PHI_NAMES, InertialParameters, Motion, is_consistent
from core.payload.known_tool import add_tools
from core.recording.recording import Recording, check_arm_alone
from core.robot.model import RobotModel
from core.words.message import Message

ASSUMED_GAIN_STD = 0.08
"""Relative standard uncertainty of a torque whose sensor or motor constant nobody has stated."""
SMOOTHING_S = 0.05
INTERVAL = 1.96
GAIN_SEEN = 2.5
"""Standard uncertainties by which a gain is off before something is said."""
ARM_OFF = 9.0
"""Strength of the links' errors from which something is said: three times what is stated."""
DELAY_SEEN_S = 5e-3
MANY_OUTLYING = 0.05
FEWEST_ROWS = 20
"""Windows of a joint below which it hardly counts, and is named."""
AS_THE_ARM = 0.2
"""Of the load that asks as much of the joints as the arm itself: what a mass must be known to where there may be none at all."""


@dataclass(frozen=True)
class _Seen:
    """What the fit is turned into an answer with."""

    model: TorqueModel
    fit: TorqueFit
    names: tuple[str, ...]


def identify_by_torques(loaded: Recording, empty: Recording | None = None) -> Identification:
    """Identifies what the sensor's frame carries from joint positions and torques.

    Args:
        loaded: with the payload; only read.
        empty: of the same arm without it, the motion may be another; its tools, if it names any, count as known.

    Raises:
        BadRecording: the recordings are of different robots, or the one without payload has no torques.
    """
    if empty is not None:
        check_arm_alone(empty, loaded.robot, loaded.gravity)
    why = _explain_lack(loaded, empty)
    if why is not None:
        return _nothing(why)
    assert loaded.robot is not None
    robot = RobotModel(loaded.robot)
    pairs = [(loaded, True)] if empty is None else [(loaded, True), (empty, False)]
    windows = [cut_into_windows(recording, robot) for recording, _ in pairs]
    if any(each is None for each in windows):
        return _nothing(Message.of("torques-too-short"))
    if not any(each.usable.any() for each in windows if each is not None):
        return _nothing(Message.of("torques-nothing-turns"))
    model = _model(robot, loaded, [(r, carries, w) for (r, carries), w in zip(pairs, windows, strict=True) if w is not None])
    scale = find_scale(model.recorded, model.nominal_links.reshape(-1, 10)) if _states_all_masses(model) else None
    if scale is not None and not LEAST < scale < MOST:
        return _nothing(Message.of("torques-other-scale", scale=scale))
    return _answer(_Seen(model, TorqueSolver(model).solve(), loaded.robot.joints), loaded, empty)


def _states_all_masses(model: TorqueModel) -> bool:
    return bool((model.nominal_links.reshape(-1, 10)[:, 0] > 0.0).all())


def _explain_lack(loaded: Recording, empty: Recording | None) -> Message | None:
    """Why nothing can be told from the torques; None where something can."""
    if loaded.tau is None:
        return Message.of("torques-no-torques")
    if loaded.q is None or loaded.robot is None:
        return Message.of("torques-no-joints")
    links = TorqueRegressor(RobotModel(loaded.robot), loaded.gravity).links
    massless = [name for name, link in zip(loaded.robot.joints, links, strict=True) if link[0] <= 0.0]
    if empty is None and massless:
        return Message.of("torques-arm-unknown", joints=massless)
    return None


def _model(robot: RobotModel, loaded: Recording, parts: list[tuple[Recording, bool, TorqueWindows]]) -> TorqueModel:
    links = TorqueRegressor(robot, loaded.gravity).links
    link_std = ASSUMED_LINK_STD if loaded.link_mass_std is None else loaded.link_mass_std
    gain_std = ASSUMED_GAIN_STD if loaded.torque_gain_std is None else loaded.torque_gain_std
    recorded = [Recorded(windows, carries, np.zeros(10) if carries else _tools_of(recording)) for recording, carries, windows in parts]
    effort = np.array(robot.model.effortLimit)
    return TorqueModel(recorded, links, link_modes(links, max(link_std, 1e-6)), np.full(robot.n, max(gain_std, 1e-6)), effort)


def _tools_of(empty: Recording) -> Array:
    return np.asarray(add_tools(empty.tools, InertialParameters(np.zeros(10))).phi) if empty.tools else np.zeros(10)


def _answer(seen: _Seen, loaded: Recording, empty: Recording | None) -> Identification:
    motion, segments = _motion(loaded)
    estimate = _estimate(seen, loaded, motion)
    nothing_seen = bool(estimate.determined[0]) and _is_none(seen)
    verdict = _verdict(estimate, nothing_seen)
    said = [*_warnings(seen, empty), *([Message.of("estimation-no-such-body")] if estimate.constrained else [])]
    nan = np.full(10, np.nan)
    paper = PaperEstimate(nan, nan, np.full(6, np.nan))
    return Identification(paper, estimate, verdict, tuple(said), segments, joints=_joints(seen), drawn=lambda: TimeSeries(loaded.t, motion))


def _is_none(seen: _Seen) -> bool:
    """Whether the mass is compatible with none."""
    fit = seen.fit
    variance = fit.repeatability[0, 0] + sum(float(part[0] @ part[0]) for part in fit.directions.values())
    return bool(fit.phi[0] < INTERVAL * np.sqrt(variance))


def _estimate(seen: _Seen, loaded: Recording, motion: Motion) -> Estimate:
    fit = seen.fit
    stated = {"torque_gain": loaded.torque_gain_std is not None, "arm_model": loaded.link_mass_std is not None}
    sources = tuple(Source(name, stated[name], part) for name, part in fit.directions.items())
    budget = Budget(fit.repeatability, sources)
    phi, S = fit.phi.copy(), budget.covariance
    std = np.sqrt(np.maximum(np.diag(budget.repeatability), 0.0))
    none = _is_none(seen)
    known = _find_known_of_none(seen, std) if none else find_determined(phi, std)
    body = phi if none or not known[0] else nearest_consistent(phi, S)
    constrained = distance_from_bodies(phi, body, S) > NO_SUCH_BODY if body is not phi else False
    phi = body.copy()
    why = reasons(phi, std, known, static=False, motion=motion)
    why |= _explain_static(phi, std, known)
    if none and known[0]:
        why |= {name: Message.of("torques-no-payload") for name in why}
    phi[~known] = np.nan
    S[~known, :] = np.nan
    S[:, ~known] = np.nan
    six = np.full(6, np.nan)
    late = abs(float(fit.late_s[0])) > DELAY_SEEN_S
    return Estimate(
        phi,
        S,
        known,
        why,
        budget=budget,
        offset=six,
        offset_std=six,
        converged=fit.converged,
        consistent=is_consistent(body),
        constrained=constrained,
        residual_rms=six,
        noise_std=six,
        drift=DriftEstimate(np.zeros(0), np.zeros((0, 6)), np.zeros(6)),
        delay_s=float(fit.late_s[0]) if late else None,
        delay_std=float(fit.late_std_s[0]) if late else None,
    )


def _explain_static(phi: Array, std: Array, known: Bools) -> dict[str, Message]:
    """Why mass and first moment are not determined, those that are not: no offset of a sensor is in the way here."""
    size = scales(phi)
    why = {} if known[0] else {"m": Message.of("torques-mass-uncertain", std_kg=float(std[0]), scale_kg=float(size[0]))}
    for k, axis in enumerate("xyz", start=1):
        if not known[k]:
            said = Message.of("torques-first-moment-uncertain", axis=axis, std_kg_m=float(std[k]), scale_kg_m=float(size[k]))
            why[PHI_NAMES[k]] = said
    return why


def _find_known_of_none(seen: _Seen, std: Array) -> Bools:
    """(10,): mass and first moment, where what is not there is known well: in comparison with what the arm itself asks of the joints."""
    model = seen.model
    windows = model.recorded[0].windows
    n = model.n
    arm = windows.Y[:, :, : 10 * n] @ model.nominal_links
    load = windows.Y[:, :, 10 * n]
    used = windows.usable
    equal_kg = float(np.sqrt((arm[used] ** 2).sum() / max(float((load[used] ** 2).sum()), 1e-12)))
    least = AS_THE_ARM * equal_kg
    known = np.zeros(10, dtype=bool)
    known[:4] = std[:4] < least * np.concatenate(([1.0], scales(np.concatenate(([1.0], np.zeros(9))))[1:4] * 4.0))
    return np.asarray(known & known[0])


def _verdict(estimate: Estimate, nothing_seen: bool) -> Message:
    if nothing_seen:
        mass, half = float(estimate.phi[0]), INTERVAL * float(estimate.std[0])
        return Message.of("torques-no-payload-seen", mass_kg=mass, half_width_kg=half)
    return verdict_of(estimate, static=False)


def _warnings(seen: _Seen, empty: Recording | None) -> list[Message]:
    fit, model = seen.fit, seen.model
    said = []
    if not fit.converged:
        said.append(Message.of("estimation-not-converged"))
    if empty is None:
        said.append(Message.of("torques-arm-by-urdf"))
        strength = max(fit.strengths[name] for name in ("link_mass", "link_centre"))
        if strength > ARM_OFF:
            said.append(Message.of("torques-arm-off", times=float(np.sqrt(strength))))
    idle = [name for name, count in zip(seen.names, fit.rows, strict=True) if count < FEWEST_ROWS]
    if idle:
        said.append(Message.of("torques-joints-idle", joints=idle))
    own = model.groups["torque_gain"].rows
    for k, name in enumerate(seen.names):
        if abs(fit.b[own.start + k]) > GAIN_SEEN:
            said.append(Message.of("torques-gain-off", joint=name, share=float(model.gains(fit.b)[k])))
    if fit.outlying > MANY_OUTLYING:
        said.append(Message.of("torques-outlying", share=fit.outlying))
    worst = int(np.argmax(np.abs(fit.late_s)))
    if abs(fit.late_s[worst]) > DELAY_SEEN_S:
        said.append(Message.of("torques-late", late_s=float(fit.late_s[worst]), half_width_s=INTERVAL * float(fit.late_std_s[worst])))
    return said


def _joints(seen: _Seen) -> tuple[JointTorque, ...]:
    """What was found of each joint."""
    fit, model = seen.fit, seen.model
    friction, gains, stds = model.friction(fit.b), model.gains(fit.b), model.gain_stds(fit.covariance)
    return tuple(
        JointTorque(
            name,
            coulomb_n_m=float(friction[0, k]),
            viscous_n_m_s=float(friction[1, k]),
            gain=float(gains[k]),
            gain_std=float(stds[k]),
            residual_n_m=float(fit.residual[k]),
            windows=fit.rows[k],
        )
        for k, name in enumerate(seen.names)
    )


def _motion(recording: Recording) -> tuple[Motion, tuple[Segment, ...]]:
    poses = poses_of(recording)
    assert poses is not None
    motion, speed = smooth_motion(poses, window_s=SMOOTHING_S)
    if recording.phase is not None:
        return motion, cut_at_gaps(segments_of_phase(recording.phase), recording.t)
    return motion, segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))


def _nothing(why: Message) -> Identification:
    nan = np.full(10, np.nan)
    paper = PaperEstimate(nan, nan, np.full(6, np.nan))
    verdict = Message.of("estimation-nothing-determined", reason=why)
    return Identification(paper, None, verdict, (Message.of("torques-needed"),))
