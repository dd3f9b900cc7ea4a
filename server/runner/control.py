"""The control process: plans, waits for its release, moves the robot, estimates. It outlives its server only until the robot stands."""

from __future__ import annotations

import gc
import os
import signal
from collections.abc import Generator
from datetime import UTC, datetime
from multiprocessing.connection import Connection

import numpy as np

from core.array import Array
from core.errors import Commanded, HeftError, Stopped
from core.events import Event, Finished, Progress, RecordingWritten, RobotStopped, drive
from core.files.whole_file import write_whole
from core.payload.inertia import InertialParameters
from core.planning.joint_torques import describe_known_load, even_load
from core.planning.plan import Plan
from core.planning.stops import Stops
from core.procedure.identify import move_and_estimate
from core.procedure.outcome import Outcome
from core.procedure.recorder import build_estimator
from core.procedure.run import Run
from core.recording.folder import read_recording
from core.recording.recording import Recording, check_arm_alone, check_same_robot
from core.report.page import write_report
from core.robot.model import RobotModel
from core.sessions.leased import Lease, LeasedSession
from core.sessions.opening import Simulation, is_simulated, open_robot_session
from core.sessions.pace import AsFastAsPossible, RealTime
from core.sessions.sample_log import SampleLog
from core.twin.file import read_twin
from core.words.catalogue import LANGUAGES
from core.words.message import Message
from server.runner.messages import Done, Failed, FromChild, Happened, MotionEnded, Order, Paced, Ready, Sampled
from server.runner.pipe import Listener, Speaker
from server.runner.planning import PlanningProcess, PlanRefused
from server.runner.priority import Priority, begin_real_time, end_real_time, take
from server.runner.run_folder import RECORDING, RESULT, lock_run_folder, name_report
from server.runner.sample_stream import SampleStream
from server.runner.served_run import DiskRecorder, LiveView, PlanningElsewhere, look_at_zones, make_end_error
from server.runner.shown_plan import build_run_plan
from server.runner.target_watching import WatchElsewhere

ChildSpeaker = Speaker[FromChild]


