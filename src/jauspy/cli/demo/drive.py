"""The drive to the table, by LocalWaypointDriver."""

from __future__ import annotations

import math
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.patience import within
from jauspy.cli.demo.report import Finding
from jauspy.cli.demo.watch import Scene
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetLocalWaypoint, SetTravelSpeed
from jauspy.ocu import Control
from jauspy.ocu.robot import Robot
from jauspy.ocu.subscription import Subscription

RATE: Final = 10.0
"""Hz of the poses."""
X_Y_YAW: Final = 0b0100_0011
STANDS: Final = 0.005
"""Metres, or radians, from one pose to the next, below which the robot stands."""
STILL: Final = 8
"""Poses in a row for which it must stand, there."""


async def to_the_table(robot: Robot, control: Control, scene: Scene) -> Finding:
    """Drive, and measure where it stands then."""
    driver = robot.component(control.id.component).service("LocalWaypointDriver")
    sensor = robot.service("mobility:LocalPoseSensor")
    x, y = plan.STAND
    began = scene.elapsed
    async with sensor.subscribe(
        QueryLocalPose(X_Y_YAW), rate=RATE, expects=ReportLocalPose, silence=plan.SILENCE
    ) as poses:
        await driver.send(SetLocalWaypoint(x=x, y=-y, yaw=-plan.HEADING, waypoint_tolerance=plan.NEAR[0]))
        await driver.send(SetTravelSpeed(plan.SPEED))
        async with within(plan.DRIVE_TIME, lambda: _late(scene)):
            await _arrive(poses, control, scene)
    left, turn = left_to_go(scene)
    seconds = scene.elapsed - began
    return Finding(
        "drive",
        f"{math.hypot(x, y):g} m and a turn of {math.degrees(plan.HEADING):g}° in {seconds:.1f} s, "
        f"{100 * left:.1f} cm and {math.degrees(turn):+.1f}° off; "
        f"{poses.received} poses at {poses.confirmed_rate:.3g} Hz, {poses.lost or 'none'} lost",
        left <= plan.NEAR[0] and abs(turn) <= plan.NEAR[1],
        {"distance_error": left, "heading_error": turn, "seconds": seconds, "poses_lost": poses.lost},
    )


def left_to_go(scene: Scene) -> tuple[float, float]:
    """Metres and radians from where it is to stand."""
    if scene.pose is None:
        return math.inf, math.inf
    x, y, yaw = scene.pose
    return math.dist((x, y), plan.STAND), math.remainder(yaw - plan.HEADING, math.tau)


def _late(scene: Scene) -> str:
    left, turn = left_to_go(scene)
    to_go = f"{left:.2f} m and {math.degrees(turn):.0f}°"
    return f"the drive took longer than {plan.DRIVE_TIME:g} s, with {to_go} to go; see whether something is in its way"


async def _arrive(poses: Subscription[ReportLocalPose], control: Control, scene: Scene) -> None:
    """Until it stands there; raises `ControlRejected` when control is lost."""
    still = 0
    while still < STILL:
        control.check()
        pose, before = await poses.get(), scene.pose
        scene.pose = now = (pose.x or 0.0, -(pose.y or 0.0), -(pose.yaw or 0.0))
        step = math.inf if before is None else max(math.dist(now[:2], before[:2]), abs(now[2] - before[2]))
        scene.speed = 0.0 if before is None else RATE * math.dist(now[:2], before[:2])
        left, turn = left_to_go(scene)
        there = left <= plan.NEAR[0] and abs(turn) <= plan.NEAR[1]
        still = still + 1 if there and step < STANDS else 0
