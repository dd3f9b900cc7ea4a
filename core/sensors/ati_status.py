"""What an ATI box says of a sample in its 32-bit status word.

The bits of the Net Box (Net F/T manual, 9620-05-NET FT, system status code) and of the sensors with the electronics inside (Ethernet Axia
manual, 9610-05-Ethernet Axia, status code) differ. Bits that no table names count as errors.
"""

from __future__ import annotations

from core.words.message import Message

SATURATED, TEMPERATURE, SUPPLY, GAUGE = "saturated", "temperature", "supply", "gauge"
CALIBRATION, INNER, BUSY, SIMULATED = "calibration", "inner", "busy", "simulated"

NET_BOX = {
    2: TEMPERATURE, 3: SUPPLY, 4: INNER, 5: SUPPLY, 6: SUPPLY, 7: GAUGE, 8: GAUGE, 9: GAUGE, 10: INNER, 17: SATURATED, 23: CALIBRATION,
    24: CALIBRATION, 25: CALIBRATION, 27: INNER,
}  # fmt: skip
AXIA = {0: TEMPERATURE, 1: SUPPLY, 2: GAUGE, 3: BUSY, 7: CALIBRATION, 27: SATURATED, 28: SIMULATED, 29: CALIBRATION, 30: SATURATED}
CODES = {
    SATURATED: "sensors-fault-saturated",
    TEMPERATURE: "sensors-fault-temperature",
    SUPPLY: "sensors-fault-supply",
    GAUGE: "sensors-fault-gauge",
    CALIBRATION: "sensors-fault-calibration",
    INNER: "sensors-fault-inner",
    BUSY: "sensors-fault-busy",
    SIMULATED: "sensors-fault-simulated",
}
"""The message of each kind of fault, the gravest first."""
CONDITION, ANY = 1 << 16, 1 << 31
"""A condition that somebody set was met, which says nothing of the measurement; any bit at all is set."""


def find_fault(status: int, *, axia: bool) -> Message | None:
    """Why a sample with this status is no measurement; None where it is one."""
    left = status & ~(CONDITION | ANY)
    if left == 0 and (status & CONDITION or not status):
        return None
    kinds = {name for bit, name in (AXIA if axia else NET_BOX).items() if left >> bit & 1}
    kind = next((name for name in CODES if name in kinds), INNER)
    return Message.of(CODES[kind], status=f"0x{status:08X}")
