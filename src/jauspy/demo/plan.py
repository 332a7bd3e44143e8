"""The goals of the demo with robot inc1, a table for each world. Axes of REP-103: x forward, y left, z up."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

ROBOT: Final = "inc1"
SUBSYSTEM: Final = 101
AUTHORITY: Final = 200


@dataclass(frozen=True, slots=True)
class Waypoint:
    """Where to drive, in the local frame, whose origin is where the robot starts."""

    x: float
    """Metres."""
    y: float
    """Metres."""
    heading: float
    """Radians."""
    speed: float = 0.6
    """m/s, on the way there."""
    flippers: float | None = None
    """Radians; where the flippers are before the robot drives there, or None where they are."""
    effort: float | None = None
    """Percent. The robot drives straight ahead with this effort for the distance to the point, without steering, since
    steering at a kerb takes force from one track. None drives to the point and turns to the heading."""
    slip: float = 0.0
    """Metres by which the robot's own pose is ahead along x when it is there: belts slip at a kerb, by 0.1 to 0.3 m."""

    @property
    def reported(self) -> tuple[float, float]:
        """Local pose that the robot estimates at the goal, m."""
        return self.x + self.slip, self.y


@dataclass(frozen=True, slots=True)
class Thing:
    """An object to be grasped. Its position is measured with the camera; the nominal one is only compared."""

    name: str
    x: float
    """Metres in the local frame, of the middle of what is grasped."""
    y: float
    """Metres."""
    body: str
    """Name of the object in the world."""
    stands_on: str
    """The body of the world on which it stands, which arm and gripper must not touch."""
    support: float
    """Metres; height of that above the ground on which the robot stands."""
    size: float
    """Metres from its lowest to its highest point."""
    grip_height: float
    """Metres above the support at which the middle of the gripper holds it."""
    width: float
    """Metres, between the fingers."""
    weight: float
    """Kilograms."""
    band: float | None = None
    """Metres; height of what is red of an upright thing, from which its distance and the height of its support are
    measured. None: the height of the support is not measured."""

    @property
    def height(self) -> float:
        """Height of its middle above the ground on which the robot stands, m."""
        return self.support + self.size / 2.0


PALM_BELOW: Final = 0.025
"""Metres from the middle of the level gripper down to its lowest point, of the palm; fingers reach 0.015 m down."""
CAN_SIZE: Final = 0.12
CAN_CLEARANCE: Final = 0.05
"""Metres between palm and table. The fingers are then 0.03 m below the upper edge of the can. There are 0.08 m for
both; the table gets more, since a gripper on it blocks the arm. Errors of attitude (0.3 degrees) and of the measured
height take up to 0.015 m of it, so that more than 0.03 m are left."""


@dataclass(frozen=True, slots=True)
class Plan:
    """Actions of the robot in a world. Offsets of the gripper are metres farther out and higher than in the grasp."""

    waypoints: tuple[Waypoint, ...]
    """The last one is the goal."""
    drive: str
    """Title of the drive, as in "Drive to the table"."""
    thing: Thing
    view: tuple[float, float, float]
    """Pose of the arm's camera: distance from the arm's first axis and height above the ground, m, and pitch, rad. From
    here the whole thing is in the picture at every possible position."""
    pitch: float
    """Pitch of the gripper in the grasp, rad."""
    high: tuple[float, float]
    """Offset of a way point from the view to the thing."""
    over: tuple[float, float]
    """Offset above the thing, to which it is lifted."""
    approach: tuple[tuple[float, float], ...]
    """Offsets from there to around the thing."""
    aim: tuple[float, float]
    """Pan and tilt of the camera on the chassis, rad right and up, towards the gripper as it lifts the thing."""
    ground: float = 0.0
    """Metres; height of the ground at the goal above that at the start."""

    @property
    def goal(self) -> Waypoint:
        """Where the drive ends."""
        return self.waypoints[-1]


PLANS: Final[Mapping[str, Plan]] = {
    "yard": Plan(
        waypoints=(Waypoint(2.0, 0.0, math.pi / 2),),
        drive="2 m to the table and turn to it",
        thing=Thing(
            "can",
            2.0,
            0.9,
            body="can",
            stands_on="table",
            support=0.35,
            size=CAN_SIZE,
            grip_height=PALM_BELOW + CAN_CLEARANCE,
            width=0.05,
            weight=1.0,
            band=0.1086,
        ),
        view=(0.43, 0.62, -0.5),
        pitch=0.0,
        high=(-0.25, 0.28),
        over=(-0.05, 0.13),
        approach=((-0.18, 0.09), (-0.12, 0.01), (0.0, 0.0)),
        aim=(0.0, 0.2),
    ),
    "street": Plan(
        waypoints=(
            Waypoint(1.0, -0.62, 0.0),
            Waypoint(2.45, -0.62, 0.0, flippers=0.12, effort=20.0),
            Waypoint(2.665, -0.70, math.radians(12.0), speed=0.4, flippers=2.2, slip=0.2),
        ),
        drive="over the kerb to the pipe",
        thing=Thing(
            "pipe",
            3.35,
            -0.55,
            body="pipe_device",
            stands_on="world",
            support=0.0,
            size=0.062,
            grip_height=0.041,
            width=0.048,
            weight=1.05,
        ),
        view=(0.36, 0.52, -1.1),
        pitch=-1.2,
        high=(-0.08, 0.25),
        over=(0.0, 0.14),
        approach=((0.0, 0.06), (0.0, 0.0)),
        aim=(0.0, -0.35),
        ground=0.10,
    ),
}
"""Plans by the names of worlds."""

WAYPOINT_TOLERANCE: Final = 0.05
"""Metres; the tolerance in the commanded waypoints."""
DRIVE_TOLERANCE: Final = (0.15, math.radians(3.0))
"""Tolerance in m and rad, by the robot's own pose."""

TRUE_TOLERANCE: Final = (0.25, math.radians(5.0))
"""Tolerance of the true pose, m and rad: the robot stops where its drifting estimate reaches the goal."""
GROUND_TOLERANCE: Final = 0.02
"""Metres; tolerance of the true height of the ground below the robot."""

MAX_OFFSET: Final = 0.20
"""Metres between nominal and measured position: the pose has drifted, and the attitude is off by 0.3 degrees."""
MAX_SUPPORT_ERROR: Final = 0.03
"""Metres between nominal and measured height of what the thing stands on."""
APPROACH_TIME: Final = 1.5
"""Seconds of each motion near the thing, in which all joints arrive together: otherwise the gripper leaves the way
between two poses by some centimetres, and touches the table."""
MIN_LIFT: Final = 0.10
"""Metres."""
HOLD_TIME: Final = 2.0
"""Seconds."""

SETTLING_TIME: Final = 0.7
"""Seconds for the arm to come to rest before the still: an error of 0.01 rad is 1 cm at the can."""

MIN_RATE: Final = 0.5
"""Least fraction of the pictures per second that a camera is set to for its video to be a success."""
MIN_REDUCED_RATE: Final = 0.5
"""The same, in pictures per second, for a camera that says that its machine is too slow."""

# --- timeouts, seconds
REPORT_TIMEOUT: Final = 10.0
"""Without a report."""
CAMERA_TIMEOUT: Final = 40.0
"""Until the first picture; camera processes have low priority."""
LONG_CAMERA_TIMEOUT: Final = 120.0
"""The same while the camera says that it is still starting."""
DRIVE_TIMEOUT: Final = 45.0
MOVE_TIMEOUT: Final = 20.0
GRIP_TIMEOUT: Final = 15.0
