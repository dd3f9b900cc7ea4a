"""From a recording to the answer: the paper's estimate and ours, with what can and cannot be said."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from core.array import Array, interpolate
from core.estimation.consistency import NO_SUCH_BODY, distance_from_bodies, nearest_consistent
from core.estimation.determination import find_determined, reasons
from core.estimation.estimate import DriftEstimate, Estimate, Identification, PaperEstimate, TimeSeries
from core.estimation.fit import DELAY, OFFSET, TILT
from core.estimation.gears import describe_gears, find_gears
from core.estimation.generalised_least_squares import LARGEST_DELAY_S, PRIOR_STD
from core.estimation.kinematic_filter import ALPHA_VARIANCE, filter_motion, find_pose_noise, steady_std
from core.estimation.kinematics import Poses, poses_of, smooth_motion
from core.estimation.lateness import advance_wrench, find_lateness
from core.estimation.lost_rows import is_broken
from core.estimation.noise import WrenchNoise, sensor_noise, unknown_noise
from core.estimation.nuisances import nuisances_of
from core.estimation.offset import offset_of_opposed_poses
from core.estimation.regression import Thresholds, regression
from core.estimation.resting import FEWEST_ROWS, identify_at_rest
from core.estimation.segments import Segment, cut_at_gaps, motionless, segments_of_motion, segments_of_phase
from core.estimation.setup.check import check_setup
from core.estimation.setup.refutation import refute
from core.estimation.turning import identify_by_turning
from core.estimation.twin_effects import Corrected, TwinEffects, effects_on, fit_with_effects
from core.estimation.verdict import on_transfers_alone, verdict_of, warnings_of
from core.estimation.verification import LeaveOneOut
from core.estimation.weak_form import WeakForm
from core.payload.inertia import Motion, is_consistent
from core.payload.rigid_wrench import wrench as rigid_wrench
from core.recording.held_readings import drop_repeated_rows
from core.recording.recording import Recording
from core.twin.twin import NOMINAL, Twin
from core.words.message import Message

Bools = NDArray[np.bool_]

SMOOTHING_S = 0.05
"""Window of the local cubics behind segments and charts."""
LONGEST_SWINGING_S = 200.0
"""Beyond it gears are not sought: what they do to every sample would not fit into the memory that an identification may take."""
FARTHEST_S = 0.2
"""Up to which a delay is sought on from its bound; what is later is plain beforehand."""
KNOWN_SHARE = 0.5
"""A tilt or delay whose uncertainty is above this share of its prior is not reported."""


def identify_recording(recording: Recording, twin: Twin = NOMINAL, without: Recording | None = None) -> Identification:
    """Identifies the payload of one recording, or from the joints' torques in two.

    What the recording lacks limits what is said, and is said; it is no error.

    Args:
        recording: only read.
        twin: of the cell; what its effects do to the wrench is accounted for.
        without: of the same arm without the payload; only read. The joints' torques in both tell the payload then, and no wrench.

    Raises:
        BadRecording: `without` cannot be compared with.
    """
    # the matrices are narrow: threads spend more time waiting for each other than they save
    with threadpool_limits(1, user_api="blas"):
        return _identify(recording, twin, without)


def _identify(recording: Recording, twin: Twin, without: Recording | None) -> Identification:
    if recording.wrench is None or without is not None:
        from core.estimation.joint_torques.identification import identify_by_torques  # noqa: PLC0415 - loads an optimiser

        return identify_by_torques(recording, without)

    def identify(taken: Recording) -> Identification:
        return _identify_by_wrench(taken, np.asarray(taken.wrench), twin)

    recording = drop_repeated_rows(recording)
    answer = identify_at_rest(recording, identify, identify(recording))
    if answer.estimate is not None and answer.estimate.determined[0]:
        return answer
    return identify_by_turning(recording, identify) or answer


def _identify_by_wrench(recording: Recording, wrench: Array, twin: Twin) -> Identification:
    """A delay that ends at its bound is sought on from there: what jitters is too rough for the search beforehand."""
    begun_s, answer = 0.0, _identify_late(recording, wrench, twin, 0.0)
    while (estimate := answer.estimate) is not None and not estimate.converged and estimate.delay_s is not None:
        if not abs(begun_s) + 0.5 * LARGEST_DELAY_S < abs(estimate.delay_s) < FARTHEST_S:
            break
        begun_s = estimate.delay_s
        answer = _identify_late(recording, wrench, twin, begun_s)
    return answer


def _identify_late(recording: Recording, wrench: Array, twin: Twin, begun_s: float) -> Identification:
    """
    Args:
        begun_s: by which the wrench is taken to be late to begin with; looked for where that is 0.
    """
    poses = poses_of(recording)
    if poses is None:
        return _nothing((), Message.of("estimation-no-motion"))
    static = poses.apart
    motion, speed = _motion(poses, static)
    # a twin that states a delay means the wrench as it was recorded
    late_s = 0.0 if static or "time_delay" in twin.ids else begun_s or find_lateness(recording.t, motion, wrench)
    if late_s:
        recording, late_s = advance_wrench(recording, late_s)
        poses = poses_of(recording)
        assert poses is not None and recording.wrench is not None
        wrench = recording.wrench
        motion, speed = _motion(poses, static)
    setup = check_setup(recording)
    segments = _segments(recording, motion, speed, static)
    if setup.contradiction is not None:
        return _nothing(segments, setup.contradiction)
    still = _find_labelled_still(recording, segments) if static else motionless(recording.t, segments)
    # poses by themselves show no noise: what differs between them is gravity, whatever label they have in common
    noise = sensor_noise(recording.t, wrench, still, () if static else segments, nominal_std=recording.sensor.noise_std)
    rows_only = static or (poses.position is None) or not bool((~still).any())
    if rows_only and int(still.sum()) < FEWEST_ROWS:
        return _nothing(segments, Message.of("estimation-too-few-still"))
    broken = not rows_only and is_broken(poses.t) and int(still.sum()) >= FEWEST_ROWS
    rows_only = rows_only or broken
    form = WeakForm(poses, still_only=still if rows_only else None)
    if len(form) < FEWEST_ROWS:
        return _nothing(segments, Message.of("estimation-too-short", lasts_s=float(recording.t[-1] - recording.t[0])))
    effects = effects_on(recording, poses, segments, twin, static=static) if twin.effects else None
    nuisances = nuisances_of(recording, poses.joints, twin)
    corrected = fit_with_effects(form, wrench, noise or unknown_noise(), effects, nuisances)
    swings: tuple[Message, ...] = ()
    short = float(np.ptp(recording.t)) < LONGEST_SWINGING_S
    if noise is not None and not rows_only and short and (corrected.found.scale > 1.0).any():
        along = effects or effects_on(recording, poses, segments, twin, static=False)
        gears = find_gears(poses, wrench, corrected.found, along)
        if gears is not None:
            along = TwinEffects(twin.with_entry(gears), along.scene, recording.t, static=False)
            swinging = fit_with_effects(form, wrench, noise, along, nuisances, corrected.found).without_share(gears.effect)
            if swinging.found.converged and swinging.found.misfit < corrected.found.misfit:
                corrected, swings = swinging, (describe_gears(gears),)
    del form  # of a long recording it is the largest thing there is
    found, change = corrected.found, corrected.change
    turned = None if recording.phase is None else "".join(sorted({part.axis or "" for part in segments if part.phase.startswith("rotate")}))
    estimate = _estimate(corrected, motion, late_s, static=rows_only, turned=turned)
    estimate = refute(estimate, setup.weighed)
    paper = _paper(recording, poses, wrench - change, still, found.noise, static=static)
    said = warnings_of(recording, estimate, found, static=rows_only)
    left_out = () if effects is None else _warn_of_effects_left_out(effects)
    lacking = (Message.of("estimation-motion-broken"),) if broken else ()
    warnings = (*setup.remarks, *lacking, *swings, *said, *on_transfers_alone(estimate, turned), *left_out)
    verdict = verdict_of(estimate, static=rows_only)
    answer = Identification(paper, estimate, verdict, warnings, segments, accounted=corrected.accounted, shares=corrected.shares)
    if rows_only:
        return answer
    drawn = partial(_series, poses, wrench, motion, corrected)
    return replace(answer, drawn=drawn, verified=LeaveOneOut(poses, wrench - change, found, segments).verifications)


def _warn_of_effects_left_out(effects: TwinEffects) -> list[Message]:
    return [Message.of("estimation-effect-left-out", reason=reason) for reason in effects.lacking]


def _motion(poses: Poses, static: bool) -> tuple[Motion, Array]:
    if static:
        return Motion.still(poses.g), np.zeros(len(poses.t))
    return smooth_motion(poses, window_s=SMOOTHING_S)


def _segments(recording: Recording, motion: Motion, speed: Array, static: bool) -> tuple[Segment, ...]:
    if recording.phase is not None:
        return cut_at_gaps(segments_of_phase(recording.phase), recording.t)
    if static:
        return (Segment(0, len(recording), "hold:free"),)
    return segments_of_motion(recording.t, motion.omega, speed, motion.g, threshold=np.array([0.01, 0.005]))


def _find_labelled_still(recording: Recording, segments: tuple[Segment, ...]) -> Bools:
    """Slow samples are poses of their own: every one that is labelled as a hold counts."""
    still = np.zeros(len(recording), dtype=bool)
    for part in segments:
        still[part.rows] = part.is_hold
    return still


def _estimate(corrected: Corrected, motion: Motion, late_s: float, *, static: bool, turned: str | None) -> Estimate:
    found, covariance, budget = corrected.found, corrected.covariance, corrected.budget
    phi, S = found.phi.copy(), budget.covariance
    std = np.sqrt(np.diag(budget.repeatability))  # what the recording shows; what no recording can show is in the budget
    known = find_determined(phi, std)
    body = nearest_consistent(phi, S) if known[0] else phi
    constrained = bool(known[0]) and distance_from_bodies(phi, body, S) > NO_SUCH_BODY
    phi = body.copy()
    why = reasons(phi, std, known, static=static, motion=None if static else motion, turned=turned)
    phi[~known] = np.nan
    S[~known, :] = np.nan
    S[:, ~known] = np.nan
    tilt_std, delay_std = np.sqrt(np.diag(covariance)[TILT]), float(np.sqrt(covariance[DELAY, DELAY]))
    tilt_known = bool((tilt_std < KNOWN_SHARE * PRIOR_STD[TILT]).all())
    delay_known = not static and delay_std < KNOWN_SHARE * float(PRIOR_STD[DELAY])
    rms = found.noise.std * np.sqrt(np.mean(found.whitened**2, axis=1) * found.scale)
    return Estimate(
        phi,
        S,
        known,
        why,
        budget=budget,
        offset=found.x[OFFSET],
        offset_std=np.sqrt(np.diag(covariance)[OFFSET]),
        converged=found.converged,
        consistent=is_consistent(body),
        constrained=constrained,
        residual_rms=rms,
        noise_std=found.noise.std,
        drift=DriftEstimate(found.centres, found.drift, found.drift_std),
        base_tilt_rad=found.x[TILT] if tilt_known else None,
        base_tilt_std=tilt_std if tilt_known else None,
        delay_s=late_s + float(found.x[DELAY]) if delay_known else None,
        delay_std=delay_std if delay_known else None,
    )


def _paper(recording: Recording, poses: Poses, wrench: Array, still: Bools, noise: WrenchNoise, *, static: bool) -> PaperEstimate:
    """Algorithms 1-5 on the motion of the paper's Kalman filter, its noise from the cell, thresholds from the filter's noise."""
    if static:
        motion, speed, alpha_std = Motion.still(poses.g), np.zeros(len(poses.t)), float(np.sqrt(ALPHA_VARIANCE))
    else:
        position_std, orientation_std = find_pose_noise(poses, recording.encoder_std_rad)
        motion, speed, settled = filter_motion(poses, position_std=position_std, orientation_std=orientation_std)
        motion.alpha[~settled] = 0.0
        still = still & settled
        alpha_std = float(steady_std(poses.period, position_std=position_std, orientation_std=orientation_std)[1])
    offset = offset_of_opposed_poses(motion.g[still], wrench[still]) if still.any() else np.full(6, np.nan)
    thresholds = Thresholds.of_noise(0.0, 0.0, alpha_std)
    found = regression(motion, speed, wrench, still, thresholds=thresholds, variance=noise.std**2)
    phi, std = found.parameters(offset, torque_std=noise.std[3:], alpha_std=alpha_std)
    return PaperEstimate(phi, std, offset)


def _series(poses: Poses, wrench: Array, motion: Motion, corrected: Corrected) -> TimeSeries:
    """Measured and reconstructed at the same times; the reconstruction is delayed like the measurement, and has all that was found."""
    found, t = corrected.found, poses.t
    drift, _ = found.drift_at(t)
    predicted = rigid_wrench(motion, found.phi)
    if found.nuisances is not None:
        seen, _ = smooth_motion(found.nuisances.correct(poses, found.b), window_s=SMOOTHING_S)
        load = rigid_wrench(seen, found.phi)
        predicted = load + load @ found.nuisances.reading(found.b).T
    late = interpolate(t - found.x[DELAY], t, predicted)
    return TimeSeries(t, motion, wrench - found.x[OFFSET] - drift, late + corrected.change)


def _nothing(segments: tuple[Segment, ...], why: Message) -> Identification:
    nan = np.full(10, np.nan)
    paper = PaperEstimate(nan, nan, np.full(6, np.nan))
    return Identification(paper, None, Message.of("estimation-nothing-determined", reason=why), (why,), segments)
