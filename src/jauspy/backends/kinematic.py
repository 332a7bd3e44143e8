"""The backend `kinematic`: a robot on tracks or wheels on an endless flat floor, without a physics engine."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.backends.kinematic_camera import KinematicCameras
from jauspy.errors import ConfigError
from jauspy.geometry.frames import HoldingEfforts, gravity_wrench
from jauspy.geometry.poses import Pose, Twist
from jauspy.geometry.urdf import Joint, RobotDescription
from jauspy.platform.backend import PlacedRobot
from jauspy.platform.camera import CameraSource
from jauspy.platform.chassis import measure
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import GroupSetup, RobotModel, TrackSetup
from jauspy.platform.drives import SLIP_FACTOR, FixedBase, SkidSteerDrive
from jauspy.platform.force_torque import SampledForceTorque
from jauspy.platform.joint_control import SetpointGenerator
from jauspy.platform.joints import ControlMode, JointState, Target, joint_positions
from jauspy.platform.lights import switched_lamps
from jauspy.platform.localizer import Localizer
from jauspy.platform.motors import MotorLoad
from jauspy.platform.power_supply import PowerSupply
from jauspy.platform.ranging import Scanner
from jauspy.platform.wheels import WheelDrive, WheelSetup

WORLDS: Final = ("empty", "house", "lost_property", "rough", "rubble", "street", "workbench", "yard")
"""Names of worlds; their obstacles do not exist for a kinematic robot."""

MAX_STEP: Final = 0.005
"""Longest integration step, seconds."""
SUPPLY_RATE: Final = 10.0
"""Hertz at which the power that it takes is measured."""


class KinematicBackend:
    """A `Backend` of kinematic robots; each of the `WORLDS` is a flat floor."""

    name: str = "kinematic"

    def open(self, robot: RobotModel, world: str) -> KinematicRobot:
        """A robot at rest at the origin. Raises `ConfigError` for another world, and for a factory cell."""
        if robot.cell is not None:
            raise ConfigError("the kinematic backend has no factory cells: parts need physics; choose the backend sim")
        if world not in WORLDS:
            raise ConfigError(
                f"the kinematic backend has no world {world!r}; it has: {', '.join(WORLDS)}, each a flat floor"
            )
        return KinematicRobot(robot)

    def open_several(self, robots: Sequence[PlacedRobot], world: str) -> Sequence[KinematicRobot]:
        """Open robots on one floor, where they neither see nor touch each other. Raises `ConfigError` as `open`."""
        opened = [self.open(placed.robot, world) for placed in robots]
        for robot, placed in zip(opened, robots, strict=True):
            robot.place(placed.start)
        return opened


class KinematicRobot:
    """A `Robot`: its joints ignore gravity, and its lidars find no obstacles.

    Its force-torque sensors measure the weight of its own links.
    """

    def __init__(self, robot: RobotModel) -> None:
        tracks = robot.tracks
        self._tracked = _tracks(robot.description, tracks) if tracks else None
        self._wheels = KinematicWheels(robot.wheels) if robot.wheels else None
        self._rolling = self._tracked or self._wheels
        self.drive: KinematicDrive | KinematicWheels | FixedBase = self._rolling or FixedBase()
        """The chassis."""
        self._localization = robot.localization
        self._localizer = self._make_localizer()
        self.groups: Mapping[str, KinematicJoints] = {
            name: KinematicJoints(robot.description, setup) for name, setup in robot.groups.items()
        }
        """Joints besides the chassis, by the names of their groups in the description."""
        self._cameras = KinematicCameras(robot, self.drive, self.groups)
        self._lamps = switched_lamps(robot.lamps)
        self.lidars: Mapping[str, Scanner] = {setup.name: Scanner(setup) for setup in robot.lidars}
        """Lidars by name."""
        self.force_torque: Mapping[str, SampledForceTorque] = {
            setup.name: SampledForceTorque(setup, gravity_wrench(robot.description, setup.link, self._positions))
            for setup in robot.force_torque
        }
        """Force-torque sensors by name: they measure the weight of the links beyond them, without noise."""
        self._holding = HoldingEfforts(robot.description)
        self._held: tuple[tuple[JointState, ...], Mapping[str, float]] = (), {}
        """States of the joints, and the efforts that hold the links there."""
        self._mass = measure(robot).mass if robot.battery else 0.0
        self._supply = PowerSupply(robot, self._lamps, self._motor_loads, self._halt, SUPPLY_RATE)
        self._time = 0.0
        self._measure()

    def place(self, start: Pose) -> None:
        """Put the robot where it starts (x, y and yaw), before it is advanced."""
        if self._rolling is not None:
            self._rolling.place(start)
            self._localizer = self._make_localizer()

    def _make_localizer(self) -> Localizer | None:
        if self._rolling is None or self._localization.is_exact(default=True):
            return None
        return Localizer(self._localization, self._rolling)

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """Cameras by name, which show sky and floor."""
        return self._cameras.cameras

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """Parts of the chassis, the localisation unless exact, lamps (cameras do not show their light), battery."""
        located = () if self._localizer is None else (self._localizer,)
        return (*self.drive.optional_parts, *located, *self._lamps, *self._supply.parts)

    @property
    def time(self) -> float:
        """Seconds since it was opened."""
        return self._time

    def advance(self, dt: float) -> None:
        """Advance by exactly `dt` seconds, in equal steps of at most `MAX_STEP`."""
        if not 0.0 <= dt < math.inf:
            raise ValueError(f"cannot advance by {dt} s; time only goes forward")
        before = self.drive.twist()
        steps = math.ceil(dt / MAX_STEP)
        rolling = () if self._rolling is None else (self._rolling,)
        moving = [part for part in (*rolling, *self.groups.values()) if not part.is_at_rest]
        for number in range(steps):
            for part in moving:
                part.step(dt / steps)
            if self._localizer is not None:
                self._localizer.step(self._time + (number + 1) * dt / steps)
        if steps and self._rolling is not None:
            self._rolling.update_acceleration(before, dt)
        self._time += dt
        self._measure()
        self._cameras.update()

    def _measure(self) -> None:
        for lidar in self.lidars.values():
            lidar.step(self._time)
        for sensor in self.force_torque.values():
            sensor.step(self._time)
        self._supply.step(self._time)

    def _motor_loads(self) -> Iterator[MotorLoad]:
        """The loads of the motors: joints carry the weight of the links beyond them, on level ground."""
        states = tuple(group.state() for group in self.groups.values())
        if self._held[0] != states:
            self._held = states, self._holding.at(self._positions())
        for group, state in zip(self.groups.values(), states, strict=True):
            for joint, velocity in zip(group.joints, state.velocities, strict=True):
                effort = min(joint.effort, max(-joint.effort, self._held[1].get(joint.name, 0.0)))
                yield MotorLoad(joint.name, effort, velocity)
        if self._rolling is not None:
            yield from self._rolling.motor_loads(self._mass)

    def _halt(self) -> None:
        """Stop all motors."""
        self.drive.stop()
        for group in self.groups.values():
            group.hold()

    def _positions(self) -> Mapping[str, float]:
        return joint_positions(self.groups.values())

    def close(self) -> None:
        """Stop, and release the shared states of the cameras."""
        self._halt()
        self._cameras.close()


@dataclass(frozen=True, slots=True)
class SkidSteerParameters:
    """A tracked chassis. Speeds in m/s, accelerations in m/s^2, lengths in metres, times in seconds."""

    free_speed: float = 1.9
    """Track speed at full effort without resistance."""
    response: float = 0.15
    """Time constant with which a track follows its effort (drag against drive force)."""
    friction: float = 0.2
    """Deceleration by friction in the drive, whatever the speed."""
    brake: float = 4.0
    """Deceleration that the brake adds at zero effort."""
    slip_width: float = 1.1
    """Distance of two wheels that turn as the tracks do; larger than the tracks' distance because of slip."""


