"""The goals of the demo with robot inc1 in the world `yard`. Axes of REP-103: x forward, y left, z up."""

from __future__ import annotations

import math
from typing import Final

ROBOT: Final = "inc1"
SUBSYSTEM: Final = 101
AUTHORITY: Final = 200

# --- driving, in the local frame, whose origin is where the robot starts
TABLE_POSITION: Final = (2.0, 0.0)
"""Goal of the drive, in front of the table, m."""
TABLE_HEADING: Final = math.pi / 2
"""Heading towards the table, rad."""
DRIVE_SPEED: Final = 0.6
"""m/s."""
DRIVE_TOLERANCE: Final = (0.15, math.radians(3.0))
"""Tolerance in m and rad."""

TRUE_TOLERANCE: Final = (0.25, math.radians(5.0))
"""As the simulation knows it, m and rad: the robot stands where its drifting pose is at the goal."""

CAMERA_AIM: Final = (0.0, 0.2)
"""Pan and tilt of the camera on the chassis, rad right and up: it sees the gripper lift the can."""

# --- what stands on the table, in the local frame
CAN_POSITION: Final = (2.0, 0.9, 0.41)
"""Nominal centre of the can, m; its position is measured with the camera."""
MAX_CAN_OFFSET: Final = 0.20
"""Metres between nominal and measured position: the pose has drifted, and the attitude is off by 0.3 degrees."""
CAN_WIDTH: Final = 0.05
"""Metres, between the fingers."""
CAN_WEIGHT: Final = 1.0
"""Kilograms."""

# --- the gripper: metres farther out and higher than in the grasp, where it is level
VIEW_POSE: Final = (0.43, 0.62, -0.5)
"""Distance from the arm's first axis, height above the ground, m, and pitch, rad: from here the camera sees the
whole can above the gripper, wherever it may stand."""
HIGH_OFFSET: Final = (-0.25, 0.28)
"""Way point from the view pose to the can."""
OVER_OFFSET: Final = (-0.05, 0.13)
"""Above the can, and where the can is lifted to."""
APPROACH_OFFSETS: Final = ((-0.18, 0.09), (-0.12, 0.01), (0.0, 0.0))
"""From in front of the can to around it."""
MIN_LIFT: Final = 0.10
"""Metres."""
HOLD_TIME: Final = 2.0
"""Seconds."""

SETTLING_TIME: Final = 0.7
"""Seconds for the arm to come to rest before the still: an error of 0.01 rad is 1 cm at the can."""

# --- timeouts, seconds
REPORT_TIMEOUT: Final = 10.0
"""Without a report."""
CAMERA_TIMEOUT: Final = 40.0
"""Until the first picture; camera processes have low priority."""
DRIVE_TIMEOUT: Final = 45.0
MOVE_TIMEOUT: Final = 20.0
GRIP_TIMEOUT: Final = 15.0
