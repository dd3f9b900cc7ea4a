"""Numbers as they are written into JSON: rounded to significant digits, whatever they stand in."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np


def round_all(value: object, digits: int = 6) -> object:
    """Plain dictionaries, lists and numbers; texts and whole numbers stay as they are."""
    if isinstance(value, Mapping):
        return {str(key): round_all(each, digits) for key, each in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [round_all(each, digits) for each in value]
    if isinstance(value, (float, np.floating)):
        return float(f"{float(value):.{digits}g}")
    return int(value) if isinstance(value, np.integer) else value
