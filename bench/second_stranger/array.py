"""The type of nearly every number."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Doubles; docstrings say their shape and unit."""
