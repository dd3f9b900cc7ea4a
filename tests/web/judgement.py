"""What a screen has to be like, whichever it is."""

from __future__ import annotations

import colorsys
import re
from collections.abc import Sequence
from itertools import combinations
from typing import Any

from tests.web.looks import Look

TARGET_PX, MOTION_TARGET_PX, AROUND_PX = 48, 72, 16


def check_looks(looks: Sequence[Look]) -> None:
    """Everything that holds for every screen."""
    for check in (check_axe, check_targets, check_room_round_what_moves, check_colours_of_the_abnormal, check_nothing_is_cut_off):
        check(looks)


def check_axe(looks: Sequence[Look]) -> None:
    """axe finds nothing, at a contrast of 7:1."""
    found = {
        each.name: [
            (flaw["id"], node["target"], node.get("failureSummary", "")[:200]) for flaw in each.violations for node in flaw["nodes"]
        ]
        for each in looks
    }
    assert {name: flaws for name, flaws in found.items() if flaws} == {}


def check_targets(looks: Sequence[Look]) -> None:
    """They are large, and larger where they move the robot."""
    for each in looks:
        assert each.targets, each.name
        for target in each.targets:
            least = MOTION_TARGET_PX if target["moves"] else TARGET_PX
            assert min(target["width"], target["height"]) >= least, (each.name, target)


def check_room_round_what_moves(looks: Sequence[Look]) -> None:
    """Nothing else is near."""
    for each in looks:
        seen = [target for target in each.targets if target["place"]["height"] > 0]
        for one, other in combinations(seen, 2):
            if one["moves"] or other["moves"]:
                assert between_px(one["place"], other["place"]) >= AROUND_PX, (each.name, one, other)


def between_px(one: dict[str, Any], other: dict[str, Any]) -> float:
    """The room between two rectangles."""
    gaps = [max(one[a] - other[a] - other[size], other[a] - one[a] - one[size]) for a, size in (("x", "width"), ("y", "height"))]
    return float(max(gaps))


def check_colours_of_the_abnormal(looks: Sequence[Look]) -> None:
    """Red and yellow stand nowhere else."""
    for each in looks:
        normal = [said for said in each.colours if not said["abnormal"]]
        assert [said for said in normal if is_red(said["colour"]) or is_yellow(said["colour"])] == [], each.name


def check_nothing_is_cut_off(looks: Sequence[Look]) -> None:
    """Every text has its place, inside the screen."""
    found = {each.name: each.cut for each in looks if each.cut}
    assert found == {}, found


def hls(colour: str) -> tuple[float, float, float]:
    """Hue in degrees, lightness, saturation of what CSS says; what is transparent has no colour."""
    red, green, blue, *alpha = (float(number) for number in re.findall(r"[\d.]+", colour))
    if alpha and alpha[0] == 0.0:
        return 0.0, 0.0, 0.0
    hue, light, saturated = colorsys.rgb_to_hls(red / 255, green / 255, blue / 255)
    return 360 * hue, light, saturated


def saturation(colour: str) -> float:
    """How far from grey: chroma, so that near black and white count as grey."""
    _, light, saturated = hls(colour)
    return saturated * (1 - abs(2 * light - 1))


def is_red(colour: str) -> bool:
    hue, _, _ = hls(colour)
    return saturation(colour) > 0.2 and (hue < 20 or hue > 340)


def is_yellow(colour: str) -> bool:
    return saturation(colour) > 0.2 and 30 < hls(colour)[0] < 70


def is_green(colour: str) -> bool:
    return saturation(colour) > 0.2 and 80 < hls(colour)[0] < 165
