"""Serial sensors against what is published of their frames, played on a pseudo terminal."""

from __future__ import annotations

import binascii
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from core.errors import BadState, NotConnected
from core.fakes.serial_sensors import START_STREAM, SerialSensor, bota_frame, robotiq_frame
from core.sensors.bota_serial import BotaSerial, find_bota_fault
from core.sensors.robotiq_ft300 import RobotiqFt300
from core.sensors.sensor import ForceSensor, Reading
from core.sensors.serial_line import crc_of

WRENCH = (12.25, -3.5, -30.75, 0.5, -1.25, 0.125)


def still(_: float) -> tuple[float, ...]:
    return WRENCH


def read(sensor: ForceSensor, enough: Callable[[list[Reading]], bool]) -> list[Reading]:
    found: list[Reading] = []
    give_up = time.monotonic() + 30.0
    while not enough(found):
        found += sensor.read(0.1)
        assert time.monotonic() < give_up, f"{len(found)} readings"
    return found


def test_check_sums_are_those_of_their_catalogues():
    """The check values of CRC-16/IBM-SDLC (X-25) and CRC-16/MODBUS; a third party's CRC of another kind for the shifts."""
    assert crc_of(b"123456789", 0x8408, 0xFFFF) == 0x906E
    assert crc_of(b"123456789", 0xA001, 0) == 0x4B37
    mirrored = bytes(int(f"{byte:08b}"[::-1], 2) for byte in b"heft")
    assert crc_of(b"heft", 0x8408, 0) == int(f"{binascii.crc_hqx(mirrored, 0xFFFF):016b}"[::-1], 2)


def test_bota_frames_become_newtons_with_the_sensors_own_stamps_across_their_wrap():
    frame = bota_frame(still, first_us=2**32 - 150_000)
    with SerialSensor(frame, rate_hz=400.0) as server, BotaSerial(server.port) as sensor:
        readings = read(sensor, lambda found: len(found) > 150)
    np.testing.assert_allclose([reading.wrench for reading in readings], [WRENCH] * len(readings))
    steps = np.diff([reading.stamp_s for reading in readings])
    np.testing.assert_allclose(steps, 1 / 400, atol=2e-6)
    assert readings[0].temperature == 31.5
    assert sensor.tally.malformed == sensor.tally.lost == 0


def test_bota_frames_that_are_spoilt_or_missing_are_counted_and_none_of_them_is_read():
    def ramp(t: float) -> tuple[float, ...]:
        return (1000.0 * t, 0.0, 0.0, 0.0, 0.0, 0.0)

    frame = bota_frame(ramp)
    with SerialSensor(frame, rate_hz=400.0, spoilt=0.05, lost=0.05, seed=2) as server, BotaSerial(server.port) as sensor:
        readings = read(sensor, lambda found: found[-1:] != [] and len(found) > 300)
    for reading in readings:
        assert reading.wrench[0] == pytest.approx(1000.0 * reading.stamp_s, abs=1e-2)
    steps = np.round(400 * np.diff([reading.stamp_s for reading in readings])).astype(int)
    assert steps.min() == 1
    assert sensor.tally.lost == int((steps - 1).sum()) > 10
    assert sensor.tally.malformed > 3


@pytest.mark.parametrize(
    ("status", "code"),
    [
        (0, None), (1, "sensors-fault-skipping"), (2, "sensors-fault-saturated"), (4, "sensors-fault-invalid"),
        (8, "sensors-fault-raw"), (6, "sensors-fault-invalid"),
    ],
)  # fmt: skip
def test_what_bota_calls_no_measurement_is_none(status: int, code: str | None):
    fault = find_bota_fault(status, [0.0] * 7)
    assert (None if fault is None else fault.code) == code
    assert find_bota_fault(0, [0.0, float("nan"), *[0.0] * 5]).code == "sensors-fault-not-finite"


def test_a_bota_sensor_whose_clock_begins_anew_is_noticed():
    frame = bota_frame(still)

    def restarted(t: float) -> bytes:
        return frame(t + 50.0 if t < 0.5 else t)

    server = SerialSensor(restarted, rate_hz=200.0)
    with server, BotaSerial(server.port) as sensor, pytest.raises(BadState, match="from the beginning"):
        read(sensor, lambda _: False)


def test_the_robotiq_stream_is_asked_for_as_its_manual_has_it_read_and_ended():
    with SerialSensor(robotiq_frame(still), rate_hz=100.0, on_request=START_STREAM) as server:
        with RobotiqFt300(server.port) as sensor:
            readings = read(sensor, lambda found: len(found) > 60)
            assert "latency of its USB adapter" in sensor.remarks()[0].text
        give_up = time.monotonic() + 10.0
        while not server.heard.endswith(b"\xff" * 50):
            assert time.monotonic() < give_up
            time.sleep(0.01)
        assert server.heard == START_STREAM + b"\xff" * 50
    np.testing.assert_allclose([reading.wrench for reading in readings], [WRENCH] * len(readings), atol=1e-9)
    stamps = np.array([reading.stamp_s for reading in readings])
    assert (np.diff(stamps) > 0.0).all()
    assert stamps[-1] - stamps[0] == pytest.approx(0.01 * (len(stamps) - 1), rel=0.2, abs=0.05)


def test_robotiq_frames_that_are_spoilt_are_left_out():
    server = SerialSensor(robotiq_frame(still), rate_hz=100.0, on_request=START_STREAM, spoilt=0.2, seed=3)
    with server, RobotiqFt300(server.port) as sensor:
        readings = read(sensor, lambda found: len(found) > 60)
    assert sensor.tally.malformed > 3
    np.testing.assert_allclose([reading.wrench for reading in readings], [WRENCH] * len(readings), atol=1e-9)


@pytest.mark.parametrize("kind", [BotaSerial, RobotiqFt300])
def test_a_line_that_is_none_and_one_that_says_nothing_are_told_in_words(kind: type[BotaSerial] | type[RobotiqFt300], tmp_path: Path):
    with pytest.raises(NotConnected, match="cannot be opened"):
        kind(tmp_path / "ttyUSB0").__enter__()
    no_line = tmp_path / "file"
    no_line.write_bytes(b"")
    with pytest.raises(NotConnected, match="cannot be opened"):
        kind(no_line).__enter__()
    with SerialSensor(lambda _: b"\x00" * 8, rate_hz=50.0) as server, pytest.raises(NotConnected, match="sends no frame within 2 s"):
        kind(server.port).__enter__()
