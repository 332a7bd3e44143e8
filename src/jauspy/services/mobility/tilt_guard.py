"""Stops a robot before it tips over: no command of its drivers is carried out while it is tilted too far.

The limits are angles of pitch and roll, and the margin of tipping that its masses leave. See
docs/adr/0147-films-and-tilt.md and docs/adr/0186-batteries-health-and-stability.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final, NamedTuple

from jauspy.geometry.poses import Pose
from jauspy.platform.description import TiltSetup
from jauspy.platform.stability import Margin, StabilityMonitor

PERIOD: Final = 0.05
"""Seconds between two checks while the robot drives."""
RELEASE: Final = 1.5
"""Seconds without a command after which an operator counts as having let go; slow clients repeat once a second."""
STEP: Final = math.radians(10.0)
"""How much further the robot may tilt when it is commanded again."""
MARGIN_STEP: Final = math.radians(2.0)
"""The same of the margin of tipping, which is less than that of the angles."""
LEVEL: Final = math.radians(5.0)
"""Below the limits by which the robot is level again, and the limits are those of the setup."""


NO_LIMITS: Final = TiltSetup(pitch=math.pi, roll=math.pi)


class _Excess(NamedTuple):
    """How far the robot is beyond one of its limits."""

    name: str
    angle: float
    """Radians; negative within the limit."""
    step: float
    """Radians that it may go further when it is commanded again."""


class TiltGuard:
    """The limits of pitch, roll and margin of tipping of one robot.

    Beyond them the robot is stopped, and commands that are repeated, as those of a joystick, are refused until the
    operator lets go: an effort or a velocity of zero, or none for `RELEASE` seconds. Then it may be commanded in any
    direction, and is stopped again when it tilts by `STEP` more (`MARGIN_STEP` of the margin). Limits are the first
    ones again once it is level.
    """

    def __init__(self, limits: TiltSetup | None, stability: StabilityMonitor | None = None) -> None:
        self._limits = limits or NO_LIMITS
        self._stability = stability
        self._extra: dict[str, float] = {}
        """Radians beyond each limit that are allowed since the robot was commanded again."""
        self._stopped: _Excess | None = None
        """The limit at which it was stopped, until the operator lets go."""
        self._commanded = -math.inf
        self.factor = 1.0
        """Fraction of the speed with which the robot may drive, by the last call of `problem`."""

    @property
    def holds(self) -> bool:
        """True after a stop, until the operator lets go."""
        return self._stopped is not None

    def problem(self, pose: Pose) -> str:
        """Why the robot must stop in this attitude (x forward, y left, z up), as a sentence; empty if it need not."""
        margin = self._margin()
        rows = list(self._excesses(pose, margin))
        if all(row.angle < -LEVEL for row in rows):
            self._extra, self._stopped = {}, None
        worst = max(rows, key=lambda row: row.angle - self._extra.get(row.name, 0.0))
        extra = self._extra.get(worst.name, 0.0)
        if worst.angle <= extra:
            return ""
        self._stopped = worst
        if margin is not None and self._stability is not None and worst.name == "margin":
            what = self._stability.text(margin)
        else:
            what = self._tilt_text(worst, pose, extra)
        return f"{what}: the tracks or wheels stop; let go, then drive back carefully"

    def let_go(self) -> None:
        """The operator has commanded zero, or another operation has stopped the robot."""
        if (stopped := self._stopped) is not None:
            self._stopped = None
            self._extra[stopped.name] = stopped.angle + stopped.step

    def allows(self, now: float) -> bool:
        """True if a command at that time (seconds) may be carried out; False while the operator has not let go."""
        if self.holds and now - self._commanded > RELEASE:
            self.let_go()
        self._commanded = now
        return not self.holds

    def _margin(self) -> Margin | None:
        """The least margin that is kept, and with it the factor of the speed."""
        stability = self._stability
        if stability is None or not stability.limits:
            self.factor = 1.0
            return None
        margin = stability.limiting()
        self.factor = stability.factor(margin)
        return margin

    def _excesses(self, pose: Pose, margin: Margin | None) -> Iterator[_Excess]:
        yield _Excess("pitch", abs(pose.pitch) - self._limits.pitch, STEP)
        yield _Excess("roll", abs(pose.roll) - self._limits.roll, STEP)
        if margin is not None and self._stability is not None:
            yield _Excess("margin", self._stability.setup.stop - margin.angle, MARGIN_STEP)

    def _tilt_text(self, excess: _Excess, pose: Pose, extra: float) -> str:
        is_pitch = excess.name == "pitch"
        angle, limit = (pose.pitch, self._limits.pitch) if is_pitch else (pose.roll, self._limits.roll)
        sides = ("nose down", "nose up") if is_pitch else ("right side down", "left side down")
        return (
            f"tilted by {abs(math.degrees(angle)):.0f} degrees ({sides[angle < 0.0]}; {excess.name} limit "
            f"{math.degrees(limit + extra):.0f})"
        )
