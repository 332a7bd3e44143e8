"""The axes of simulated drives: motors with a load, or the joints and tracks of another backend's robot."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final, Protocol

from jauspy.geometry.frames import HoldingEfforts
from jauspy.geometry.urdf import Joint
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel
from jauspy.platform.drives import SkidSteerDrive
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.servo_drives import CanSetup, DriveSetup

DAMPING: Final = 0.5
"""Effort of friction at full speed, as a fraction of the full effort."""
SPIN_UP: Final = 0.05
"""Seconds from standstill to full speed with full effort, without friction."""

STEPS_PER_WEIGHING: Final = 8
"""Steps after which the weights that joints carry are computed again."""


class Axis(Protocol):
    """One joint or track. Radians or metres, and their rates; newton metres or newtons."""

    position: float
    velocity: float
    effort: float

    def drive(self, mode: ControlMode, value: float) -> None:
        """Follow a value; a position is reached at the end of the next step."""
        ...

    def stop(self, deceleration: float) -> None:
        """Come to rest, and hold the position."""
        ...

    def release(self) -> None:
        """No power: the brake engages."""
        ...


class Plant(Protocol):
    """All axes of a robot."""

    @property
    def axes(self) -> Mapping[str, Axis]:
        """Axes by the name of the drive."""
        ...

    @property
    def robot(self) -> Robot | None:
        """The robot whose joints they are, if it is another backend's."""
        ...

    def advance(self, dt: float) -> None:
        """Move for `dt` seconds."""
        ...

    def close(self) -> None:
        """Release resources."""
        ...


class MotorAxis:
    """A motor with inertia, friction, a torque limit, a brake and a load; a joint has mechanical ends."""

    def __init__(self, joint: Joint, position: float, *, endless: bool = False) -> None:
        self.position = position
        self._ends = (-math.inf, math.inf) if endless else (joint.lower, joint.upper)
        self.velocity = 0.0
        self.effort = 0.0
        self.load = 0.0
        """The effort against the weight that the joint carries, N m or N."""
        self.blocked = False
        self._limit = joint.effort
        self._inertia = joint.effort * SPIN_UP / joint.velocity
        self._damping = DAMPING * joint.effort / joint.velocity
        self._mode: ControlMode | None = None
        self._value = 0.0
        self._deceleration: float | None = None

    def drive(self, mode: ControlMode, value: float) -> None:
        """Follow a value."""
        self._mode, self._value, self._deceleration = mode, value, None
        if mode is ControlMode.EFFORT:
            self.effort = min(self._limit, max(-self._limit, value))

    def stop(self, deceleration: float) -> None:
        """Come to rest with a deceleration, and hold the position."""
        if self._deceleration is None:
            self._value = math.nan
        self._mode, self._deceleration = ControlMode.POSITION, deceleration

    def release(self) -> None:
        """Engage the brake."""
        self._mode = self._deceleration = None

    def advance(self, dt: float) -> None:
        """Move for `dt` seconds, by a controller that reaches its target in one step if the torque suffices."""
        if self._mode is None or self.blocked:
            self.velocity = self.effort = 0.0
            return
        resistance = self._damping * self.velocity + self.load
        if self._mode is ControlMode.EFFORT:
            wanted = self._value
        else:
            wanted = self._inertia * (self._wanted_velocity(dt) - self.velocity) / dt + resistance
        self.effort = min(self._limit, max(-self._limit, wanted))
        self.velocity += (self.effort - resistance) / self._inertia * dt
        self.position += self.velocity * dt
        if not self._ends[0] <= self.position <= self._ends[1]:
            self.position = min(self._ends[1], max(self._ends[0], self.position))
            self.velocity = 0.0

    def _wanted_velocity(self, dt: float) -> float:
        if self._deceleration is not None:
            if math.isnan(self._value):
                change = self._deceleration * dt
                if abs(self.velocity) > change:
                    return self.velocity - math.copysign(change, self.velocity)
                self._value = self.position
            return (self._value - self.position) / dt
        if self._mode is ControlMode.VELOCITY:
            return self._value
        return (self._value - self.position) / dt


class MotorPlant:
    """A `Plant` of motors, each with the weight of the links that it carries."""

    robot: Robot | None = None

    def __init__(self, model: RobotModel, drives: Mapping[str, DriveSetup]) -> None:
        starts = {
            joint: start
            for group in model.groups.values()
            for joint, start in zip(group.joints, group.start, strict=True)
        }
        self.axes: dict[str, MotorAxis] = {
            name: MotorAxis(
                model.description.joint(drive.moves), starts.get(drive.moves, 0.0), endless=drive.track is not None
            )
            for name, drive in drives.items()
        }

        self._holding = HoldingEfforts(model.description)
        self._joints = {drive.moves: self.axes[name] for name, drive in drives.items() if drive.track is None}
        self._until_weighed = 0

    def advance(self, dt: float) -> None:
        """Move for `dt` seconds."""
        if not self._until_weighed:
            self._weigh()
        self._until_weighed = (self._until_weighed + 1) % STEPS_PER_WEIGHING
        for axis in self.axes.values():
            axis.advance(dt)

    def _weigh(self) -> None:
        weights = self._holding.at({joint: axis.position for joint, axis in self._joints.items()})
        for joint, axis in self._joints.items():
            axis.load = weights.get(joint, 0.0)

    def close(self) -> None:
        """There is nothing to release."""


