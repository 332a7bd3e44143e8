"""What the link does to a video: packets that did not arrive, and those that parity packets did not restore."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from typing import Final, NamedTuple

MEASURED_TIME: Final = 10.0
"""Seconds over which packets are counted."""


class LinkQuality(NamedTuple):
    """Parts of the packets of a video, 0..1."""

    missing: float = 0.0
    """Packets that did not arrive."""
    lost: float = 0.0
    """Packets that were not restored either (`jauspy.video.parity`)."""


class LinkQualityMeter:
    """Measures the link of one camera by the counters of its receiver."""

    def __init__(self) -> None:
        self._samples: deque[tuple[float, int, int, int]] = deque()
        """Time, packets, missing and lost ones."""

    def add(self, now: float, counters: Mapping[str, int]) -> LinkQuality:
        """Take the receiver's counters at `now` (monotonic seconds); returns the quality of the last 10 s."""
        lost = counters.get("lost", 0)
        packets = counters.get("packets", 0) + lost
        samples = self._samples
        if samples and packets < samples[-1][1]:
            samples.clear()  # another receiver
        samples.append((now, packets, counters.get("missing", 0), lost))
        while now - samples[0][0] > MEASURED_TIME:
            samples.popleft()
        _, first_packets, first_missing, first_lost = samples[0]
        all_packets = packets - first_packets
        if all_packets <= 0:
            return LinkQuality()
        lost_part = (lost - first_lost) / all_packets
        missing_part = max(lost_part, (samples[-1][2] - first_missing) / all_packets)
        return LinkQuality(round(missing_part, 3), round(lost_part, 3))
