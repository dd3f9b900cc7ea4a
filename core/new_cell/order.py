"""What somebody who makes a cell has asked for."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path

from core.errors import BadInput
from core.new_cell.values import CellValues

NAME = re.compile(r"[A-Za-z0-9_-]{1,64}", re.ASCII)


class Behind(StrEnum):
    """What links behind the sensor frame are."""

    TOOL = "tool"
    ROBOT = "robot"


@dataclass(frozen=True)
class CellOrder:
    """A cell to be made.

    Args:
        name: of the cell and of its folder.
        urdf: the robot's description, URDF or xacro.
        into: the folder that the cell's folder is made in.
        package_paths: folders with ROS packages, or packages themselves; with the URDF's own folder all that may be read.
        xacro_arguments: values for what a xacro file declares by `xacro:arg`.
        base_frame: the link that the moving joints are counted from; None for the one that carries the arm's first moving joint.
        sensor_frame: a link that is the sensor's frame; None to choose one.
        mount: a link that a new link `ft_sensor` is fixed to, in place of `sensor_frame`.
        mount_xyz: of `ft_sensor` in that link, m. mount_rpy: rad.
        behind: what the links behind the sensor frame are; None to ask, or to refuse where nobody can be asked.
        values: what is known better than the description has it.
    """

    name: str
    urdf: Path
    into: Path = Path("cells")
    package_paths: tuple[Path, ...] = ()
    xacro_arguments: dict[str, str] = field(default_factory=dict)
    base_frame: str | None = None
    sensor_frame: str | None = None
    mount: str | None = None
    mount_xyz: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mount_rpy: tuple[float, float, float] = (0.0, 0.0, 0.0)
    behind: Behind | None = None
    values: CellValues = field(default_factory=CellValues)

    @property
    def folder(self) -> Path:
        """Of the new cell."""
        return self.into / self.name


def check_cell_order(order: CellOrder) -> None:
    """Before anything is read: the names are names and nothing is there yet.

    Raises:
        BadInput: a name that is none, two sensor frames, a folder that exists already or one that does not.
    """
    if not NAME.fullmatch(order.name):
        raise BadInput("NAME", "newcell-no-name", name=order.name)
    if order.sensor_frame is not None and order.mount is not None:
        raise BadInput("--mount", "newcell-two-sensor-frames")
    if order.folder.exists() or order.folder.is_symlink():
        raise BadInput(str(order.folder), "newcell-exists")
    if order.into.exists() and not order.into.is_dir():
        raise BadInput(f"--into {order.into}", "newcell-no-folder")
    for path in order.package_paths:
        if not path.is_dir():
            raise BadInput(f"--package-path {path}", "newcell-no-package-path")