def main(order: Order, connection: Connection) -> None:
    """Entry point of the process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the server, which ends us in order
    watch = None if order.target is None else WatchElsewhere(order, order.target, connection)  # before there are threads, as below
    unshared = () if watch is None else (watch.connection,)
    planning = PlanningProcess(_stops_of(order), connection, *unshared)
    speaker: ChildSpeaker = Speaker(connection, Sampled)
    _lock = lock_run_folder(order.folder)  # as long as we live: who recovers the run's samples waits for it
    take(Priority.CONTROL if _waits(order) else Priority.PLANNING)  # one that never waits would take it from the server
    try:
        _carry_out(order, connection, planning, watch, speaker)
    except HeftError as error:
        speaker.tell(error.failed if isinstance(error, PlanRefused) else _report_failure(error))
    except OSError as error:
        speaker.tell(Failed("NoRoom", Message.of("runs-folder-not-writable", reason=error.strerror or "")))
    finally:
        speaker.close()
        planning.close()
        if watch is not None:
            watch.close()
        os._exit(0)  # libraries take their time to tidy up, and OMPL prints what it leaks; everything of ours is closed


def _waits(order: Order) -> bool:
    """Whether the control loop sleeps between its samples."""
    return order.pace == "real_time" or not is_simulated(order.cell)


def _report_failure(error: HeftError) -> Failed:
    lateness = error.lateness if isinstance(error, Stopped) else None
    return Failed(type(error).__name__, error.message, error.in_the_way, lateness)


def _stops_of(order: Order) -> Stops:
    if order.continues is not None and order.continues.stops is not None:
        return Stops(order.continues.stops)
    if order.identify_from == "joint_torques":
        return Stops.of_joint_torques(order.scope.axes)
    return Stops.of_procedure(order.scope, order.timing, order.mass_guess_kg, target=order.target)


def _carry_out(
    order: Order, connection: Connection, planning: PlanningProcess, watch: WatchElsewhere | None, speaker: ChildSpeaker
) -> None:
    lease = Lease(order.cell.control.lease_s)
    listener = Listener(connection, lease)
    pace = RealTime() if order.pace == "real_time" else AsFastAsPossible()
    twin = read_twin(order.cell)
    before = None if order.continues is None else read_recording(order.continues.recording)
    seed = order.seed + order.empty  # what two runs are compared by is not the same noise
    simulation = Simulation(_find_carried(order), seed, pace, twin, _find_start(order, before))
    session = LeasedSession(open_robot_session(order.cell, simulation), lease)
    start = session.find_start()
    model = RobotModel.of_cell(order.cell)
    without = None if order.without is None else read_recording(order.without)
    if without is not None:
        check_arm_alone(without, model.description, order.cell.gravity_in_base)
    done = 0
    if order.continues is not None and before is not None:
        check_same_robot(before, model.description, order.cell.gravity_in_base)
        done = order.continues.done or 0
    payload, reference = (None, None) if order.empty else (order.payload, order.known)
    log = SampleLog(
        order.cell, model, payload=payload, reference=reference, before=before, order=order.reference, complete=session.complete
    )  # fmt: skip
    online = build_estimator(log, session.period)
    elsewhere = PlanningElsewhere(
        stops=planning.stops,
        planner=order.planner,
        seed=order.seed,
        effort=order.effort,
        load=describe_known_load(order.payload, order.known),
        process=planning,
        listener=listener,
        lease=lease,
    )
    with SampleStream(order.folder) as stream:
        run = Run(order.cell, model, session, order.payload_box, elsewhere, DiskRecorder(log, online, stream), done=done, watch=watch)
        plan = _wait_for_release(run, start, order, lease, listener, speaker)
        procedure = move_and_estimate(run, plan, twin, order.folder / RECORDING, without)
        if _waits(order):
            begin_real_time()
        try:
            outcome = _pump(procedure, run, LiveView(run, online, speaker), lease, listener, speaker)
        finally:
            end_real_time()
            if isinstance(pace, RealTime):
                speaker.tell(Paced(pace.ticks, pace.late, pace.latest_s, pace.median_s))
    at = datetime.now(UTC)
    result = outcome.result(order.folder / RECORDING, at=at)
    write_whole(order.folder / RESULT, result.model_dump_json(indent=2) + "\n")
    recording, identification = outcome.recording, outcome.identification
    for language in LANGUAGES:
        page = order.folder / name_report(language)
        write_report(
            page,
            recording=recording,
            identification=identification,
            run=outcome.summary,
            requirement=outcome.requirement,
            target=outcome.target,
            at=at,
            language=language,
        )
    speaker.tell(Done(result))


def _find_carried(order: Order) -> InertialParameters | None:
    """What the simulated robot carries; None for nothing."""
    if order.empty:
        return None
    if order.known is not None:
        return order.known.parameters
    return even_load(order.payload_box, order.mass_guess_kg, Message.of("planning-load-guessed")).parameters


def _find_start(order: Order, before: Recording | None) -> Array:
    """Where the robot is: at home, where the order says, or where the run ended that this one goes on with."""
    if order.continues is None and order.start_rad is not None:
        return np.array(order.start_rad)
    if order.continues is None or order.continues.done is None or before is None or before.q_cmd is None:
        return np.array(order.cell.robot.home_rad)
    return np.asarray(before.q_cmd[-1])


def _wait_for_release(run: Run, start: Array, order: Order, lease: Lease, listener: Listener, speaker: ChildSpeaker) -> Plan:
    """Plans, shows the plan and waits until exactly that is released; a zone that moves meanwhile makes it plan anew.

    Raises:
        Commanded: the run was ended instead.
    """
    while True:
        plan = drive(run.make_plan(start), lambda event: speaker.tell(Happened(event)))
        ready = build_run_plan(run.cell, order.payload_box, plan)
        speaker.tell(Ready(ready))
        while not listener.zones:
            if listener.released == ready.sha256:
                _pause_garbage_collection()
                return plan
            if listener.ended.wait(0.01):
                raise make_end_error(lease)


def _pause_garbage_collection() -> None:
    """One sample is one object: a collection of them all would make the control loop late."""
    gc.collect()
    gc.freeze()
    gc.disable()


def _pump(
    procedure: Generator[Event, None, Outcome], run: Run, view: LiveView, lease: Lease, listener: Listener, speaker: ChildSpeaker
) -> Outcome:
    """Tells the procedure's events; while the robot is on hold it is simply not asked for the next one."""

    def tell(event: Event) -> None:
        if not isinstance(event, RecordingWritten | Finished):
            look_at_zones(run, listener)
        if isinstance(event, Progress):
            view.show(event)
        speaker.tell(Happened(event))
        if isinstance(event, RecordingWritten | Finished):
            end_real_time()  # what follows never sleeps
            gc.enable()
        if isinstance(event, RecordingWritten):
            speaker.tell(MotionEnded())
        if isinstance(event, RobotStopped) and event.held:
            _wait(procedure, run, lease, listener)

    return drive(procedure, tell)


def _wait(procedure: Generator[Event, None, Outcome], run: Run, lease: Lease, listener: Listener) -> None:
    """Waits while the robot is on hold; an end that comes meanwhile is thrown in where the procedure is.

    That the procedure says then that the robot was stopped is nothing new; why the run ended is told when it is over.
    """
    while lease.waits(run.cell.control.hold_limit_s):
        listener.ended.wait(0.01)
    if isinstance(lease.refusal(), Commanded):
        procedure.throw(make_end_error(lease))
