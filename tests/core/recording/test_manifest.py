"""Tools in recording.json: what is known comes back, what cannot be is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from core.errors import BadRecording
from core.payload.inertia import InertialParameters
from core.payload.known_tool import KnownTool
from core.recording.folder import read_recording, write_recording
from core.recording.recording import Recording
from tests.core.recording.small_recording import recording

HAND = InertialParameters.from_com(0.8, [0.0, 0.01, 0.04], np.diag([0.001, 0.001, 0.0008]))
TOOLS = (
    KnownTool("hand", "A hand", HAND, np.array([0.002, *[np.nan] * 3, *[1e-5] * 6])),
    KnownTool("adapter", "An adapter", HAND, np.full(10, np.nan)),
)


def tooled() -> Recording:
    return replace(recording(), tools=TOOLS)


def test_tools_are_read_back_with_what_is_stated_of_them(tmp_path: Path) -> None:
    write_recording(tooled(), tmp_path / "run")
    read = read_recording(tmp_path / "run")
    assert [(tool.name, tool.title) for tool in read.tools] == [("hand", "A hand"), ("adapter", "An adapter")]
    for tool, original in zip(read.tools, TOOLS, strict=True):
        np.testing.assert_array_equal(tool.parameters.phi, original.parameters.phi)
        np.testing.assert_array_equal(tool.std, original.std)


def test_the_reference_is_of_the_workpiece_and_that_of_the_whole_has_the_tools(tmp_path: Path) -> None:
    write_recording(tooled(), tmp_path / "run")
    read = read_recording(tmp_path / "run")
    reference, whole, alone = read.reference, read.reference_of_whole, recording().reference
    assert reference is not None
    assert whole is not None
    assert alone is not None
    np.testing.assert_array_equal(reference.phi, alone.phi)
    np.testing.assert_allclose(whole.phi, alone.phi + 2 * HAND.phi)
    assert read.source_of_whole == "CAD; with hand, adapter"


def test_without_tools_nothing_is_written_of_them(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "run")
    assert "tools" not in json.loads((tmp_path / "run" / "recording.json").read_text())
    read = read_recording(tmp_path / "run")
    assert read.tools == ()
    assert read.reference is not None
    assert read.reference_of_whole is not None
    np.testing.assert_array_equal(read.reference_of_whole.phi, read.reference.phi)
    assert read.source_of_whole == "CAD"


BROKEN: dict[str, tuple[Callable[[dict[str, Any]], object], str]] = {
    "no mass": (lambda tool: tool.pop("mass"), "tools.0.mass"),
    "a negative mass": (lambda tool: tool.update(mass=-1.0), "tools.0.mass: found -1.0"),
    "a negative std": (lambda tool: tool.update(mass_std=-0.1), "tools.0.mass_std: found -0.1"),
    "a misspelt key": (lambda tool: tool.update(inertia_sdt=tool.pop("inertia_std")), "tools: inertia_sdt: found an unknown key"),
    "no body": (lambda tool: tool.update(inertia=[0.1, 0.0, 0.0, 0.001, 0.0, 0.001]), "tools: hand: .* a rigid body can have"),
    "a path as name": (lambda tool: tool.update(name="../hand"), "tools.0.name"),
}


@pytest.mark.parametrize("what", list(BROKEN))
def test_a_tool_that_cannot_be_is_refused_with_its_key(what: str, tmp_path: Path) -> None:
    damage, said = BROKEN[what]
    write_recording(tooled(), tmp_path / "run")
    file = tmp_path / "run" / "recording.json"
    content = json.loads(file.read_text())
    damage(content["tools"][0])
    file.write_text(json.dumps(content))
    with pytest.raises(BadRecording, match=said):
        read_recording(tmp_path / "run")
