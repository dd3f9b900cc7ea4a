"""The order that a recording was made for stays with it."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from core.errors import BadRecording
from core.recording.folder import read_recording, write_recording
from core.recording.order_reference import NO_ORDER, OrderReference
from core.recording.recording import append_recording
from tests.core.recording.recording_damage import change_manifest
from tests.core.recording.small_recording import recording

ORDER = OrderReference(order_id="JO-1", serial_number="SN-3")


def test_it_is_written_into_the_manifest_and_read_back(tmp_path: Path) -> None:
    write_recording(replace(recording(), order=ORDER), tmp_path / "recording")
    assert json.loads((tmp_path / "recording" / "recording.json").read_text())["order"] == {"order_id": "JO-1", "serial_number": "SN-3"}
    assert read_recording(tmp_path / "recording").order == ORDER


def test_a_recording_without_an_order_says_nothing_of_it(tmp_path: Path) -> None:
    write_recording(recording(), tmp_path / "recording")
    assert "order" not in json.loads((tmp_path / "recording" / "recording.json").read_text())
    assert read_recording(tmp_path / "recording").order == NO_ORDER
    assert not NO_ORDER


def test_a_continued_recording_is_of_the_newest_order_that_somebody_named() -> None:
    first, second = replace(recording(), order=ORDER), recording()
    assert append_recording(first, second).order == ORDER
    newer = OrderReference(order_id="JO-2")
    assert append_recording(first, replace(second, order=newer)).order == newer


@pytest.mark.parametrize("value", ["x" * 101, 7])
def test_what_is_no_name_is_refused_with_its_key(value: object, tmp_path: Path) -> None:
    write_recording(replace(recording(), order=ORDER), tmp_path / "recording")
    change_manifest(tmp_path / "recording", lambda manifest: manifest["order"].update(order_id=value))
    with pytest.raises(BadRecording, match=r"order\.order_id"):
        read_recording(tmp_path / "recording")
