"""What a recording states of its sensor and payload against what its samples show: a factor between them that is a unit's is no chance."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from core.array import Array
from core.estimation.kinematics import white_noise_std
from core.estimation.setup.payload_fit import PayloadFit
from core.estimation.setup.stances import FORCE, TORQUE
from core.estimation.setup.units import FORCE_UNITS, TORQUE_UNITS
from core.payload.channels import CHANNELS
from core.recording.recording import Recording
from core.words.message import Message

FEWEST_ROWS = 200
"""Of which noise and resolution can be read."""
OF_NOISE = 0.12
"""Share by which a ratio of noises may miss a unit's: quantisation alone makes a few percent."""
OF_RESOLUTION = 0.01
OF_REFERENCE = 0.04
LARGEST_UNITY = 1.4
"""A ratio of noises between this and its inverse is none."""
BEYOND, FAR_BEYOND = 1.3, 4.0
"""Times the range that few sensors read, and that none does."""


def units_by_figures(recording: Recording, fit: PayloadFit) -> tuple[Message, ...]:
    """Units other than N and N m that what is stated speaks for, the force's before the torque's."""
    force = next((name for name in _by_resolution(recording, FORCE, FORCE_UNITS)), None)
    torque = next((name for name in _by_resolution(recording, TORQUE, TORQUE_UNITS)), None)
    if force is None and torque is None:
        force, torque = _by_reference(recording, fit)
    if force is None and torque is None:
        force, torque = _by_noise(recording)
    said = () if force is None else (Message.of("setup-force-in", unit=force),)
    return said if torque is None else (*said, Message.of("setup-torque-in", unit=torque))


def beyond_range(recording: Recording, times_range: float = BEYOND) -> Message | None:
    """The channel that leaves the sensor's range furthest behind, if by so many times."""
    if recording.wrench is None or recording.sensor.range is None:
        return None
    largest = np.abs(recording.wrench).max(axis=0)
    times = largest / recording.sensor.range
    worst = int(np.argmax(times))
    if times[worst] < times_range:
        return None
    units = FORCE_UNITS if worst < 3 else TORQUE_UNITS
    code = "setup-force-beyond-range" if worst < 3 else "setup-torque-beyond-range"
    fitting = [unit for unit, k in units.items() if 0.005 < times[worst] / k < 1.0 and k > 1.0]
    return Message.of(
        code, channel=CHANNELS[worst], largest=float(largest[worst]), range=float(recording.sensor.range[worst]), units=fitting
    )


def _by_resolution(recording: Recording, channels: slice, units: Mapping[str, float]) -> Iterator[str]:
    """From the steps of the values."""
    stated = recording.sensor.resolution
    if stated is None or recording.wrench is None or len(recording) < FEWEST_ROWS:
        return
    ratio = np.array([_step(column) for column in recording.wrench[:, channels].T]) / stated[channels]
    for unit, k in units.items():
        if (np.abs(ratio / k - 1.0) < OF_RESOLUTION).sum() >= 2:
            yield unit


def _step(x: Array) -> float:
    """Of which all values are multiples, but for an offset; NaN where there is none."""
    values = np.unique(x)
    if not 3 <= len(values) < len(x) / 2:
        return np.nan
    apart = np.diff(values)
    step = float(np.median(apart[apart < 1.5 * apart.min()]))
    multiples = apart / step
    return step if np.abs(multiples - np.round(multiples)).max() < 0.05 else np.nan


def _by_noise(recording: Recording) -> tuple[str | None, str | None]:
    """All three channels of one kind, the others as stated; or all six."""
    stated = recording.sensor.noise_std
    if stated is None or recording.wrench is None or len(recording) < FEWEST_ROWS:
        return None, None
    ratio = white_noise_std(recording.t, recording.wrench) / stated
    force, torque = (_match(ratio[part], units) for part, units in ((FORCE, FORCE_UNITS), (TORQUE, TORQUE_UNITS)))
    usual = [bool(((ratio[part] < LARGEST_UNITY) & (ratio[part] > 1.0 / LARGEST_UNITY)).all()) for part in (FORCE, TORQUE)]
    if force is not None and torque is not None:
        return force, torque
    return (force if usual[1] else None), (torque if usual[0] else None)


def _match(ratio: Array, units: Mapping[str, float]) -> str | None:
    return next((unit for unit, k in units.items() if (np.abs(ratio / k - 1.0) < OF_NOISE).all() and abs(k - 1.0) > 0.5), None)


def _by_reference(recording: Recording, fit: PayloadFit) -> tuple[str | None, str | None]:
    """The mass is the reference's in another unit, the first moment as well or as it should be."""
    known = recording.reference_of_whole
    size = float(np.linalg.norm(known.first_moment)) if known is not None else 0.0
    if known is None or size == 0.0 or not (fit.upright or fit.upside_down):
        return None, None
    mass, moment = abs(fit.mass) / known.mass, float(np.linalg.norm(fit.first_moment)) / size
    force, torque = _nearest(mass, FORCE_UNITS), _nearest(moment, TORQUE_UNITS)
    return (force if torque is not None or _is_one(moment) else None), (torque if force is not None or _is_one(mass) else None)


def _nearest(ratio: float, units: Mapping[str, float]) -> str | None:
    return next((unit for unit, k in units.items() if abs(ratio / k - 1.0) < OF_REFERENCE and abs(k - 1.0) > 0.5), None)


def _is_one(ratio: float) -> bool:
    return 0.8 < ratio < 1.25
