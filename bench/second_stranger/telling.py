"""What a truth tells of a case, whoever made it: sizes, what is to be seen, and the variant in words."""

from __future__ import annotations

from collections.abc import Sequence

from bench.second_stranger.array import Array
from bench.second_stranger.fault import Fault, Planted, Size
from bench.second_stranger.reading import Reading, Reference
from bench.second_stranger.sizing import Yardstick


def find_temperature(faults: Sequence[Fault]) -> Array | None:
    """(N,), degrees Celsius, of the last that has one."""
    return next((fault.temperature for fault in reversed(faults) if fault.temperature is not None), None)


def tell_sizes(planted: Sequence[Planted], reading: Reading, reference: Reference) -> list[Size]:
    """Of the causes, then of what is read off beside them."""
    of_faults = [fault.size(scale) for fault, scale in planted]
    rounded = [size._replace(value=float(f"{size.value:.6g}")) for size in of_faults]
    return rounded + [size for size in (reading.size, reference.size) if size is not None]


def measure_seen(
    whole: Yardstick, yardstick: Yardstick, planted: Sequence[Planted], each: list[float], reading: Reading
) -> tuple[float, list[float]]:
    """What is to be seen of all causes, over what counts of the recording, and the rms of each, in noise standard deviations."""
    if reading.changed is not None:
        seen = whole.measure_reading(reading.changed)
        return seen, [seen / whole.root_count]
    return (yardstick.measure(planted), each) if planted else (0.0, [0.0] * (reading.size is not None))


def describe_variant(name: str, sizes: Sequence[Size]) -> str:
    """Of an order's name, its causes joined by plus signs, and their sizes."""
    causes = name.replace("_", " ").split("+")
    return " + ".join(f"{cause}: {size.what}" for cause, size in zip(causes, sizes, strict=True))
