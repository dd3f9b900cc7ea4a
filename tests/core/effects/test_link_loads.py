"""What the links ask of the joints is found when it is needed, and once."""

from __future__ import annotations

import numpy as np

from core.effects.link_loads import LazyLinkLoads, LinkLoads


class Counted:
    """Loads of four rows, and how often they were found."""

    def __init__(self) -> None:
        self.times = 0

    def __call__(self) -> LinkLoads:
        self.times += 1
        rows = np.arange(4.0)
        return LinkLoads(rows[:, None, None] * np.eye(2), np.outer(rows, [1.0, 2.0]), np.outer(rows, [0.0, 0.0, 1.0]))


def test_nothing_is_found_before_it_is_asked_for() -> None:
    find = Counted()
    part = LazyLinkLoads(find)[1:3]
    assert find.times == 0
    assert part.loads.torque.tolist() == [[1.0, 2.0], [2.0, 4.0]]
    assert find.times == 1


def test_all_parts_of_a_run_share_what_was_found_once() -> None:
    find = Counted()
    links = LazyLinkLoads(find)
    first, second = links[:2], links[2:]
    loads = [first.loads, second.loads, first.loads]
    assert find.times == 1
    assert np.vstack([each.moment for each in loads[:2]]).tolist() == links.loads.moment.tolist()
    assert [each.inertia.shape for each in loads] == [(2, 2, 2)] * 3


def test_what_is_found_beforehand_is_not_found_again() -> None:
    find = Counted()
    links = LazyLinkLoads(find)
    links.find()
    assert find.times == 1
    assert links[:2].loads.moment.shape == (2, 3)
    assert find.times == 1