class KinematicDrive(SkidSteerDrive):
    """The chassis of a kinematic robot: a `DriveBase`."""

    def __init__(self, parameters: SkidSteerParameters, motors: tuple[Joint, ...] = ()) -> None:
        """`motors`: the joints of the belts that the left and the right motor drive."""
        super().__init__(parameters.slip_width)
        self._motors = motors
        self._parameters = parameters
        self._efforts = (0.0, 0.0)
        self._left = self._right = 0.0
        self._x = self._y = self._yaw = 0.0

    def place(self, start: Pose) -> None:
        """Put the chassis there, at rest."""
        self._x, self._y, self._yaw = start.x, start.y, start.yaw

    def set_track_efforts(self, left: float, right: float) -> None:
        """Drive the tracks with fractions of their full efforts, -1..1; zero for both brakes."""
        self._efforts = (left, right)

    def pose(self) -> Pose:
        """Pose on the floor; the yaw is within -pi..pi."""
        return Pose(x=self._x, y=self._y, yaw=math.remainder(self._yaw, math.tau))

    def twist(self) -> Twist:
        """Forward speed and yaw rate."""
        return Twist(
            vx=(self._left + self._right) / 2.0,
            wz=(self._right - self._left) / self._parameters.slip_width,
        )

    def track_speeds(self) -> tuple[float, float]:
        """Same as `SkidSteerDrive.track_speeds`."""
        return self._left, self._right

    def motor_loads(self, mass: float) -> Iterator[MotorLoad]:
        """Force and speed of each motor; `mass`: of the robot, kg."""
        speeds, parameters = (self._left, self._right), self._parameters
        for joint, effort, speed in zip(self._motors, self._efforts, speeds, strict=False):
            pull = mass / 2.0 * (effort * parameters.free_speed - speed) / parameters.response if effort else 0.0
            yield _limited_load(joint, pull, speed)

    @property
    def is_at_rest(self) -> bool:
        """True if steps do not move it."""
        return not (any(self._efforts) or self._left or self._right)

    def step(self, dt: float) -> None:
        """Move for `dt` seconds along the arc that the tracks' mean speeds describe."""
        before = self.twist()
        left, right = self._efforts
        self._left = track_speed_after(self._left, left, dt, self._parameters)
        self._right = track_speed_after(self._right, right, dt, self._parameters)
        after = self.twist()
        distance = (before.vx + after.vx) / 2.0 * dt
        turn = (before.wz + after.wz) / 2.0 * dt
        heading = self._yaw + turn / 2.0
        self._x += distance * math.cos(heading)
        self._y += distance * math.sin(heading)
        self._yaw += turn


