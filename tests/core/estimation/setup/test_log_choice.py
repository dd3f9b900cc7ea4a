"""From a log in five formats to a recording without a question, and the questions that a log raises."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from core.estimation.setup.log_choice import ImportedLog, import_log
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.question import OpenQuestion
from core.recording.logs.tables import open_log
from tests.core.recording.logs.foreign_logs import LOG, write_ati, write_csv, write_rtde, write_transforms, write_undecided
from tests.core.recording.logs.payload_log import MASS_KG


def imported(*paths: Path, **answers: str) -> ImportedLog:
    log = open_log(paths)
    given = {key.replace("__", "."): value for key, value in answers.items()}
    return import_log(log, propose_mappings(log, given), Path())


def test_a_csv_of_the_other_sign(tmp_path: Path) -> None:
    check(imported(write_csv(tmp_path)), sign=-1, axes="sensor")


def test_an_rtde_log_in_base_axes(tmp_path: Path) -> None:
    check(imported(write_rtde(tmp_path)), sign=1, axes="base")


def test_an_ati_file_beside_a_file_of_poses(tmp_path: Path) -> None:
    check(imported(*write_ati(tmp_path)), sign=1, axes="sensor")


@pytest.mark.parametrize("storage", ["mcap", "sqlite", "ros1"])
def test_a_bag_with_a_tree_of_transforms(tmp_path: Path, storage: str) -> None:
    path = write_transforms(tmp_path, storage)
    made = imported(path)
    check(made, sign=1, axes="sensor")
    assert made.mapping.pose is not None
    assert made.mapping.pose.file == "tf world>hand"
    again = import_log(open_log([path]), [made.mapping], Path())
    assert np.array_equal(again.beginning.wrench, made.beginning.wrench)


def check(made: ImportedLog, *, sign: int, axes: str) -> None:
    assert made.check.contradiction is None
    assert made.check.weighed is not None
    assert made.check.weighed.mass == pytest.approx(MASS_KG, rel=0.01)
    assert (made.mapping.wrench.sign, made.mapping.wrench.axes) == (sign, axes)
    rows = slice(0, len(made.beginning))
    assert np.abs(made.beginning.wrench - LOG.wrench[rows]).max() < 1e-5
    assert np.abs(made.beginning.orientation - LOG.orientation[rows]).max() < 1e-4


def test_an_attitude_that_does_not_change_leaves_the_axes_to_a_person(tmp_path: Path) -> None:
    file = write_undecided(tmp_path)
    with pytest.raises(OpenQuestion) as asked:
        imported(file)
    assert (asked.value.key, asked.value.likely) == ("wrench.axes", "sensor")
    with pytest.raises(OpenQuestion) as then:
        imported(file, wrench__axes="sensor")
    assert then.value.key == "wrench.sign"
    assert imported(file, wrench__axes="sensor", wrench__sign="-1").mapping.wrench.sign == -1
