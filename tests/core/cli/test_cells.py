"""`heft cell new`, `heft cell check` and `heft cells` as a person or a script uses them."""

from __future__ import annotations

import json
import shutil

import pytest

from tests.core.cli.command import ROOT, heft, heft_process
from tests.core.new_cell.small_arm import arm, joint, link, write_arm

HAND = link("hand") + joint("grip", "flange", "hand", kind="fixed", rest="")


def test_a_cell_is_made_checked_and_listed(tmp_path):
    file = write_arm(tmp_path, arm())
    done = heft_process("cell", "new", "tried", "--urdf", file, "--mount", "flange", "--mount-xyz", 0, 0, 0.02, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (
        done.stdout.splitlines()[-1]
        == "Next: look at cell.toml, put in what stands there, then `heft cell check tried` and `heft plan tried`."
    )
    assert "ft_sensor" in (tmp_path / "cells/tried/cell.toml").read_text()
    checked = heft("cell", "check", "tried", "--json", "-", cwd=tmp_path)
    assert checked.returncode == 0, checked.stdout
    found = json.loads(checked.stdout)
    assert found["cell"] == "tried"
    assert {each["severity"] for each in found["findings"]} == {"doubtful"}
    assert any("zones" in each["where"] for each in found["findings"])
    assert "tried" in heft("cells", cwd=tmp_path).stdout


@pytest.mark.parametrize(
    ("text", "options", "words"),
    [
        (arm(HAND), (), "hand"),
        (arm(), ("--xacro-arg", "model=a"), "NAME:=VALUE"),
        (arm(), ("--sensor-frame", "flange", "--mount", "flange"), "one of them"),
        (arm(), ("--package-path", "nowhere"), "nowhere"),
        ("<robot", (), "does not parse"),
    ],
)
def test_what_cannot_be_used_ends_with_2_and_one_sentence(tmp_path, text, options, words):
    done = heft("cell", "new", "tried", "--urdf", write_arm(tmp_path, text), *options, cwd=tmp_path)
    assert done.returncode == 2
    assert done.stdout == ""
    assert words in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "cells").exists()


def test_a_wrong_cell_ends_the_check_with_2_and_does_not_hide_the_others(tmp_path):
    shutil.copytree(ROOT / "cells/lwr4_bench", tmp_path / "cells/bad")
    file = tmp_path / "cells/bad/cell.toml"
    file.write_text(file.read_text().replace("clearance_m = 0.03", 'clearance_m = "wide"'))
    checked = heft("cell", "check", "bad", cwd=tmp_path)
    assert checked.returncode == 2
    assert checked.stdout.startswith("wrong: cells/bad/cell.toml: limits.clearance_m")
    listed = heft("cells", cwd=tmp_path)
    assert listed.returncode == 0
    assert "ur5e_line" in listed.stdout
    assert "bad cannot be used: cells/bad/cell.toml: limits.clearance_m" in listed.stdout
