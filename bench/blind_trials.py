"""The blind check on four robots, each with small imperfections of its own: those of the cells that ship, and two of others' descriptions.

    python -m bench.blind_trials FOLDER [--count N] [--seed N] [--processes N] [--keep FOLDER]

Makes cells of the Panda and the UR10 of the package example-robot-data in FOLDER/cells, as `heft cell new` does, with the payloads of
`ur5e_line`; then runs `heft trial` on all four, with its report in FOLDER. 600 trials take some hours; what was cut short goes on.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path

from core.cell.cell import CELL_FILE
from core.cell.folder import find_cell
from core.new_cell.making import make_cell
from core.new_cell.order import CellOrder
from core.trial.draw import CELLS

SHARE = Path(sysconfig.get_paths()["purelib"]) / "cmeel.prefix" / "share"
ROBOTS = SHARE / "example-robot-data" / "robots"
ARMS = {
    "panda": ("panda_description/urdf/panda.urdf", "panda_link0", "panda_hand_tcp"),
    "ur10": ("ur_description/urdf/ur10_robot.urdf", "base_link", "tool0"),
}
"""Description, where the arm begins, and what carries the sensor."""
PAYLOADS_OF = "ur5e_line"


def make_cells(folder: Path) -> list[Path]:
    """Those that are not there yet are made."""
    folder.mkdir(parents=True, exist_ok=True)
    text = (find_cell(PAYLOADS_OF) / CELL_FILE).read_text(encoding="utf-8")
    payloads = text[text.index("[payloads.") :]
    for name, (urdf, base, flange) in ARMS.items():
        if (folder / name).exists():
            continue
        order = CellOrder(name=name, urdf=ROBOTS / urdf, into=folder, package_paths=(SHARE,), base_frame=base, mount=flange)
        made = make_cell(order).folder
        with (made / CELL_FILE).open("a", encoding="utf-8") as file:
            file.write("\n" + payloads)
    return [folder / name for name in ARMS]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--count", type=int, default=600)
    parser.add_argument("--seed", type=int, default=70000)
    parser.add_argument("--processes", type=int)
    parser.add_argument("--keep", type=Path)
    given = parser.parse_args()
    cells = [*CELLS, *map(str, make_cells(given.folder / "cells"))]
    heft = shutil.which("heft", path=str(Path(sys.executable).parent)) or "heft"
    order = [heft, "trial", "--count", str(given.count), "--seed", str(given.seed), "--report", str(given.folder / "report")]
    order += [part for cell in cells for part in ("--cell", cell)]
    order += [] if given.processes is None else ["--processes", str(given.processes)]
    order += [] if given.keep is None else ["--keep", str(given.keep)]
    raise SystemExit(subprocess.run(order, check=False).returncode)


if __name__ == "__main__":
    main()
