"""Pace of a camera on a machine that is too slow for it: rate, quality and size of its pictures, and its niceness.

Two policies without a clock: `now` is in seconds of a monotonic clock. `Pace` does less when pictures are missing, and
more when there is room. `Niceness` takes as little of the processor from others as suffices to make pictures at all.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from jauspy.platform.video_settings import VideoSettings


@dataclass(frozen=True, slots=True)
class Effort:
    """Step of a camera: pictures per second, how many qualities lower, and by what their sides are divided."""

    rate: int
    simplified: int = 0
    divisor: int = 1

    @property
    def cost(self) -> float:
        """Time of one picture as a fraction of that of the best one, as measured without a graphics card."""
        return QUALITY_COST**self.simplified * DIVISOR_COSTS[self.divisor]


QUALITY_COST: Final = 0.6
"""Time of a picture in relation to one of the next better quality."""
DIVISOR_COSTS: Final = {1: 1.0, 2: 0.6, 4: 0.45}
"""Time of a picture whose sides are divided, in relation to a whole one: most of it does not depend on the size."""
RATE_FRACTIONS: Final = (1.0, 2.0 / 3.0, 1.0 / 2.0, 1.0 / 3.0)
"""Fractions of the rate that is set that are tried before pictures get worse."""
MIN_WIDTH: Final = 160
"""Pixels of the smallest picture."""


def efforts(settings: VideoSettings, qualities: int) -> tuple[Effort, ...]:
    """Steps from all that is set to the least: first the rate falls to a third, then quality, size, and the rate again.

    `qualities` is the number of lower ones.
    """
    rates = dict.fromkeys(max(1, round(settings.rate * fraction)) for fraction in RATE_FRACTIONS)
    found = [Effort(rate) for rate in rates]
    low = found[-1].rate
    found += [Effort(low, simplified) for simplified in range(1, qualities + 1)]
    divisors = [divisor for divisor in DIVISOR_COSTS if settings.width // divisor >= MIN_WIDTH or divisor == 1]
    found += [Effort(low, qualities, divisor) for divisor in divisors[1:]]
    while low > 1:
        low //= 2
        found.append(Effort(low, qualities, divisors[-1]))
    return tuple(found)


def reduced_text(name: str, settings: VideoSettings, effort: Effort) -> str:
    """The sentence for users about a camera that does less than is set; empty if it does all."""
    if effort == Effort(settings.rate):
        return ""
    width, height = settings.width // effort.divisor, settings.height // effort.divisor
    quality = ", of lower quality," if effort.simplified else ""
    return (
        f"the robot's machine is too slow for camera {name}: {width}x{height} at {effort.rate}/s{quality} "
        f"instead of {settings.width}x{settings.height} at {settings.rate}/s"
    )


WINDOW: Final = 5.0
"""Seconds over which it is measured whether a camera keeps its rate."""
MAX_MISSING: Final = 0.2
"""Share of pictures that may be missing."""
MAX_LOAD: Final = 0.8
"""Share of the time that pictures may be expected to take after a step down."""
FREE_LOAD: Final = 0.6
"""The same after a step up; lower, so that the camera does not go back and forth."""
FIRST_HOLD, MAX_HOLD = 10.0, 160.0
"""Seconds that a better effort must have been possible before it is tried: at first, and at most."""
RELAPSE: Final = 30.0
"""Seconds within which a step up that is undone counts as wrong; `hold` is doubled then."""


class Hold:
    """How long something must have been possible before it is tried, longer after each try that was undone soon."""

    def __init__(self, first: float, longest: float) -> None:
        self._first = self._seconds = first
        self._longest = longest
        self._since = math.inf
        self._tried = -math.inf

    def is_over(self, now: float, *, possible: bool) -> bool:
        """True when it has been possible for long enough; it counts as tried then."""
        if not possible:
            self._since = math.inf
            return False
        self._since = min(self._since, now)
        if now - self._since < self._seconds:
            return False
        self._since, self._tried = math.inf, now
        return True

    def undo(self, now: float) -> None:
        """It was not possible any more."""
        is_relapse = now - self._tried < RELAPSE
        self._seconds = min(max(2.0 * self._seconds, FIRST_HOLD), self._longest) if is_relapse else self._first
        self._since = math.inf


class Pace:
    """Chooses the effort of a camera by how long its pictures take and how many are missing."""

    def __init__(self, steps: tuple[Effort, ...]) -> None:
        self._steps = steps
        self._step = 0
        self._hold = Hold(FIRST_HOLD, MAX_HOLD)
        self._began: float | None = None
        self._taken = self._skipped = 0
        self._busy = 0.0

    @property
    def effort(self) -> Effort:
        """The present one."""
        return self._steps[self._step]

    def restart(self) -> None:
        """Measure anew, as after a pause. The next picture does not count: it takes a while to be ready for it."""
        self._began = None

    def add(self, now: float, took: float, skipped: int) -> bool:
        """Count a picture that was ready at `now` after `took` seconds, and the ones left out before it.

        True when the effort has changed.
        """
        if self._began is None:
            self._began, self._taken, self._skipped, self._busy = now, 0, 0, 0.0
            return False
        self._taken += 1
        self._skipped += skipped
        self._busy += took
        if now - self._began < WINDOW:
            return False
        before = self._step
        self._step = self._next(now)
        self._began, self._taken, self._skipped, self._busy = now, 0, 0, 0.0
        return self._step != before

    def _next(self, now: float) -> int:
        whole = self._busy / self._taken / self.effort.cost
        loads = [effort.rate * effort.cost * whole for effort in self._steps]
        if self._skipped > MAX_MISSING * (self._taken + self._skipped):
            self._hold.undo(now)
            lower = range(self._step + 1, len(self._steps))
            return next((step for step in lower if loads[step] <= MAX_LOAD), len(self._steps) - 1)
        better = next((step for step in range(self._step) if loads[step] <= FREE_LOAD), self._step)
        return better if self._hold.is_over(now, possible=better < self._step) else self._step


LEAST_NICENESS: Final = 3
"""Half of the weight of the robot's process, so that control always comes first."""
NICENESS_STEP: Final = 5
"""A step to a third of the weight, or to three times: Linux has a factor of 1.25 for 1 (`sched_prio_to_weight`)."""
SAMPLE: Final = 0.25
"""Seconds of running and waiting over which the share is measured."""
STARVING: Final = 1.0 / 8.0
"""Share of the processor below which a camera with missing pictures gets a lower niceness; three on one have more."""
FED: Final = 1.0 / 4.0
"""Share above which it becomes nicer again."""
FIRST_NICER, LONGEST_NICER = 1.0, 320.0
"""Seconds with that share before it becomes nicer: at first, and at most."""


