"""A case of the plan from its seed to its folder, and the truth about it: as the fourth stranger's are made."""

from __future__ import annotations

from bench.fourth_stranger.making import Truth, make_case

__all__ = ["Truth", "make_case"]
