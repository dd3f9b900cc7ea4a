"""What the links of an arm ask of its joints along a run, without its payload."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial
from typing import NamedTuple

from core.array import Array


class LinkLoads(NamedTuple):
    """One row for each of the run's, of the arm without payload.

    Args:
        inertia: (N, n, n), in joint coordinates, kg m2.
        torque: (N, n), that the arm asks of its joints, N m.
        moment: (N, 3), first moment of the arm's masses about the base's origin, base frame, kg m.
    """

    inertia: Array
    torque: Array
    moment: Array


class LazyLinkLoads:
    """Found when first asked for: where a gap lies is told without them, and they take a quarter of the time for it.

    Args:
        find: once.
    """

    def __init__(self, find: Callable[[], LinkLoads]) -> None:
        self._find = find

    @cached_property
    def loads(self) -> LinkLoads:
        """Of all rows."""
        return self._find()

    def find(self) -> None:
        """Before anybody asks."""
        _ = self.loads

    def __getitem__(self, rows: slice) -> LazyLinkLoads:
        """Some rows, of which all are found together."""
        return LazyLinkLoads(partial(_cut, self, rows))


def _cut(links: LazyLinkLoads, rows: slice) -> LinkLoads:
    return LinkLoads(*(each[rows] for each in links.loads))