class Niceness:
    """Chooses how nice a camera is, by its share of the processor; always nicer than control, unless `highest` is less.

    It starts with `LEAST_NICENESS`, becomes nicer as long as it gets its share, and less nice when others leave it
    nothing.
    """

    def __init__(self, highest: int) -> None:
        self._levels: tuple[int, ...] = (*range(LEAST_NICENESS, highest, NICENESS_STEP), highest)
        self._level = 0
        self._hold = Hold(FIRST_NICER, LONGEST_NICER)
        self._ran = self._waited = 0.0
        self._skipped = 0

    @property
    def niceness(self) -> int:
        """The present one, in addition to that of the robot's process."""
        return self._levels[self._level]

    def add(self, now: float, ran: float, waited: float, skipped: int) -> bool:
        """Count seconds that the thread ran and waited for a processor, and pictures left out.

        True when the niceness has changed.
        """
        self._ran += ran
        self._waited += waited
        self._skipped += skipped
        if self._ran + self._waited < SAMPLE:
            return False
        share = self._ran / (self._ran + self._waited)
        is_starving = share < STARVING and self._skipped > 0
        self._ran, self._waited, self._skipped = 0.0, 0.0, 0
        before = self._level
        if is_starving and self._level > 0:
            self._level -= 1
            self._hold.undo(now)
        elif self._hold.is_over(now, possible=share >= FED and self._level + 1 < len(self._levels)):
            self._level += 1
        return self._level != before