def _limited_load(joint: Joint, effort: float, velocity: float) -> MotorLoad:
    return MotorLoad(joint.name, min(joint.effort, max(-joint.effort, effort)), velocity)


def _tracks(description: RobotDescription, tracks: TrackSetup) -> KinematicDrive:
    motors = (description.joint(tracks.left[0]), description.joint(tracks.right[0]))
    return KinematicDrive(skid_steer_parameters(description, tracks), motors)


def skid_steer_parameters(description: RobotDescription, tracks: TrackSetup) -> SkidSteerParameters:
    """Return the chassis parameters of a robot; speed and distance of the tracks are those of its URDF."""
    left, right = (description.joint(name) for name in (tracks.left[0], tracks.right[0]))
    gauge = abs(left.origin.y - right.origin.y)
    return SkidSteerParameters(free_speed=left.velocity, slip_width=SLIP_FACTOR * gauge)


def track_speed_after(speed: float, effort: float, dt: float, parameters: SkidSteerParameters) -> float:
    """Return the speed of a track after `dt` seconds at an effort; friction slows it, and never reverses it."""
    resistance = parameters.friction + (parameters.brake if effort == 0.0 else 0.0)
    driven = speed + (effort * parameters.free_speed - speed) * (1.0 - math.exp(-dt / parameters.response))
    return math.copysign(max(0.0, abs(driven) - resistance * dt), driven)


class KinematicJoints:
    """A `JointGroup` of joints that follow their set points exactly.

    Commanded by effort, a joint moves as if its damping were all that resists: full effort is full speed.
    """

    def __init__(self, description: RobotDescription, setup: GroupSetup) -> None:
        self._joints = tuple(description.joint(name) for name in setup.joints)
        self._chain = description.chain(setup.base, setup.tip)
        self._motions = [
            SetpointGenerator(joint, start) for joint, start in zip(self._joints, setup.start, strict=True)
        ]
        self._efforts = [0.0] * len(self._joints)
        self._state: JointState | None = None
        """State since the last change; None when it has to be made."""

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip; None keeps a joint's target."""
        self._state = None
        for number, (motion, target) in enumerate(zip(self._motions, targets, strict=True)):
            if target is None:
                continue
            limit = motion.joint.effort
            by_effort = target.mode is ControlMode.EFFORT
            self._efforts[number] = min(limit, max(-limit, target.value)) if by_effort else 0.0
            motion.target = _to_velocity(motion.joint, target) if by_effort else target

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        for motion in self._motions:
            motion.hold(motion.position)
        self._efforts = [0.0] * len(self._joints)
        self._state = None

    def state(self) -> JointState:
        """Positions and velocities after the last step; efforts as commanded."""
        if self._state is None:
            positions, velocities = zip(*((motion.position, motion.velocity) for motion in self._motions), strict=True)
            self._state = JointState(positions, velocities, tuple(self._efforts))
        return self._state

    @property
    def is_at_rest(self) -> bool:
        """True if steps do not move it."""
        return all(motion.arrived for motion in self._motions)

    def step(self, dt: float) -> None:
        """Move for `dt` seconds."""
        for motion in self._motions:
            if not motion.arrived:
                motion.advance(dt)
                self._state = None


