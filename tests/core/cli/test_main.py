"""The command line as a person or a script uses it."""

from __future__ import annotations

import io
import json
import os
import pty
import re
import signal
import subprocess
import sys

import pytest

from core.cell.folder import load_cell
from core.payload.inertia import PHI_NAMES
from core.recording.folder import read_recording
from tests.core.cli.command import ROOT, heft, heft_process

REAL = ROOT.parent / "shared" / "real"


def test_help_names_every_command():
    done = heft_process("--help")
    assert done.returncode == 0
    for command in ("run", "identify", "plan", "cells"):
        assert command in done.stdout


def test_cells_are_listed_with_their_zones():
    done = heft_process("cells")
    assert done.returncode == 0
    assert "lwr4_bench" in done.stdout
    assert "ur5e_line" in done.stdout
    assert "operator" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (("run", "no_such_cell"), "no_such_cell"),
        pytest.param(("run", "lwr4_bench", "--payload", "piano"), "piano", marks=pytest.mark.thorough),
        (("identify", "no/such/recording"), "no/such/recording"),
        pytest.param(("plan", "lwr4_bench", "--json", "no/such/folder/plan.json"), "folder", marks=pytest.mark.thorough),
        (("plan", "lwr4_bench", "--speed", "2.5"), "0.25 m/s, the limit of the cell"),
        pytest.param(("plan", "lwr4_bench", "--axes", "x,w"), "x, y and z", marks=pytest.mark.thorough),
        pytest.param(("plan", "lwr4_bench", "--from", "0,0,0"), "7 finite joint positions", marks=pytest.mark.thorough),
        pytest.param(("plan", "lwr4_bench", "--trajectory", "plan.txt"), ".csv or .json", marks=pytest.mark.thorough),
        (("plan", "lwr4_bench", "--trajectory", "plan.csv", "--period", "0.0015"), "a multiple of 0.001 s"),
    ],
)
def test_bad_input_ends_with_2_and_one_sentence(arguments, word):
    done = heft(*arguments)
    assert done.returncode == 2
    assert done.stdout == ""
    assert word in done.stderr
    assert "Traceback" not in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1


def test_each_flaw_of_a_cell_is_a_line(tmp_path):
    bad = (ROOT / "cells" / "lwr4_bench" / "cell.toml").read_text().replace("noise_std", "noise")
    (tmp_path / "cell.toml").write_text(bad)
    done = heft("plan", str(tmp_path))
    assert done.returncode == 2
    missing, misspelt = done.stderr.strip().splitlines()
    assert "sensor.noise_std: " in missing
    assert "sensor.noise: " in misspelt


def test_a_plan_moves_nothing_and_says_what_would_be_done(tmp_path):
    file = tmp_path / "plan.json"
    done = heft_process("plan", "lwr4_bench", "--payload", "cylinder", "--json", str(file))
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""  # quiet in a pipe
    plan = json.loads(file.read_text())
    assert [pose["axis"] for pose in plan["poses"]] == ["x-", "x+", "y-", "y+", "z-", "z+"]
    assert plan["robot_s"] <= 120
    assert plan["least_margin_m"] >= 0
    assert list(tmp_path.iterdir()) == [file]


def test_a_refused_plan_ends_with_3_and_says_what_is_in_the_way(tmp_path):
    cell = tmp_path / "narrow"
    cell.mkdir()
    (cell / "robot.urdf").write_text((ROOT / "cells/lwr4_bench/robot.urdf").read_text())
    toml = (ROOT / "cells/lwr4_bench/cell.toml").read_text()
    (cell / "cell.toml").write_text(
        toml.replace(
            "size_m = [0.12, 0.13, 0.08], pose.xyz_m = [0.0, -0.017, 0.04]", "size_m = [0.9, 0.9, 0.3], pose.xyz_m = [0.0, 0.0, 0.15]"
        )
    )
    done = heft("plan", str(cell), "--payload", "steel_block")
    assert done.returncode in (2, 3)
    assert done.stdout == ""
    assert re.match(r'heft: The tool\'s box reaches 0\.\d\d m into zone "operator" at home\.', done.stderr)


def test_identify_answers_on_real_static_poses_that_the_inertia_is_not_excited():
    done = heft("identify", str(REAL / "kuka-med14-static"), "--json", "-")
    assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    assert answer["estimate"]["determined"] == [True] * 4 + [False] * 6
    assert answer["estimate"]["phi"][0] == pytest.approx(0.932, abs=0.01)
    assert answer["estimate"]["phi"][4:] == [None] * 6
    assert {reason["code"] for reason in answer["estimate"]["reasons"].values()} == {"estimation-standing"}


def test_identify_sees_no_payload_in_the_joint_torques_of_an_arm_without_one():
    done = heft_process("identify", str(REAL / "kuka-lwr4-torques-1"))
    assert done.returncode == 0, done.stderr
    assert "No payload is seen" in done.stdout


def test_ctrl_c_stops_the_robot_and_leaves_a_readable_recording(tmp_path):
    out = tmp_path / "cut"
    command = [sys.executable, "-m", "core.cli", "run", "lwr4_bench", "--real-time", "--out", str(out)]
    screen, terminal = pty.openpty()  # progress is shown on terminals alone
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=terminal, cwd=ROOT) as process, os.fdopen(screen, "rb", 0) as shown:
        os.close(terminal)
        read_until(shown, r"transfer.* 3%")
        process.send_signal(signal.SIGTERM)
        read_until(shown, r"the robot was stopped")
        assert process.wait(timeout=60) == 130
    assert len(read_recording(out)) > 100


