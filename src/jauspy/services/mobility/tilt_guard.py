"""Stops a robot before it tips over: no command of its drivers is carried out while it is tilted too far.

See docs/adr/0147-films-and-tilt.md.
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.poses import Pose
from jauspy.platform.description import TiltSetup

PERIOD: Final = 0.05
"""Seconds between two checks while the robot drives."""
RELEASE: Final = 1.5
"""Seconds without a command after which an operator counts as having let go; slow clients repeat once a second."""
STEP: Final = math.radians(10.0)
"""How much further the robot may tilt when it is commanded again."""
LEVEL: Final = math.radians(5.0)
"""Below the limits by which the robot is level again, and the limits are those of the setup."""


class TiltGuard:
    """The limits of pitch and roll of one robot.

    Beyond them the robot is stopped, and commands that are repeated, as those of a joystick, are refused until the
    operator lets go: an effort or a velocity of zero, or none for `RELEASE` seconds. Then it may be commanded in any
    direction, and is stopped again when it tilts by `STEP` more. Limits are the first ones again once it is level.
    """

    def __init__(self, limits: TiltSetup) -> None:
        self._limits = limits
        self._extra = 0.0
        self._stopped_at = 0.0
        """Radians beyond the limits at which it was stopped."""
        self._holds = False
        self._commanded = -math.inf

    @property
    def holds(self) -> bool:
        """True after a stop, until the operator lets go."""
        return self._holds

    def problem(self, pose: Pose) -> str:
        """Why the robot must stop in this attitude (x forward, y left, z up), as a sentence; empty if it need not."""
        limits = self._limits
        angles = (("pitch", pose.pitch, limits.pitch), ("roll", pose.roll, limits.roll))
        name, angle, limit = max(angles, key=lambda tilt: abs(tilt[1]) - tilt[2])
        beyond = abs(angle) - limit
        if beyond < -LEVEL:
            self._extra, self._holds = 0.0, False
        if beyond <= self._extra:
            return ""
        self._stopped_at, self._holds = beyond, True
        sides = ("nose down", "nose up") if name == "pitch" else ("right side down", "left side down")
        return (
            f"tilted by {abs(math.degrees(angle)):.0f} degrees ({sides[angle < 0.0]}; {name} limit "
            f"{math.degrees(limit + self._extra):.0f}): the tracks or wheels stop; let go, then drive back carefully"
        )

    def let_go(self) -> None:
        """The operator has commanded zero, or another operation has stopped the robot."""
        if self._holds:
            self._holds, self._extra = False, self._stopped_at + STEP

    def allows(self, now: float) -> bool:
        """True if a command at that time (seconds) may be carried out; False while the operator has not let go."""
        if self._holds and now - self._commanded > RELEASE:
            self.let_go()
        self._commanded = now
        return not self._holds
