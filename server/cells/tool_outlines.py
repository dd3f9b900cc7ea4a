"""What is bolted between a cell's sensor and its payload, as boxes: as a picture of a payload shows it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, TypeAdapter

from core.cell.cell import Cell
from core.payload.shapes import Box
from server.http.dependencies import depend_on
from server.http.schemas import Answer
from server.runner.messages import Answered
from server.runner.work import run_work

BOXES = TypeAdapter(dict[str, list[Box]])


class ToolOutline(Answer):
    """A tool that is bolted between sensor and payload."""

    name: str = Field(description="Name of the tool.", examples=["gripper"])
    title: str = Field(description="What people call it.", examples=["Gripper"])
    boxes: list[Box] = Field(
        description="What it takes up, sensor frame: its box, or one around each link that it is made of; empty where nobody knows."
    )


class ToolOutlines:
    """Of all cells. Those of links are looked at by a process once for each state of a cell's files."""

    def __init__(self) -> None:
        self._known: dict[str, tuple[str, dict[str, list[Box]]]] = {}

    def find(self, cell: Cell, sha256: str) -> list[ToolOutline]:
        """The tools of a cell; takes some tenths of a second where some are made of links and nobody has asked before.

        Args:
            sha256: of the cell's files.
        """
        of_links = self._find_boxes(cell, sha256) if any(tool.links for tool in cell.tools.values()) else {}
        return [
            ToolOutline(name=name, title=tool.title, boxes=of_links.get(name, []) if tool.box is None else [tool.box])
            for name, tool in cell.tools.items()
        ]

    def _find_boxes(self, cell: Cell, sha256: str) -> dict[str, list[Box]]:
        """Nothing where the robot cannot be used."""
        known = self._known.get(cell.name)
        if known is None or known[0] != sha256:
            found = [word.text for word in run_work("server.runner.tool_outlines", cell) if isinstance(word, Answered)]
            self._known[cell.name] = known = (sha256, BOXES.validate_json(found[0]) if found else {})
        return known[1]


ToolOutlinesDep = Annotated[ToolOutlines, depend_on("tool_outlines")]