QUICK: Final = 1000.0
"""Acceleration in rad/s^2 or m/s^2 with which the other backend's controllers follow: the master has ramped it."""

POSITION_GAIN: Final = 12.0
"""1/s: rad/s or m/s for each radian or metre that a position is off."""

TRACK_GAIN: Final = 2.0
"""Effort of a track, as a fraction of the full one, for a velocity that is wrong by the full speed."""


class RobotJoint:
    """An `Axis`: a joint of another backend's robot, with a position loop around that of the velocity."""

    def __init__(self, period: float) -> None:
        self.position = self.velocity = self.effort = 0.0
        self.target: Target | None = None
        self.stopped = True
        self._period = period
        """Seconds from one position to the next (60C2h)."""
        self._goal: float | None = None
        self._speed = 0.0

    def drive(self, mode: ControlMode, value: float) -> None:
        """Follow a value; positions are interpolated."""
        self.stopped = False
        if mode is not ControlMode.POSITION:
            self._goal = None
            self.target = Target(mode, value, acceleration=QUICK, deceleration=QUICK)
            return
        self._speed = 0.0 if self._goal is None else (value - self._goal) / self._period
        self._goal = value

    def control(self) -> None:
        """Set the target for the next step."""
        if self._goal is not None and not self.stopped:
            wanted = self._speed + POSITION_GAIN * (self._goal - self.position)
            self.target = Target(ControlMode.VELOCITY, wanted, acceleration=QUICK, deceleration=QUICK)

    def stop(self, deceleration: float) -> None:  # noqa: ARG002 - the backend has its own
        """Hold."""
        if not self.stopped:
            self.target, self.stopped, self._goal = Target(ControlMode.POSITION, self.position), True, None

    def release(self) -> None:
        """Hold: the brake."""
        self.stop(0.0)


class RobotTrack:
    """An `Axis`: a track of another backend's robot; its controller adds effort until the velocity is right."""

    def __init__(self, full_speed: float) -> None:
        self.position = self.velocity = self.effort = 0.0
        self.wanted = 0.0
        self._full_speed = full_speed

    def drive(self, mode: ControlMode, value: float) -> None:
        """Run at a velocity; other modes stop."""
        self.wanted = value if mode is ControlMode.VELOCITY else 0.0

    def stop(self, deceleration: float) -> None:  # noqa: ARG002 - the backend has its own
        """Brake."""
        self.wanted = 0.0

    def release(self) -> None:
        """Brake."""
        self.wanted = 0.0

    def fraction(self) -> float:
        """The effort, -1..1."""
        if not self.wanted:
            return 0.0
        error = self.wanted - self.velocity
        return min(1.0, max(-1.0, (self.wanted + TRACK_GAIN * error) / self._full_speed))


class RobotPlant:
    """A `Plant`: the robot of another backend, as of the simulator. Commands go to its joints and tracks."""

    def __init__(self, robot: Robot, model: RobotModel, setup: CanSetup) -> None:
        self.robot: Robot = robot
        drives = setup.drives
        self.axes: dict[str, RobotJoint | RobotTrack] = {}
        self._groups: list[tuple[str, list[RobotJoint]]] = []
        self._tracks: dict[str, RobotTrack] = {}
        by_joint = {drive.moves: name for name, drive in drives.items() if drive.track is None}
        for name, group in model.groups.items():
            joints = [RobotJoint(1.0 / setup.sync_rate) for _ in group.joints]
            self._groups.append((name, joints))
            self.axes |= {by_joint[joint]: axis for joint, axis in zip(group.joints, joints, strict=True)}
        for name, drive in drives.items():
            if drive.track is not None:
                joint = model.description.joint(drive.moves)
                self.axes[name] = self._tracks[drive.track] = RobotTrack(joint.velocity)
        self._measure(0.0)

    def advance(self, dt: float) -> None:
        """Command the robot, and advance it."""
        for name, joints in self._groups:
            self._command(name, joints)
        if self._tracks:
            left, right = (self._tracks[side].fraction() for side in ("left", "right"))
            self.robot.drive.set_effort((left + right) / 2.0, (right - left) / 2.0)
        self.robot.advance(dt)
        self._measure(dt)

    def _command(self, name: str, joints: Sequence[RobotJoint]) -> None:
        for joint in joints:
            joint.control()
        if all(joint.stopped for joint in joints):
            self.robot.groups[name].hold()
        else:
            self.robot.groups[name].command([joint.target for joint in joints])

    def _measure(self, dt: float) -> None:
        for name, joints in self._groups:
            state = self.robot.groups[name].state()
            for joint, *values in zip(joints, state.positions, state.velocities, state.efforts, strict=True):
                joint.position, joint.velocity, joint.effort = values
        drive = self.robot.drive
        if isinstance(drive, SkidSteerDrive):  # what encoders count, slip included
            for side, speed in zip(("left", "right"), drive.track_speeds(), strict=True):
                if (track := self._tracks.get(side)) is not None:
                    track.velocity = speed
                    track.position += speed * dt

    def close(self) -> None:
        """Close the robot."""
        self.robot.close()
