"""Makes a cell of a description that somebody has sent, with limits: what is wrong and doubtful in it is told with it."""

from __future__ import annotations

import os
import shutil
import sys
from multiprocessing.connection import Connection
from pathlib import Path

from core.cell.cell import Cell
from core.cell.folder import load_cell
from core.cell.urdf import check_urdf
from core.cell.urdf_elements import UrdfJoint
from core.errors import BadInput
from core.new_cell.findings import CellFinding, findings_of
from core.new_cell.home import SAMPLES, Home
from core.new_cell.making import URDF, Made, make_cell
from core.new_cell.order import CellOrder
from core.robot.compiled import load_kinematics
from core.words.catalogue import Language
from core.words.message import Message
from server.http.flaws import dump_refusal
from server.runner.confinement import confine
from server.runner.draft_schemas import DraftCellPublic, DraftFinding, DraftJoint, DraftLink, DraftPair
from server.runner.messages import Answered
from server.runner.work import give_way

SECONDS, MEMORY = 90.0, 1_500_000_000
PICTURE = "home.png"


def main(folder: Path, order: CellOrder, language: Language, connection: Connection) -> None:
    """Answers with a `DraftCellPublic`, or with what is wrong (`dump_refusal`). The picture of the home stands in the folder either way.

    Args:
        folder: of the draft; the paths of the order are from there.
        language: of the picture.
    """
    give_way()
    os.chdir(folder)  # errors name files as the upload does
    os.environ["HEFT_LANGUAGE"] = language
    sys.dont_write_bytecode = True
    load_kinematics()  # before this process may no longer: numba needs more than a file that is read
    confine(folder, SECONDS, MEMORY)
    shutil.rmtree(order.folder, ignore_errors=True)
    Path(PICTURE).unlink(missing_ok=True)
    try:
        made = make_cell(order, picture=Path(PICTURE))
        connection.send(Answered(_describe(made).model_dump_json()))
    except BadInput as error:
        connection.send(Answered(dump_refusal(error)))


def _describe(made: Made) -> DraftCellPublic:
    cell = load_cell(made.folder)
    urdf = check_urdf(cell.urdf, URDF)
    known = {joint.name: joint for joint in urdf.joints}
    joints = [known[hinge.name] for hinge in urdf.hinges(cell.robot.base_frame, cell.robot.sensor_frame)]
    masses = {link.name: link.mass for link in urdf.bodies}
    return DraftCellPublic(
        cell=cell,
        joints=[_describe_joint(joint, value) for joint, value in zip(joints, cell.robot.acceleration_rad_s2, strict=True)],
        links=[DraftLink(name=joint.child, mass_kg=masses.get(joint.child) or 0.0) for joint in joints],
        pairs=_list_pairs(cell, made.home),
        notes=list(made.notes),
        findings=[_tell(finding) for finding in findings_of(made.folder)],
    )


def _list_pairs(cell: Cell, home: Home) -> list[DraftPair]:
    overlaps = Message.of("newcell-pair-overlaps", count=SAMPLES)
    left_out = {frozenset(pair) for pair in cell.robot.adjacent}
    overlapping = {frozenset(pair) for pair in home.always_overlapping}
    declared = [pair for pair in cell.robot.adjacent if frozenset(pair) not in overlapping]
    return [
        DraftPair(
            first=pair[0],
            second=pair[1],
            is_left_out=frozenset(pair) in left_out,
            why=overlaps if frozenset(pair) in overlapping else Message.of("newcell-pair-declared"),
        )
        for pair in (*home.always_overlapping, *declared)
    ]


def _describe_joint(joint: UrdfJoint, acceleration_rad_s2: float) -> DraftJoint:
    return DraftJoint(
        name=joint.name,
        lower_rad=joint.lower,
        upper_rad=joint.upper,
        velocity_rad_s=joint.velocity,
        effort_n_m=joint.effort,
        acceleration_rad_s2=acceleration_rad_s2,
    )


def _tell(finding: CellFinding) -> DraftFinding:
    return DraftFinding(severity=finding.severity, message=finding.message)
