"""The driver against a box that was written from the manual alone: what is on the wire becomes newtons, and nothing else does."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable

import numpy as np
import pytest

from core.errors import BadState, NotConnected, UnusableSensor
from core.fakes.ati_server import AtiServer, LossyLine, Setup
from core.sensors.ati_net_ft import NetFt
from core.sensors.ati_status import find_fault
from core.sensors.sensor import Reading

WRENCH = (1.5, -2.25, 30.125, 0.5, -0.25, 0.125)


def still(_: float) -> tuple[float, ...]:
    return WRENCH


def driver(server: AtiServer, calibration: str | None = None) -> NetFt:
    return NetFt("127.0.0.1", rdt_port=server.rdt_port, http_port=server.http_port, calibration=calibration)


def read(sensor: NetFt, enough: Callable[[list[Reading]], bool]) -> list[Reading]:
    """Until it is enough."""
    found: list[Reading] = []
    give_up = time.monotonic() + 30.0
    while not enough(found):
        found += sensor.read(0.1)
        assert time.monotonic() < give_up, f"{len(found)} readings"
    return found


def at_least(count: int) -> Callable[[list[Reading]], bool]:
    return lambda found: len(found) >= count


@pytest.mark.parametrize(
    "setup",
    [
        Setup(),
        Setup(force_unit="lbf", torque_unit="lbf-in", newton=4.4482216152605, newton_metre=0.1129848290276167, per_force=9_000_000),
        Setup(force_unit="kN", torque_unit="N-mm", newton=1000.0, newton_metre=0.001, per_torque=1000),
        Setup(force_unit="kgf", torque_unit="kgf-cm", newton=9.80665, newton_metre=0.0980665),
    ],
    ids=lambda setup: f"{setup.force_unit}, {setup.torque_unit}",
)
def test_whatever_units_the_box_is_set_to_newtons_and_newton_metres_are_read(setup: Setup):
    with AtiServer(still, setup=setup) as server, driver(server, setup.serial) as sensor:
        readings = read(sensor, at_least(20))
        assert sensor.configuration is not None
        np.testing.assert_allclose(
            sensor.configuration.range, np.array([145, 145, 290, 5, 5, 5]) * ([setup.newton] * 3 + [setup.newton_metre] * 3)
        )
    for reading in readings:
        np.testing.assert_allclose(reading.wrench, WRENCH, atol=2e-3)
        assert reading.fault is None


def test_the_bias_command_is_never_sent_and_the_stream_is_ended():
    with AtiServer(still) as server:
        with driver(server) as sensor:
            read(sensor, at_least(5))
        give_up = time.monotonic() + 10.0
        while server.commands[-1] != (0, 0) or len(server.commands) < 3:
            assert time.monotonic() < give_up
            time.sleep(0.01)
        assert server.commands == [(0, 0), (2, 0), (0, 0)]


def test_a_bias_and_a_filter_that_somebody_set_are_told():
    setup = Setup(bias="745;17;447;184;-596;-253", low_pass=2)
    with AtiServer(still, setup=setup) as server, driver(server) as sensor:
        assert [remark.code for remark in sensor.remarks()] == ["sensors-filtered", "sensors-biased"]


@pytest.mark.parametrize("first_packet", [0, 2**32 - 30])
def test_lost_repeated_and_overtaken_packets_are_counted_and_none_is_read_twice(first_packet: int):
    line = LossyLine(lost=0.05, repeated=0.05, jitter_s=0.02)
    with AtiServer(still, line=line, first_packet=first_packet, first_sample=2**32 - 300, seed=1) as server, driver(server) as sensor:
        readings = read(sensor, at_least(600))
    stamps = [reading.stamp_s for reading in readings]
    assert len(set(stamps)) == len(stamps) == sensor.tally.received
    steps = np.round(np.diff(np.sort(stamps)) * 1000).astype(int)
    assert steps.min() == 1  # 1 kHz, in order on its own clock, across both wraps
    assert sensor.tally.lost == int((steps - 1).sum())
    assert sensor.tally.lost_share > 0.01
    assert sensor.tally.repeated > 0 and sensor.tally.overtaken > 0


def test_what_is_no_record_is_counted_and_left_out():
    with AtiServer(still) as server, driver(server) as sensor:
        here = sensor._socket.getsockname()
        server._rdt.sendto(b"x" * 35, here)
        stranger = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        stranger.sendto(b"\x7f" * 36, here)
        readings = read(sensor, lambda found: sensor.tally.malformed > 0 and len(found) > 50)
        stranger.close()
    assert sensor.tally.malformed == 1
    assert all(np.allclose(reading.wrench, WRENCH, atol=1e-5) for reading in readings)


def test_a_sample_that_the_box_calls_saturated_says_so_and_a_condition_that_somebody_set_does_not():
    def status(t: float) -> int:
        return {0: 0, 1: 0x80010000}.get(int(t * 20) % 3, 0x80020000)

    with AtiServer(still, status=status) as server, driver(server) as sensor:
        readings = read(sensor, lambda found: sum(reading.fault is not None for reading in found) > 60)
    told = {reading.fault.text for reading in readings if reading.fault is not None}
    assert len(told) == 1 and "saturated (status 0x80020000)" in told.pop()
    assert sum(reading.fault is None for reading in readings) > 50


@pytest.mark.parametrize(("bit", "axia"), [(bit, axia) for bit in range(32) for axia in (False, True)])
def test_every_error_bit_is_a_fault_but_for_a_condition(bit: int, axia: bool):
    fault = find_fault(1 << bit, axia=axia)
    assert (fault is None) == (bit == 16)


def test_saturation_is_told_before_all_else_and_by_the_bits_of_the_box_at_hand():
    assert find_fault(0x80020004, axia=False).code == "sensors-fault-saturated"
    assert find_fault(0xC0000001, axia=True).code == "sensors-fault-saturated"
    assert find_fault(0x80000001, axia=True).code == "sensors-fault-temperature"
    assert find_fault(0, axia=True) is None


def test_a_box_that_counts_from_the_beginning_is_noticed():
    with AtiServer(still, first_packet=100_000) as server, driver(server) as sensor:
        read(sensor, at_least(5))
        server._first_packet = 0
        other = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        other.close()
        with pytest.raises(BadState, match="counts its samples from the beginning"):
            read(sensor, at_least(100_000))


def test_a_sensor_that_stops_is_silent_and_one_that_never_sends_is_refused():
    with AtiServer(still, line=LossyLine(silent=lambda t: t > 0.3)) as server, driver(server) as sensor:
        readings = read(sensor, at_least(100))
        time.sleep(0.5)
        readings += sensor.read()
        assert sensor.read(0.2) == []
    assert max(reading.stamp_s for reading in readings) - readings[0].stamp_s < 0.35
    with AtiServer(still, line=LossyLine(silent=lambda _: True)) as server, pytest.raises(NotConnected, match="no firewall keeps UDP"):
        driver(server).__enter__()


@pytest.mark.parametrize(
    ("setup", "words"),
    [
        (Setup(serial="FT00001"), "uses the calibration FT00001, the cell expects FT27462"),
        (Setup(transform="0;0;132.71;0;0;0"), "tool transform 0; 0; 132.71; 0; 0; 0"),
        (Setup(rdt="Disabled"), "RDT is switched off"),
        (Setup(status=0x80000020), "wrong supply voltage"),
        (Setup(force_unit="stone"), "<scfgfu> is 'stone'"),
        (Setup(per_force=0), "<cfgcpf> is '0'"),
        (Setup(leave_out=("cfgcpt",)), "<cfgcpt> is '-'"),
        (Setup(bias="1;2;x"), "<setbias> is '1;2;x'"),
        (Setup(product='</prodname><!ENTITY a "b">'), "cannot be used"),
        (Setup(product="<open>"), "cannot be used"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_a_box_that_is_set_up_otherwise_is_refused_with_what_was_found(setup: Setup, words: str):
    with AtiServer(still, setup=setup) as server:
        with pytest.raises(UnusableSensor) as refused:
            driver(server, "FT27462").__enter__()
        assert server.commands == []
    assert words in str(refused.value)
    assert "Nothing has moved" in str(refused.value)


def test_an_older_firmware_tells_its_calibration_on_a_page_of_its_own():
    with AtiServer(still, setup=Setup(leave_out=("cfgcalsn",))) as server, driver(server, "FT27462") as sensor:
        assert sensor.configuration is not None and sensor.configuration.calibration == "FT27462"


def test_nobody_there_is_told_in_words():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with pytest.raises(NotConnected, match=rf"does not answer on port {port}"):
        NetFt("127.0.0.1", http_port=port).__enter__()


def test_the_boxs_own_clock_stamps_the_samples_whatever_the_line_does():
    line = LossyLine(jitter_s=0.02, delay_s=0.005)
    with AtiServer(lambda t: (t, 0, 0, 0, 0, 0), line=line, drift=50e-6) as server, driver(server) as sensor:
        readings = read(sensor, at_least(300))
        for reading in readings:
            assert reading.stamp_s * 7000 == pytest.approx(server.stamp(reading.wrench[0]), abs=1.0)
            assert reading.arrival_s - server.zero_s > reading.wrench[0] + 0.0049
