"""Robots without physics, which remember what they were commanded."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Sequence
from functools import cache

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.force_torque import ForceTorqueSensor
from jauspy.platform.joints import JointGroup, JointState, Target
from jauspy.platform.ranging import RangeFinder
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig


@cache
def described(name: str) -> tuple[RobotConfig, RobotModel]:
    """A robot that comes with jauspy, read once in a test run."""
    config = robot_files.load(name)
    return config, robot_files.robot_model(config)


class FakeDrive:
    """A chassis whose state the test sets; with a `clock` it moves at once as commanded, full effort being `speed`."""

    def __init__(self, *, clock: Callable[[], float] | None = None, speed: float = 1.0) -> None:
        self.efforts: list[tuple[float, float]] = []
        self.stops = 0
        self.present_pose = Pose()
        self.present_twist = Twist()
        self.present_acceleration = Acceleration()
        self.speed = speed
        self._clock = clock
        self._integrated = clock() if clock else 0.0

    @property
    def effort(self) -> tuple[float, float]:
        return self.efforts[-1] if self.efforts else (0.0, 0.0)

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        self._integrate()
        self.efforts.append((linear_x, rotational_z))
        if self._clock is not None:
            self.present_twist = Twist(vx=linear_x * self.speed, wz=rotational_z * self.speed)

    def stop(self) -> None:
        self.stops += 1
        self.set_effort(0.0, 0.0)

    def pose(self) -> Pose:
        self._integrate()
        return self.present_pose

    def twist(self) -> Twist:
        return self.present_twist

    def acceleration(self) -> Acceleration:
        return self.present_acceleration

    def _integrate(self) -> None:
        if self._clock is None:
            return
        now, twist, pose = self._clock(), self.present_twist, self.present_pose
        x, y, yaw = pose.x, pose.y, pose.yaw
        left, self._integrated = now - self._integrated, now
        while left > 0:
            dt = min(left, 0.002)
            left -= dt
            yaw += twist.wz * dt
            x += math.cos(yaw) * twist.vx * dt
            y += math.sin(yaw) * twist.vx * dt
        self.present_pose = Pose(x=x, y=y, yaw=math.remainder(yaw, math.tau))


class FakeJoints:
    """A group of one joint."""

    joints = chain = (Joint("joint", JointKind.REVOLUTE, "base_link", "link"),)

    def __init__(self) -> None:
        self.targets: list[tuple[Target | None, ...]] = []
        self.holds = 0

    def command(self, targets: Sequence[Target | None]) -> None:
        self.targets.append(tuple(targets))

    def hold(self) -> None:
        self.holds += 1

    def state(self) -> JointState:
        return JointState((0.0,), (0.0,), (0.0,))


class FakeRobot:
    """Counts the time it was given, and notices which threads touch it."""

    def __init__(self, breaks_after: int | None = None) -> None:
        self.groups: dict[str, JointGroup] = {}
        self.lidars: dict[str, RangeFinder] = {}
        self.force_torque: dict[str, ForceTorqueSensor] = {}
        self.optional_parts: list[OptionalPart] = []
        self.drive = FakeDrive()
        self.time = 0.0
        self.closed = 0
        self.threads: set[int] = set()
        self.steps = 0
        self.stepped = threading.Condition()
        self._breaks_after = breaks_after

    def advance(self, dt: float) -> None:
        self.threads.add(threading.get_ident())
        with self.stepped:
            self.time += dt
            self.steps += 1
            self.stepped.notify_all()
        if self.steps == self._breaks_after:
            raise RuntimeError("a track came off")

    def close(self) -> None:
        self.closed += 1

    def wait_for_steps(self, more: int) -> None:
        """Wait until it was advanced that many times more."""
        with self.stepped:
            goal = self.steps + more
            assert self.stepped.wait_for(lambda: self.steps >= goal, timeout=30.0)
