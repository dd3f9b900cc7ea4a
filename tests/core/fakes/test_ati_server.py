"""The box against the layout that the maker's manual prints, byte by byte; no driver takes part."""

from __future__ import annotations

import socket
import struct
import urllib.request
import xml.etree.ElementTree as ET

from core.fakes.ati_server import AtiServer


def test_a_record_is_36_bytes_in_network_order_with_counts_of_the_page():
    wrench = (1.5, -2.25, 30.125, 0.5, -0.25, 0.125)
    with AtiServer(lambda _: wrench, first_packet=40, status=lambda _: 0x80010000) as server:
        with urllib.request.urlopen(f"http://127.0.0.1:{server.http_port}/netftapi2.xml", timeout=10.0) as answer:
            page = ET.fromstring(answer.read())
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            client.settimeout(10.0)
            client.sendto(bytes.fromhex("1234 0002 00000000"), ("127.0.0.1", server.rdt_port))
            record = client.recv(100)
    assert len(record) == 36
    assert int.from_bytes(record[:4], "big") == 41
    assert record[8:12] == bytes.fromhex("80010000")
    per_force, per_torque = int(page.findtext("cfgcpf") or 0), int(page.findtext("cfgcpt") or 0)
    counts = struct.unpack("!6i", record[12:])
    assert [count / per for count, per in zip(counts, [per_force] * 3 + [per_torque] * 3, strict=True)] == list(wrench)
    assert (page.findtext("scfgfu"), page.findtext("scfgtu")) == ("N", "Nm")