def read_until(shown: io.FileIO, pattern: str) -> None:
    """Until it stands there, in whatever colours; OSError where the program ends before."""
    text = ""
    while not re.search(pattern, re.sub(r"\x1b\[[\d;?]*\w|\s+", " ", text)):
        text += shown.read(4096).decode(errors="replace")


def test_a_plan_begins_where_it_is_told_to_and_leaves_its_set_points_in_a_file(tmp_path):
    file = tmp_path / "plan.csv"
    start = "0.3,-1.2,1.4,-1.4,-1.2,0.2"
    done = heft(
        "plan",
        "ur5e_line",
        "--axes",
        "z",
        "--holds-only",
        "--from",
        start,
        "--speed",
        "0.1",
        "--trajectory",
        str(file),
        "--period",
        "0.008",
    )
    assert done.returncode == 0, done.stderr
    head, first, second, *_, last = file.read_text().splitlines()
    assert head.startswith("time_s,motion,shoulder_pan_rad")
    assert first == f"0.0,transfer z-,{start}"
    assert second.startswith("0.008,transfer z-,")
    home = load_cell(ROOT / "cells" / "ur5e_line").robot.home_rad
    assert [float(value) for value in last.split(",")[2:]] == pytest.approx(home, abs=1e-8)
    assert "Ixx (no rotation about x)" in done.stdout


@pytest.mark.parametrize(
    ("start", "words"),
    [("3.0,-2.0,0.5,1.5,0,0.8,0", "outside its limits"), ("0,2.0,0,0,0,0,0", '"link5" reaches 0.09 m into obstacle "wall_back"')],
)
def test_a_start_where_the_robot_cannot_stand_is_refused_in_words(start, words):
    done = heft("plan", "lwr4_bench", "--from", start)
    assert done.returncode == 3
    assert words in done.stderr
    assert done.stdout == ""


def test_a_run_into_an_empty_folder_answers_before_its_report_and_says_what_holds_alone_do_not_tell(tmp_path):
    out = tmp_path / "run"
    out.mkdir()
    done = heft("run", "ur5e_line", "--holds-only", "--axes", "y,z", "--out", str(out))
    assert done.returncode == 0, done.stderr
    assert {"recording.json", "result.json", "report.html"} <= {file.name for file in out.iterdir()}
    assert (out / "result.json").stat().st_mtime_ns <= (out / "report.html").stat().st_mtime_ns
    assert done.stdout.index("Payload in the sensor frame") < done.stdout.index("Report:")
    answer = json.loads((out / "result.json").read_text())
    estimate = answer["estimate"]
    assert estimate["determined"][:4] == [True] * 4
    assert set(read_recording(out).phase) == {"transfer", "hold:y-", "hold:y+", "hold:z-", "hold:z+"}
    missing = {name for name, known in zip(PHI_NAMES, estimate["determined"], strict=True) if not known}
    assert set(estimate["reasons"]) == missing
    assert all(estimate["reasons"][name]["text"].startswith("no rotation about") for name in missing)
    assert all(estimate["phi"][PHI_NAMES.index(name)] is None for name in missing)
    alone = [warning for warning in answer["warnings"] if warning["code"] == "estimation-transfers-alone"]
    assert missing.union(*(warning["parameters"]["parameters"] for warning in alone)) == set(PHI_NAMES[4:])


def test_a_folder_with_anything_in_it_is_not_written_into(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    done = heft("run", "ur5e_line", "--out", str(tmp_path))
    assert done.returncode == 2
    assert "a new name, or an empty folder" in done.stderr
    assert [file.name for file in tmp_path.iterdir()] == ["notes.txt"]


def test_identify_takes_a_recording_without_the_payload_beside_the_one_with_it(tmp_path):
    report = tmp_path / "report.html"
    loaded, empty = (str(REAL / f"kuka-lwr4-torques-{number}") for number in (2, 1))
    done = heft("identify", loaded, "--without", empty, "--json", "-", "--report", str(report))
    assert done.returncode == 0, done.stderr
    answer = json.loads(done.stdout)
    assert answer["verdict"]["code"] == "torques-no-payload-seen"
    assert answer["estimate"]["determined"] == [True] * 4 + [False] * 6
    assert {source["name"] for source in answer["estimate"]["budget"]["sources"]} == {"torque_gain", "arm_model"}
    assert [joint["joint"] for joint in answer["joints"]] == [f"lwr_{k}_joint" for k in range(7)]
    page = report.read_text()
    assert "lwr_6_joint" in page
    assert "No payload is seen" in page and "nan" not in page.lower()


def test_a_recording_of_poses_is_refused_beside_one_with_torques(tmp_path):
    done = heft("identify", str(REAL / "kuka-lwr4-torques-2"), "--without", str(REAL / "kuka-med14-static"))
    assert done.returncode == 2
    assert "Traceback" not in done.stderr and len(done.stderr.strip().splitlines()) <= 3
