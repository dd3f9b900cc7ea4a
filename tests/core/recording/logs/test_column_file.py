"""Files as other programs write them, written here by hand after their makers' descriptions."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from core.errors import BadRecording
from core.recording.logs.column_file import read_column_file
from core.recording.logs.proposal import propose_mappings
from core.recording.logs.tables import open_log

ATI = """Start Time,11/24/2026 10:12:13 AM
RDT Sample Rate,7000
Force Units,lbf
Counts per Unit Force,1000000
Torque Units,lbf-in
Counts per Unit Torque,500000
Status (hex),RDT Sequence,F/T Sequence,Fx,Fy,Fz,Tx,Ty,Tz,Time
0,1,400,1000000,-2000000,500000,500000,0,-250000,10:12:13.01
0,2,401,1000000,-2000000,500000,500000,0,-250000,10:12:13.01
0,4,403,2000000,-2000000,500000,500000,0,-250000,10:12:13.02
"""


def test_counts_of_atis_program_are_newtons_and_the_time_is_that_of_the_packets(tmp_path: Path) -> None:
    (tmp_path / "ati.csv").write_text(ATI)
    samples = read_column_file(tmp_path / "ati.csv", "ati.csv")
    assert samples.numbers("t")[:, 0] == pytest.approx([1 / 7000, 2 / 7000, 4 / 7000])
    assert samples.numbers("fx", "fy", "fz")[0] == pytest.approx([4.4482216, -8.8964432, 2.2241108])
    assert samples.numbers("tx", "ty", "tz")[2] == pytest.approx([0.1129848, 0.0, -0.0564924])


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Force Units,lbf", "Force Units,stone", "stone"),
        ("Counts per Unit Torque,500000", "Counts per Unit Torque,0", "a number above zero"),
        ("RDT Sample Rate,7000", "Rate,7000", "no line RDT Sample Rate"),
        ("Fx", "Gx", "column 'fx'"),
    ],
)
def test_what_atis_program_did_not_write_is_refused_in_words(tmp_path: Path, old: str, new: str, said: str) -> None:
    (tmp_path / "ati.csv").write_text(ATI.replace(old, new, 1))
    with pytest.raises(BadRecording, match=re.escape(said)):
        read_column_file(tmp_path / "ati.csv", "ati.csv")


@pytest.mark.parametrize(
    "text", ["t;fx;fy\n0,5;1,25;-2\n1,5;3,5;4,0\n", "t fx fy\n0.5 1.25 -2\n1.5 3.5 4\n", "t\tfx\tfy\n0.5\t1.25\t-2\n1.5\t3.5\t4\n"]
)
def test_other_separators_and_decimal_commas_are_read(tmp_path: Path, text: str) -> None:
    (tmp_path / "log.csv").write_text(text)
    samples = read_column_file(tmp_path / "log.csv", "log.csv")
    assert np.array_equal(samples.numbers("t", "fx", "fy"), [[0.5, 1.25, -2.0], [1.5, 3.5, 4.0]])


def test_a_semicolon_file_of_numbers_has_columns_by_number(tmp_path: Path) -> None:
    (tmp_path / "log.csv").write_text("0,5;1,25\n1,5;3,5\n")
    assert np.array_equal(read_column_file(tmp_path / "log.csv", "log.csv").numbers("1", "2"), [[0.5, 1.25], [1.5, 3.5]])


def test_the_raw_wrench_of_an_rtde_log_is_preferred_to_the_compensated_one(tmp_path: Path) -> None:
    names = [f"{name}_{k}" for name in ("actual_q", "actual_TCP_pose", "actual_TCP_force", "ft_raw_wrench") for k in range(6)]
    rows = [" ".join([repr(0.002 * k), *(["0.25"] * len(names))]) for k in range(5)]
    (tmp_path / "robot_data.csv").write_text("\n".join([" ".join(["timestamp", *names]), *rows]) + "\n")
    first = propose_mappings(open_log([tmp_path / "robot_data.csv"]), {})[0]
    assert first.wrench.force == ("ft_raw_wrench_0", "ft_raw_wrench_1", "ft_raw_wrench_2")
    assert first.wrench.torque == ("ft_raw_wrench_3", "ft_raw_wrench_4", "ft_raw_wrench_5")
    assert first.wrench.axes == "sensor"
    assert first.pose is not None
    assert first.pose.rotation_vector == ("actual_TCP_pose_3", "actual_TCP_pose_4", "actual_TCP_pose_5")


@pytest.mark.parametrize("content", [b"", b"\x00\xff\xfe", b"\x1f\x8b broken"])
def test_rubbish_is_refused_in_words(tmp_path: Path, content: bytes) -> None:
    for name in ("log.csv", "log.csv.gz", "log.parquet"):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(BadRecording):
            read_column_file(tmp_path / name, name)
