"""The sensor that a cell names, ready to be entered. This is the one place that opens them."""

from __future__ import annotations

from pathlib import Path

from core.cell.session import BotaSensor, ExternalSensor, NetFtSensor, RobotiqSensor
from core.sensors.ati_net_ft import NetFt
from core.sensors.background import BackgroundSensor
from core.sensors.bota_serial import BotaSerial
from core.sensors.robotiq_ft300 import RobotiqFt300
from core.sensors.sensor import ForceSensor


def open_sensor(link: ExternalSensor) -> ForceSensor:
    """The sensor of `session.sensor`, read by a thread of its own; it is reached for on entry."""
    return BackgroundSensor(_make(link))


def _make(link: ExternalSensor) -> ForceSensor:
    match link:
        case NetFtSensor():
            return NetFt(link.host, rdt_port=link.rdt_port, http_port=link.http_port, calibration=link.calibration)
        case BotaSensor():
            return BotaSerial(Path(link.port))
        case RobotiqSensor():
            return RobotiqFt300(Path(link.port))
