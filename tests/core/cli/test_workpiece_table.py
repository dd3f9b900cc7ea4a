"""The workpiece alone at a terminal."""

from __future__ import annotations

from io import StringIO

import numpy as np
from rich.console import Console

from core.cli.workpiece_table import workpiece_lines, workpiece_table
from core.estimation.result import ReferencePart, ToolPart, WorkpiecePart
from core.payload.inertia import InertialParameters
from core.words.message import Message

PART = InertialParameters.from_com(2.0, [0.0, 0.01, 0.05], np.diag([0.004, 0.005, 0.003]))


def part(**changes: object) -> WorkpiecePart:
    content: dict[str, object] = {
        "phi": [2.02, None, *PART.phi[2:].tolist()],
        "std": [0.01, None, *[1e-4] * 8],
        "covariance": [],
        "com_m": [None] * 3,
        "com_std_m": [None] * 3,
        "inertia_com_kg_m2": [None] * 6,
        "inertia_com_std_kg_m2": [None] * 6,
        "consistent": True,
        "reference": ReferencePart(phi=PART.phi.tolist(), source="CAD"),
        "tools": [ToolPart(name="gripper", title="A gripper", phi=[0.8] * 10, std=[None] * 10)],
        "remarks": [Message.of("text", text="The uncertainty of the tool gripper is unknown.")],
    }
    return WorkpiecePart.model_validate(content | changes)


def printed(workpiece: WorkpiecePart) -> list[str]:
    console = Console(width=120, file=StringIO())
    console.print(workpiece_table(workpiece))
    assert isinstance(console.file, StringIO)
    return console.file.getvalue().splitlines()


def test_the_table_has_reference_value_half_width_and_error() -> None:
    lines = printed(part())
    mass = next(line for line in lines if " m " in line and "kg" in line)
    assert [word for word in mass.replace("│", " ").split() if word != "m"] == ["2", "2.020", "0.020", "+1.000", "%", "kg"]
    assert any("not determined" in line and "mc_x" in line for line in lines)
    assert any("without gripper" in line for line in lines)


def test_without_a_reference_there_is_no_error() -> None:
    lines = printed(part(reference=None))
    assert any("2.020" in line for line in lines)
    assert not any("%" in line for line in lines)


def test_what_has_to_be_known_is_a_line() -> None:
    assert workpiece_lines(part()) == ["Note: The uncertainty of the tool gripper is unknown."]
    assert workpiece_lines(part(remarks=[])) == []
