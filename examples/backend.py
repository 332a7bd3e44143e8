"""A robot on a motor controller of your own: any OCU can find it and drive it, for example ocu.py.

Run it in place of `jauspy up inc1`, beside `jauspy node-manager`. Installed as a package with the entry point
`tracked = "backend:TrackedBackend"` in the group `jauspy.backends`, it is also run by `jauspy up tracked.toml`.
"""

import asyncio
import math
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jauspy import ConfigError
from jauspy.geometry.poses import Pose, Twist
from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import SkidSteerDrive
from jauspy.robot import robot_files
from jauspy.robot.runner import RobotRunner
from jauspy.transport.connect import transport_for

NO_PARTS: Mapping[str, Any] = {}


class MotorController:
    """A simulated controller; the speed of a track follows its effort with a time constant of 0.1 s."""

    def __init__(self, max_speed: float) -> None:
        self.max_speed = max_speed  # m/s
        self.efforts = (0.0, 0.0)  # left and right, -1..1
        self.speeds = (0.0, 0.0)  # m/s, as encoders measure them

    def simulate(self, dt: float) -> None:
        pairs = zip(self.efforts, self.speeds, strict=True)
        left, right = (speed + (effort * self.max_speed - speed) * dt / 0.1 for effort, speed in pairs)
        self.speeds = (left, right)


class TrackDrive(SkidSteerDrive):
    """The `DriveBase`: `SkidSteerDrive` computes the tracks' efforts; the pose is integrated from their speeds."""

    def __init__(self, chassis: Chassis) -> None:
        super().__init__()
        self.motors = MotorController(chassis.max_speed)
        self.track_separation = chassis.track_separation  # metres
        self.x = self.y = self.yaw = 0.0  # metres and radians; y and yaw are positive to the left

    def set_track_efforts(self, left: float, right: float) -> None:
        self.motors.efforts = (left, right)

    def pose(self) -> Pose:
        return Pose(x=self.x, y=self.y, yaw=math.remainder(self.yaw, math.tau))

    def twist(self) -> Twist:
        left, right = self.motors.speeds
        return Twist(vx=(left + right) / 2.0, wz=(right - left) / self.track_separation)

    def update(self, dt: float) -> None:
        before = self.twist()
        self.motors.simulate(dt)  # leave this out when the motors are real
        self.update_acceleration(before, dt)
        twist = self.twist()
        self.yaw += twist.wz * dt
        self.x += twist.vx * math.cos(self.yaw) * dt
        self.y += twist.vx * math.sin(self.yaw) * dt


class TrackedRobot:
    """A `jauspy.platform.contract.Robot` with a chassis and no other parts."""

    groups = lidars = force_torque = cameras = NO_PARTS
    optional_parts = ()

    def __init__(self, chassis: Chassis) -> None:
        self.drive = TrackDrive(chassis)
        self.time = 0.0

    def advance(self, dt: float) -> None:
        """Called every 2 ms, in the same thread as all other methods."""
        self.drive.update(dt)
        self.time += dt

    def close(self) -> None:
        self.drive.stop()


class TrackedBackend:
    """A `jauspy.platform.contract.Backend`. Raises `ConfigError` for a robot with parts that the controller lacks."""

    name = "tracked"

    def open(self, robot: RobotModel, world: str) -> TrackedRobot:
        if world != "real":
            raise ConfigError(f"the backend 'tracked' has no world {world!r}; it has: real")
        if robot.groups or robot.lidars or robot.force_torque or robot.cameras:
            raise ConfigError("the backend 'tracked' moves two tracks only; the robot has other joints or sensors")
        return TrackedRobot(chassis_of(robot))


async def main(connect: str | None) -> None:
    config = robot_files.load(Path(__file__).with_name("tracked.toml"))
    transport = await transport_for(config.id_of(config.modules[0]), connect)
    await RobotRunner(config, lambda _: transport, backend=TrackedBackend()).run()


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
