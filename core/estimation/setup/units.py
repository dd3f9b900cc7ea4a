"""Units that people write by mistake: how many of them make one of the unit that is meant."""

from __future__ import annotations

FORCE_UNITS = {"kgf": 1.0 / 9.80665, "lbf": 1.0 / 4.4482216, "gf": 1000.0 / 9.80665, "cN": 100.0, "mN": 1000.0, "kN": 0.001}
"""Numbers of each in one newton."""
TORQUE_UNITS = {
    "N mm": 1000.0,
    "N cm": 100.0,
    "lbf in": 8.8507458,
    "lbf ft": 0.73756215,
    "kgf m": 1.0 / 9.80665,
    "kgf cm": 100.0 / 9.80665,
}
"""Numbers of each in one newton metre."""
TIME_UNITS = {"ms": 1e3, "us": 1e6, "ns": 1e9, "min": 1.0 / 60.0}
"""Numbers of each in one second."""
MILLIMETRES = 1e3
