"""What may be asked of a run, and what its control process is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from pydantic import ValidationError

from core.cell.folder import load_cell
from core.planning.settings import Scope
from core.requirement.target import Target
from server.http.errors import Conflict
from server.runs import ledger as run_ledger
from server.runs.ledger import CarriedPayload
from server.runs.order import check_order, order_of
from server.runs.schemas import RunCreate
from server.service import Service

CELL = "lwr4_bench"
LWR = load_cell(Path(__file__).parents[3] / "cells" / CELL)
START = (0.1, -2.0, 0.5, 1.5, 0.0, 0.8, 0.0)


def told(service: Service, order: RunCreate, cell=LWR):
    with service.store.write() as db:
        return order_of(run_ledger.add_run(db, order, "account:anna", service.now()), cell, Path("run"))


def test_the_control_process_is_told_what_was_asked_for(service: Service) -> None:
    asked = RunCreate(cell=CELL, payload="steel_block", axes="xz", rotations=False, speed_m_s=0.1, effort=4, start_rad=START)
    order = told(service, asked)
    assert (order.scope, order.effort, order.start_rad) == (Scope("xz", rotations=False), 4, START)
    assert order.cell.limits.cartesian_speed_m_s == 0.1


def test_a_target_goes_along_to_the_control_process_and_to_the_rest_of_the_run(service: Service) -> None:
    asked = RunCreate.model_validate({"cell": CELL, "payload": "steel_block", "target": {"mass_share": 0.001}})
    assert told(service, asked).target == Target(mass_share=0.001)
    assert told(service, RunCreate(cell=CELL, payload="steel_block")).target is None
    assert told(service, RunCreate.model_validate({"cell": CELL, "payload": "steel_block", "target": {}})).target is None


def test_motions_for_joint_torques_and_those_without_the_payload_are_told_to_the_control_process(service: Service) -> None:
    plain = told(service, RunCreate(cell=CELL, payload="steel_block"))
    assert (plain.identify_from, plain.empty) == ("wrist_sensor", False)
    order = told(service, RunCreate(cell=CELL, payload="steel_block", identify_from="joint_torques", empty=True))
    assert (order.identify_from, order.empty) == ("joint_torques", True)
    assert order.known == plain.known, "planned for the payload, so that the motions are the same with and without it"


def test_a_run_without_the_payload_is_none_of_its_runs_and_is_planned_for_it_all_the_same(service: Service) -> None:
    known = LWR.payloads["steel_block"]
    asked = RunCreate(cell=CELL, payload="kept", empty=True, payload_box=known.box)
    with service.store.write() as db:
        for carried in (CarriedPayload("0123", known), CarriedPayload("0123", None)):
            row = run_ledger.add_run(db, asked, "account:anna", service.now(), carried=carried)
            assert (row.payload, row.saved_payload) == (None, None)
            order = order_of(row, LWR, Path("run"))
            assert (order.payload, order.known, order.payload_box) == ("kept", carried.known, known.box)


@pytest.mark.parametrize("more", [{"rotations": False}, {"target": {"mass_share": 0.001}}])
def test_motions_for_joint_torques_are_made_whole(more: dict[str, object]) -> None:
    asked = {"cell": CELL, "payload": "steel_block", "identify_from": "joint_torques", **more}
    with pytest.raises(Conflict, match=f"identify_from does not go with {next(iter(more))}"):
        check_order(RunCreate.model_validate(asked), LWR)


@pytest.mark.parametrize("more", [{"empty": True}, {"target": {"mass_share": 0.001}}])
def test_only_a_whole_run_with_the_payload_is_compared_with_one_without(service: Service, more: dict[str, object]) -> None:
    asked = RunCreate.model_validate({"cell": CELL, "payload": "steel_block", "without": "0123"})
    assert told(service, asked).without == Path("0123") / "recording"
    with pytest.raises(Conflict, match=f"without does not go with {next(iter(more))}"):
        check_order(RunCreate.model_validate(asked.model_dump() | more), LWR)


@pytest.mark.parametrize("target", [{"mass_share": 0.0}, {"mass_share": 1.5}, {"centre_of_mass_m": -1e-3}, {"weight": 0.1}])
def test_what_is_no_target_is_refused(target: dict[str, float]) -> None:
    with pytest.raises(ValidationError, match="target"):
        RunCreate.model_validate({"cell": CELL, "payload": "steel_block", "target": target})


def test_an_order_that_says_nothing_of_it_is_the_whole_procedure_from_home_at_the_cells_speed(service: Service) -> None:
    order = told(service, RunCreate(cell=CELL, payload="steel_block"))
    assert (order.scope, order.effort, order.start_rad) == (Scope(), 1, None)
    assert order.cell == LWR


def test_a_cell_that_has_become_slower_since_stays_as_slow(service: Service) -> None:
    slower = LWR.model_copy(update={"limits": LWR.limits.model_copy(update={"cartesian_speed_m_s": 0.05})})
    order = told(service, RunCreate(cell=CELL, payload="steel_block", speed_m_s=0.1), slower)
    assert order.cell.limits.cartesian_speed_m_s == 0.05


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("speed_m_s", 0.3, r"\(speed_m_s\); this cell allows 0\.01 to 0\.25 m/s"),
        ("start_rad", (0.0, 0.1), "start_rad .*this robot has 7 joints"),
    ],
)
def test_what_does_not_go_with_the_cell_is_refused_with_its_key(key: str, value: object, words: str) -> None:
    with pytest.raises(Conflict, match=words):
        check_order(RunCreate.model_validate({"cell": CELL, "payload": "steel_block", key: value}), LWR)


@pytest.mark.parametrize(
    ("key", "value"),
    [
        *(("axes", axes) for axes in ("", "zx", "xx", "w")),
        *(("effort", effort) for effort in (0, 101)),
        *(("speed_m_s", speed) for speed in (0.0, -0.1, float("nan"))),
        *(("start_rad", start) for start in ((), (float("inf"),))),
        ("rotations", "perhaps"),
    ],
)
def test_what_no_cell_could_do_is_refused(key: str, value: object) -> None:
    with pytest.raises(ValidationError):
        RunCreate.model_validate({"cell": CELL, "payload": "steel_block", key: value})
