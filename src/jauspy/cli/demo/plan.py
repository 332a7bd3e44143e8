"""What is done with inc1 in the world `demo`, and what counts as done. Axes of REP-103: x forward, y left, z up."""

from __future__ import annotations

import math
from typing import Final

ROBOT: Final = "inc1"
SUBSYSTEM: Final = 101
AUTHORITY: Final = 200

# --- driving, in the local frame, whose origin is where the robot starts
STAND: Final = (2.0, 0.0)
"""Where it stops: in front of the table. Metres."""
HEADING: Final = math.pi / 2
"""Towards the table, radians."""
SPEED: Final = 0.6
"""m/s."""
NEAR: Final = (0.15, math.radians(3.0))
"""How exactly it must stand there."""

AIM: Final = (0.0, 0.2)
"""Pan and tilt of the camera on the chassis, radians to the right and up: there it sees the hand lift the can."""

# --- what stands on the table, in the local frame
CAN: Final = (2.0, 0.9, 0.41)
"""The middle of the can, as one was told; where it really is, the camera tells."""
SEARCH: Final = 0.10
"""Metres by which it may be somewhere else."""
WIDTH: Final = 0.05
"""Metres, of the can between the fingers."""
WEIGHT: Final = 1.0
"""Kilograms."""

# --- the hand; metres that it is farther out and higher than in the grasp, where it is level
LOOKS_FROM: Final = (0.43, 0.62, -0.5)
"""From the arm's first axis, above the ground, and how far up it points, in radians: from here the camera sees all of
the can over the gripper, wherever it is searched."""
HIGH: Final = (-0.25, 0.28)
"""On the way from there."""
OVER: Final = (-0.05, 0.13)
"""Over the can, and where the can is lifted to."""
APPROACH: Final = ((-0.18, 0.09), (-0.12, 0.01), (0.0, 0.0))
"""From before the can to around it."""
LIFT: Final = 0.10
"""Metres that the can must be lifted at least."""
HOLD: Final = 2.0
"""Seconds that it must be held."""

SETTLING: Final = 0.7
"""Seconds that the arm is given to come to rest before it looks: a hundredth of a radian is a centimetre over there."""

# --- patience, seconds
SILENCE: Final = 10.0
"""Without a report: a busy machine takes its time."""
CAMERA_TIME: Final = 40.0
"""Until the first picture; processes of cameras give way to others."""
DRIVE_TIME: Final = 45.0
MOVE_TIME: Final = 20.0
GRIP_TIME: Final = 15.0
