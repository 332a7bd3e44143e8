"""The scripted drive: find the robot, take control, drive 2 m, turn 90 degrees, give it back."""

from __future__ import annotations

import asyncio
import math
from dataclasses import dataclass
from typing import Final

from jauspy.messages.mobility import QueryLocalPose, QueryVelocityState
from jauspy.ocu.client import OCU
from jauspy.ocu.model import Subsystem
from jauspy.ocu.stats import Stats
from jauspy.ocu.steering import Drive, Motion

RATE: Final = 10.0
"""Hz of the reports that the drive is steered by."""
X_Y_YAW: Final = 0b0100_0011
"""Presence vector: the first, second and seventh field of pose and velocity reports."""


@dataclass(frozen=True, slots=True)
class Result:
    """How it went. Metres, radians and seconds; errors are what was reached minus what was asked for."""

    robot: Subsystem
    start: Motion
    end: Motion
    distance_error: float
    angle_error: float
    duration: float
    pose_reports: int
    lost_reports: int
    confirmed_rate: float
    stats: Stats


class Observer:
    """Is told how the demo goes on; override what is of interest."""

    def step(self, text: str) -> None:
        """The next thing is being done."""

    def discovered(self, robot: Subsystem) -> None:
        """It was found, and this is what it is."""

    def controlled(self) -> None:
        """Control was taken; it is given back however this ends."""

    def moved(self, motion: Motion, left: float, unit: str) -> None:
        """A report came in; `left` is what is left to the target, in `unit` (`m` or `rad`)."""


async def run(
    ocu: OCU,
    *,
    subsystem: int = 101,
    authority: int = 200,
    distance: float = 2.0,
    angle: float = math.pi / 2,
    leg_time: float = 20.0,
    observer: Observer | None = None,
) -> Result:
    """Drive `distance` metres, turn by `angle` radians (right is positive); each may take `leg_time` seconds."""
    watch, clock = observer or Observer(), asyncio.get_running_loop().time
    began = clock()

    watch.step(f"Discover subsystem {subsystem}")
    robot = await ocu.discover(subsystem=subsystem)
    watch.discovered(robot.info)
    driver = robot.service("mobility:PrimitiveDriver")
    pose_sensor = robot.service("mobility:LocalPoseSensor")
    velocity_sensor = robot.service("mobility:VelocityStateSensor")

    watch.step(f"Take control of {driver.id} with authority {authority}")
    async with driver.control(authority=authority) as control:
        watch.controlled()
        watch.step("Resume")
        await driver.resume()

        watch.step(f"Subscribe to pose and velocity at {RATE:g} Hz")
        async with (
            pose_sensor.subscribe(QueryLocalPose(presence_vector=X_Y_YAW), rate=RATE, buffer=1) as poses,
            velocity_sensor.subscribe(QueryVelocityState(presence_vector=X_Y_YAW), rate=RATE, buffer=1) as velocities,
        ):
            drive = Drive(driver, control, poses, velocities, moved=watch.moved, leg_time=leg_time)
            start = await drive.look()

            watch.step(f"Drive {distance:g} m forward")
            distance_error = await drive.forward(distance)

            watch.step(f"Turn {math.degrees(angle):g} degrees")
            angle_error = await drive.turn(start.yaw + angle)

            watch.step("Standby")
            await driver.standby()
            end = await drive.look()
        watch.step("Release control")
    watch.step("Done")
    return Result(
        robot=robot.info,
        start=start,
        end=end,
        distance_error=distance_error,
        angle_error=angle_error,
        duration=clock() - began,
        pose_reports=poses.received,
        lost_reports=poses.lost + velocities.lost,
        confirmed_rate=poses.confirmed_rate,
        stats=ocu.stats,
    )
