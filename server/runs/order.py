"""What was asked for, completed by what the cell knows: all that a control process has to be told."""

from __future__ import annotations

from pathlib import Path

from sqlalchemy.orm import Session

from core.cell.cell import Cell, Payload
from core.errors import BadPayload
from core.planning.settings import Timing
from core.planning.slow_run import find_speed_range, limit_speed
from core.recording.order_reference import OrderReference
from server.cells.payloads import check_saved, find_expected_mass, find_saved, list_saved, read_box, read_known_payload
from server.http.errors import Conflict
from server.runner.messages import Continuation, Order
from server.runner.run_folder import RECORDING
from server.runs.ledger import CarriedPayload, load_run, motion_of, read_carried
from server.runs.schemas import Motion, ProposedMotion, RestOfRun, RunCreate, RunOrder
from server.runs.tables import RunRow


def order_of(row: RunRow, cell: Cell, folder: Path) -> Order:
    """What the control process is told.

    Raises:
        BadPayload: the cell was replaced since by one that does not know the payload.
    """
    order = RunOrder.model_validate_json(row.order)
    motion = motion_of(row)
    payload = order.payload or next(iter(cell.payloads), "")  # orders of older services may name none
    known = _find_known(row, order, cell, payload)
    return Order(
        run=row.id,
        cell=slow_down(cell, order),
        payload=payload,
        known=known,
        payload_box=order.payload_box or (cell.payload_box if known is None else known.box),
        timing=Timing(hold_s=order.hold_s, settle_s=order.settle_s, robot_s=order.robot_s, inertia_std=order.inertia_std),
        planner=order.planner,
        seed=order.seed,
        mass_guess_kg=order.mass_guess_kg,
        pace=order.pace,
        folder=folder,
        continues=None if motion is None else _continuation(motion),
        scope=order.scope,
        effort=order.effort,
        start_rad=order.start_rad,
        reference=reference_of(row),
        target=None if isinstance(motion, ProposedMotion) else order.target,
        identify_from=order.identify_from,
        empty=order.empty,
        without=None if order.without is None or isinstance(motion, ProposedMotion) else folder.parent / order.without / RECORDING,
    )


def slow_down(cell: Cell, order: RunOrder) -> Cell:
    """The cell with the speed that was ordered as its limit; its own where none was, or where it has become lower since."""
    limit = cell.limits.cartesian_speed_m_s
    return limit_speed(cell, min(order.speed_m_s or limit, limit), "speed_m_s")


def reference_of(row: RunRow) -> OrderReference:
    """What the plant calls a run's order."""
    return OrderReference(order_id=row.order_id, work_order=row.work_order, serial_number=row.serial_number)


def check_order(order: RunOrder, cell: Cell) -> None:
    """What is asked for goes with the cell; whether the robot may be where it is said to stand is for planning to say.

    Raises:
        Conflict: a speed that the cell does not allow, not one joint position for each joint, or joint torques from less than a whole run
            with the payload.
    """
    for key, asked in (("identify_from", order.identify_from == "joint_torques"), ("without", order.without is not None)):
        others = {"target": order.target is not None, "rotations": not order.rotations, "empty": order.empty and key == "without"}
        beside = next((option for option, given in others.items() if given), None)
        if asked and beside is not None:
            raise Conflict("torques-not-together", key=key, option=beside)
    slowest, limit = find_speed_range(cell)
    if order.speed_m_s is not None and not slowest <= order.speed_m_s <= limit:
        raise Conflict("runs-speed-not-allowed", speed_m_s=order.speed_m_s, least_m_s=slowest, most_m_s=limit)
    count = len(cell.robot.home_rad)
    if order.start_rad is not None and len(order.start_rad) != count:
        raise Conflict("runs-start-of-other-robot", given=len(order.start_rad), joints=count)


def check_compared(db: Session, order: RunOrder, recordings: Path) -> None:
    """The run that an order wants its own compared with was one without the payload, in the same cell.

    Args:
        recordings: folder of all runs' folders.

    Raises:
        NotFound: there is none.
        Conflict: it was another, or left no recording.
    """
    if order.without is None:
        return
    row = load_run(db, order.without)
    if row.cell != order.cell or not RunOrder.model_validate_json(row.order).empty:
        raise Conflict("torques-run-not-empty", run=row.id, cell=order.cell)
    if not (recordings / row.id / RECORDING).is_dir():
        raise Conflict("runs-no-recording", run=row.id, state=row.state)


def _find_known(row: RunRow, order: RunOrder, cell: Cell, name: str) -> Payload | None:
    """What is known of the payload that a run is planned for; None where its box alone is."""
    carried = read_carried(row)
    if carried is not None:
        return carried.known
    return None if order.empty and name not in cell.payloads else _load_payload(cell, name)


def _load_payload(cell: Cell, name: str) -> Payload:
    if name not in cell.payloads:
        raise BadPayload("payload", "runs-payload-unknown", payload=name, payloads=list(cell.payloads), cell=cell.name)
    return cell.payloads[name]


def complete_payload(db: Session, order: RunCreate, cell: Cell) -> tuple[RunOrder, CarriedPayload | None]:
    """The order with what the tool library says of its payload; None beside it where the payload is one of cell.toml, which goes first.

    Raises:
        BadPayload: the cell knows no such payload, or none at all, or what is saved of it does not go with the cell.
    """
    if order.payload in cell.payloads:
        return order, None
    saved = find_saved(db, cell.name, order.payload)
    if saved is None:
        known = [*cell.payloads, *(each.name for each in list_saved(db, cell.name))]
        if not known:
            raise BadPayload("payload", "runs-cell-without-payload", cell=cell.name)
        raise BadPayload("payload", "runs-payload-unknown", payload=order.payload, payloads=known, cell=cell.name)
    check_saved(saved, cell)
    taken: dict[str, object] = {"payload_box": order.payload_box or read_box(saved)}
    mass_kg = find_expected_mass(saved)
    if mass_kg is not None and "mass_guess_kg" not in order.model_fields_set:
        taken["mass_guess_kg"] = mass_kg
    return order.model_copy(update=taken), CarriedPayload(saved.id, read_known_payload(saved))


def _continuation(motion: Motion) -> Continuation:
    if isinstance(motion, RestOfRun):
        return Continuation(motion.recording, motion.stops, motion.done)
    return Continuation(motion.recording, motion.stops)
