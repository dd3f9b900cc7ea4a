"""Where the gap lies: the nominal twin's residual by channel, motion and frequency band, by direction and by time."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.fft import dct

from core.array import interpolate
from core.gap.effect_fit import EffectFit
from core.gap.windows import Windows
from core.payload.channels import CHANNELS
from core.words.message import Message

BANDS_HZ = ((0.0, 2.0), (2.0, 10.0))


@dataclass(frozen=True)
class Patch:
    """One channel in one kind of motion and one band.

    Args:
        times_noise: root mean square in standard deviations of the noise of these rows; 1 is noise alone.
        share: of the whole excess over noise.
    """

    channel: str
    phase: str
    band_hz: tuple[float, float]
    times_noise: float
    share: float


class Residual:
    """The residual of a fit, taken apart.

    Args:
        windows: of the recording.
        fit: whose residual it is.
    """

    def __init__(self, windows: Windows, fit: EffectFit) -> None:
        self._windows = windows
        self._rows = fit.residual

    @cached_property
    def patches(self) -> tuple[Patch, ...]:
        """All patches, the largest share first."""
        energy: dict[tuple[int, str, int], tuple[float, int]] = {}
        step = self._windows.step
        for g in np.unique(self._windows.group):
            rows = np.flatnonzero(self._windows.group == g)
            phase = str(self._windows.phase[rows[0]])
            power = dct(self._rows[:, rows], norm="ortho", axis=1) ** 2
            frequency = np.arange(len(rows)) / (2.0 * len(rows) * step)
            for b, (low, high) in enumerate(BANDS_HZ):
                inside = (frequency >= low) & (frequency < high)
                for c in range(6):
                    before, count = energy.get((c, phase, b), (0.0, 0))
                    energy[c, phase, b] = (before + float(power[c, inside].sum()), count + int(inside.sum()))
        excess = sum(max(0.0, total - count) for total, count in energy.values()) or 1.0
        found = [
            Patch(CHANNELS[c], phase, BANDS_HZ[b], float(np.sqrt(total / count)), max(0.0, total - count) / excess)
            for (c, phase, b), (total, count) in energy.items()
            if count
        ]
        return tuple(sorted(found, key=lambda patch: -patch.share))

    def by_time(self, parts: int = 10) -> list[float]:
        """Share of the excess in equal stretches of the recording."""
        excess = np.maximum(0.0, (self._rows**2).sum(axis=0) - 6.0)
        total = float(excess.sum()) or 1.0
        return [float(part.sum()) / total for part in np.array_split(excess, parts)]

    def worst_stretch(self, parts: int = 10) -> tuple[float, float]:
        """Begin and end of the largest of these stretches, s."""
        shares = self.by_time(parts)
        worst = np.array_split(self._windows.centres, parts)[int(np.argmax(shares))]
        return float(worst[0]), float(worst[-1])

    def by_direction(self) -> dict[str, float]:
        """Mean square (noise is 1) while turning positively, negatively, and standing still; axis of the largest rate."""
        scene = self._windows.basis.scene
        omega = interpolate(self._windows.centres, scene.t, scene.motion.omega)
        largest = omega[np.arange(len(omega)), np.abs(omega).argmax(axis=1)]
        kinds = {"positive": largest > 0.05, "negative": largest < -0.05, "still": np.abs(largest) <= 0.05}
        return {name: float(np.mean(self._rows[:, rows] ** 2)) for name, rows in kinds.items() if rows.any()}

    def by_pose(self) -> dict[str, float]:
        """Mean square (noise is 1) by the sensor axis that is nearest to gravity, `+` along it and `-` against it."""
        scene = self._windows.basis.scene
        g = interpolate(self._windows.centres, scene.t, scene.motion.g)
        nearest = np.abs(g).argmax(axis=1)
        names = np.array([f"{'xyz'[k]}{'+' if g[row, k] > 0 else '-'}" for row, k in enumerate(nearest)])
        return {str(name): float(np.mean(self._rows[:, names == name] ** 2)) for name in np.unique(names)}

    def describe(self) -> Message:
        """Where it is largest."""
        top = self.patches[0]
        low_hz, high_hz = top.band_hz
        return Message.of(
            "gap-largest",
            channel=top.channel,
            phase=_say_phase(top.phase),
            low_hz=low_hz,
            high_hz=high_hz,
            times=top.times_noise,
            share=top.share,
        )


def _say_phase(phase: str) -> Message:
    """`hold:x+`, `rotate:z` or `transfer`; another label as it is."""
    kind, _, axis = phase.partition(":")
    match kind:
        case "hold":
            return Message.of("gap-phase-hold", axis=axis)
        case "rotate":
            return Message.of("gap-phase-rotate", axis=axis)
        case "transfer":
            return Message.of("gap-phase-transfer")
        case _:
            return Message.of("text", text=phase)