def _to_velocity(joint: Joint, target: Target) -> Target:
    fraction = target.value / joint.effort if joint.effort else 0.0
    fastest = min(joint.velocity, target.speed or math.inf)
    speed = fastest * min(1.0, max(-1.0, fraction)) if math.isfinite(fraction) else 0.0
    return Target(ControlMode.VELOCITY, speed, acceleration=target.acceleration)


RESPONSE: Final = 0.15
"""Seconds, the time constant with which a wheel follows its effort."""
FRICTION: Final = 0.2
"""m/s^2, the deceleration by friction in the drive."""
BRAKE: Final = 4.0
"""m/s^2 that the brake adds at zero effort."""


class KinematicWheels(WheelDrive):
    """A chassis on wheels; they never slip, but for those that skid."""

    def __init__(self, wheels: WheelSetup) -> None:
        super().__init__(wheels)
        self._efforts = (0.0,) * len(wheels.wheels)
        self._speeds = [0.0] * len(wheels.wheels)
        self._angle = self._wanted_angle = 0.0
        self._x = self._y = self._yaw = 0.0

    def place(self, start: Pose) -> None:
        """Put the chassis there, at rest."""
        self._x, self._y, self._yaw = start.x, start.y, start.yaw

    def set_wheel_efforts(self, efforts: tuple[float, ...], steering: float | None) -> None:
        """Drive the wheels and steer."""
        self._efforts = efforts
        self._wanted_angle = self._wanted_angle if steering is None else steering

    def pose(self) -> Pose:
        """Pose on the floor; the yaw is within -pi..pi."""
        return Pose(x=self._x, y=self._y, yaw=math.remainder(self._yaw, math.tau))

    def twist(self) -> Twist:
        """Velocity by the wheels as they roll."""
        vx, vy, wz = self.odometry()
        return Twist(vx=vx, vy=vy, wz=wz)

    def rim_speeds(self) -> Sequence[float]:
        """m/s, positive forward."""
        return self._speeds

    def motor_loads(self, mass: float) -> Iterator[MotorLoad]:
        """Torque and rate of the motor of each wheel; `mass`: of the robot, kg."""
        wheels = self.wheels.wheels
        for wheel, effort, speed in zip(wheels, self._efforts, self._speeds, strict=True):
            pull = mass / len(wheels) * (effort * wheel.speed - speed) / RESPONSE if effort else 0.0
            yield _limited_load(wheel.joint, pull * wheel.radius, speed / wheel.radius)

    @property
    def steering(self) -> float:
        """Angle of steering to the left, radians."""
        return self._angle

    @property
    def is_at_rest(self) -> bool:
        """True if steps do not move it."""
        return not (any(self._efforts) or any(self._speeds)) and self._angle == self._wanted_angle

    def step(self, dt: float) -> None:
        """Move for `dt` seconds."""
        before = self.twist()
        braking = not any(self._efforts)
        for number, (wheel, effort) in enumerate(zip(self.wheels.wheels, self._efforts, strict=True)):
            self._speeds[number] = _speed_after(self._speeds[number], effort * wheel.speed, dt, braking=braking)
        if self.wheels.steering:
            change = min(joint.joint.velocity for joint in self.wheels.steering) * dt
            self._angle += min(change, max(-change, self._wanted_angle - self._angle))
        after = self.twist()
        vx, vy, wz = ((b + a) / 2.0 for b, a in ((before.vx, after.vx), (before.vy, after.vy), (before.wz, after.wz)))
        heading = self._yaw + wz * dt / 2.0
        self._x += (vx * math.cos(heading) - vy * math.sin(heading)) * dt
        self._y += (vx * math.sin(heading) + vy * math.cos(heading)) * dt
        self._yaw += wz * dt


def _speed_after(speed: float, free: float, dt: float, *, braking: bool) -> float:
    """The speed of a rim, m/s, that would reach `free` without resistance; friction never reverses it."""
    driven = speed + (free - speed) * (1.0 - math.exp(-dt / RESPONSE))
    resistance = (FRICTION + (BRAKE if braking else 0.0)) * dt
    return math.copysign(max(0.0, abs(driven) - resistance), driven)
