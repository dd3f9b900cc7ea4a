"""How another device's clock goes against this machine's, from when its samples arrive.

A sample that the device stamps s arrives at a = s + offset + drift s + delay, and a delay is never shorter than the line's own. So all
arrivals lie on or above one line, and what jitters is the distance to it: the line is the lower envelope of the points, which neither late
samples nor lost ones move. Of all lines below every point it is the one with the least sum of distances; it goes through the edge of the
lower convex hull that spans the mean stamp (Moon, Skelly and Towsley, "Estimation and removal of clock skew from network delay
measurements", INFOCOM 1999). Only the earliest arrival of each `BUCKET_S` can be on the envelope, so a minute is a few hundred points.

What the line alone takes, its shortest delay, cannot be told from the offset by anybody who only listens: the mapped times are late by it.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from core.errors import BadState

BUCKET_S = 0.25
"""Of the samples of this time only the one that took least counts."""
WINDOW_S = 60.0
"""What is older does not count: crystals drift with their temperature."""
DRIFT_AFTER_S = 2.0
"""On a shorter stretch the drift is not told from jitter, and none is assumed."""
SURE_AFTER_S = 10.0
"""From then on a drift that no clock has is told."""
MOST_DRIFT = 500e-6
"""No quartz is off by more; a device whose clock seems to be has a wrong rate."""
STEP_S = 0.5
"""A clock whose samples come this much earlier than before, or all of them this much later for `STEP_BUCKETS`, was set."""
STEP_BUCKETS = 12


@dataclass(frozen=True)
class ClockLine:
    """`here = stamp + offset_s + drift (stamp - reference_s)`.

    Args:
        offset_s: at `reference_s`, with the shortest delay of the line.
        drift: seconds that this machine's clock gains on the device's in each second.
        reference_s: a stamp amid those it was found from.
        spread_s: median delay of the samples beyond the shortest.
    """

    offset_s: float
    drift: float
    reference_s: float
    spread_s: float

    def to_here(self, stamp_s: float) -> float:
        """When the device's clock showed `stamp_s`, on this machine's clock, s."""
        return stamp_s + self.offset_s + self.drift * (stamp_s - self.reference_s)

    def to_device(self, here_s: float) -> float:
        """What the device's clock showed at `here_s` of this machine's, s."""
        return self.reference_s + (here_s - self.offset_s - self.reference_s) / (1.0 + self.drift)


class DeviceClock:
    """Finds the line while samples come in, in whatever order.

    Args:
        name: whose clock it is, for messages.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._buckets: deque[tuple[float, float]] = deque()  # (stamp, delay) of the earliest of each bucket, s
        self._bucket = 0
        self._zero: float | None = None  # delays are counted from the first, so that no digits are lost
        self._line: ClockLine | None = None
        self._delays: deque[float] = deque(maxlen=512)

    def add(self, stamp_s: float, arrival_s: float) -> None:
        """A sample with the stamp of its device, and when it arrived on this machine's monotonic clock, s.

        Raises:
            BadState: the device's clock jumped.
        """
        delay = arrival_s - stamp_s
        if self._zero is None:
            self._zero = delay
        delay -= self._zero
        bucket = int(stamp_s // BUCKET_S)
        if not self._buckets or bucket > self._bucket:
            self._close_bucket()
            self._buckets.append((stamp_s, delay))
            self._bucket = bucket
            while stamp_s - self._buckets[0][0] > WINDOW_S:
                self._buckets.popleft()
        elif bucket == self._bucket and delay < self._buckets[-1][1]:
            self._buckets[-1] = (stamp_s, delay)
            if self._line is not None and arrival_s < self._line.to_here(stamp_s):
                self._line = None
        self._delays.append(delay)

    @property
    def ready(self) -> bool:
        """Whether the earliest of two whole buckets is known."""
        return len(self._buckets) > 2

    @property
    def seconds(self) -> float:
        """Of the device's time that the line rests on, s."""
        return self._buckets[-1][0] - self._buckets[0][0] if self._buckets else 0.0

    @property
    def line(self) -> ClockLine:
        """As far as it is known; of the samples so far."""
        if self._line is None:
            self._line = self._find_line()
        return self._line

    def _close_bucket(self) -> None:
        """A bucket is complete: a clock that was set shows in all its samples.

        Raises:
            BadState: it was.
        """
        jump = self._find_jump()
        if abs(jump) > STEP_S:
            raise BadState("sensors-clock-jumped", device=self._name, value=jump, limit=STEP_S)
        self._line = None

    def _find_jump(self) -> float:
        """How much earlier the last bucket was than anything before, negative, or how much later all of the last ones are, s."""
        points = list(self._buckets)
        if len(points) <= STEP_BUCKETS:
            return 0.0
        earlier = points[-1][1] - min(delay for _, delay in points[:-1])
        if earlier < -STEP_S:
            return earlier
        older = min(delay for _, delay in points[:-STEP_BUCKETS])
        return max(0.0, min(delay for _, delay in points[-STEP_BUCKETS:]) - older)

    def _find_line(self) -> ClockLine:
        points = list(self._buckets)
        assert points and self._zero is not None
        reference = sum(stamp for stamp, _ in points) / len(points)
        drift = self._drift(points, reference) if self.seconds >= DRIFT_AFTER_S else 0.0
        least = min(delay - drift * (stamp - reference) for stamp, delay in points)
        late = [delay - least for delay in self._delays]
        return ClockLine(self._zero + least, drift, reference, median(late))

    def _drift(self, points: list[tuple[float, float]], reference: float) -> float:
        """Slope of the edge of the lower hull over the mean stamp.

        Raises:
            BadState: no clock is off by so much; the device's samples come at another rate than it says.
        """
        hull: list[tuple[float, float]] = []
        for point in points:
            while len(hull) > 1 and _turns_right(hull[-2], hull[-1], point):
                hull.pop()
            hull.append(point)
        for (x0, y0), (x1, y1) in pairwise(hull):
            if x0 <= reference <= x1:
                drift = (y1 - y0) / (x1 - x0)
                if abs(drift) > MOST_DRIFT and self.seconds > SURE_AFTER_S:
                    raise BadState("sensors-clock-rate", device=self._name, value=drift, limit=MOST_DRIFT)
                return min(MOST_DRIFT, max(-MOST_DRIFT, drift))
        return 0.0


def _turns_right(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> bool:
    """Whether b is on or above the straight line from a to c."""
    return (b[1] - a[1]) * (c[0] - a[0]) >= (c[1] - a[1]) * (b[0] - a[0])
