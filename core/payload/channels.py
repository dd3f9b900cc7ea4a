"""The six channels of a wrist sensor, in the order of every wrench, and their units."""

from __future__ import annotations

CHANNELS = ("fx", "fy", "fz", "tx", "ty", "tz")
UNITS = ("N", "N", "N", "N m", "N m", "N m")
