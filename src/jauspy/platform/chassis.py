"""Size, mass and limits of chassis, and base classes of the drives of all backends."""

from __future__ import annotations

import itertools
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import AT_REST, ORIGIN, UNACCELERATED, Acceleration, Pose, Transform, Twist
from jauspy.geometry.urdf import CollisionBox, Inertial, collision_boxes, inertials
from jauspy.geometry.vectors import Vector
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink
from jauspy.platform.description import RobotModel, TiltSetup

if TYPE_CHECKING:
    from jauspy.platform.wheels import WheelSetup
SLIP_FACTOR: Final = 2.4
"""Distance of two wheels that turn as the tracks do, as a multiple of the tracks' distance; slip makes it larger."""

SPEED_ON_GROUND: Final = 0.95
"""Speed on the ground as a fraction of the tracks' speed without resistance."""


@dataclass(frozen=True, slots=True)
class Chassis:
    """Metres, kilograms, m/s, m/s^2, rad/s, rad/s^2; the defaults are those of a small tracked robot.

    Sizes are distances from the base's origin with the arm as it starts; the centre of gravity is in the base's frame
    (x forward, y left, z up).
    """

    max_speed: float = 1.5
    """Fastest forward and backward."""
    max_turn_rate: float = 1.2
    """Fastest turn that guidance commands; a tracked robot could turn faster, but not safely with a load."""
    acceleration: float = 1.0
    deceleration: float = 1.5
    turn_acceleration: float = 3.0
    track_separation: float = 0.46
    """Distance between the centres of the tracks, or of the wheels of both sides."""
    min_turn_radius: float = 0.0
    """Narrowest curve; 0 if it turns on the spot."""
    steering_angle: float = 0.0
    """The greatest, of a chassis that steers, in radians."""
    wheel_base: float = 0.0
    wheel_radius: float = 0.0
    """0 for tracks."""
    moves_sideways: bool = False
    front: float = 0.345
    back: float = 0.345
    left: float = 0.28
    right: float = 0.28
    top: float = 0.29
    bottom: float = 0.0
    mass: float = 50.3
    centre_of_gravity: tuple[float, float, float] = (0.0, 0.0, 0.16)
    tilt_guard: TiltSetup | None = None
    """The tilt at which it is stopped."""


def chassis_of(robot: RobotModel) -> Chassis:
    """Return the chassis of a robot: size, mass and tracks from its description, the rest by default."""
    if robot.wheels is not None:
        return _wheeled(robot, robot.wheels)
    if robot.tracks is None:
        raise ConfigError(
            f"{robot.description.name} has neither tracks nor wheels: its base is fixed, and nothing can drive it"
        )
    left, right = (robot.description.joint(name) for name in (robot.tracks.left[0], robot.tracks.right[0]))
    return _measured(
        robot,
        Chassis(
            max_speed=SPEED_ON_GROUND * min(left.velocity, right.velocity),
            track_separation=abs(left.origin.y - right.origin.y),
        ),
    )


def _wheeled(robot: RobotModel, wheels: WheelSetup) -> Chassis:
    return _measured(
        robot,
        Chassis(
            max_speed=SPEED_ON_GROUND * wheels.free_speed,
            track_separation=wheels.track,
            min_turn_radius=wheels.turning_radius,
            steering_angle=wheels.steering_angle,
            wheel_base=wheels.wheel_base,
            wheel_radius=wheels.wheels[0].radius,
            moves_sideways=wheels.moves_sideways,
        ),
    )


def _measured(robot: RobotModel, chassis: Chassis) -> Chassis:
    """The chassis with the size and mass of the robot."""
    found = measure(robot)
    return replace(
        chassis,
        front=max(0.0, found.high[0]),
        back=max(0.0, -found.low[0]),
        left=max(0.0, found.high[1]),
        right=max(0.0, -found.low[1]),
        top=max(0.0, found.high[2]),
        bottom=max(0.0, -found.low[2]),
        mass=found.mass,
        centre_of_gravity=found.centre_of_gravity,
        tilt_guard=robot.tilt_guard,
    )


@dataclass(frozen=True, slots=True)
class Measures:
    """Mass and size of a robot, in the frame of its root link; kilograms and metres."""

    mass: float
    centre_of_gravity: Vector
    low: Vector
    """Minimal x, y and z of the collision shapes."""
    high: Vector
    """Maximal x, y and z of the collision shapes."""


def measure(robot: RobotModel) -> Measures:
    """Measure the robot in its initial pose. Meshes are ignored, since URDF has no size of them."""
    starts = {
        joint: start for group in robot.groups.values() for joint, start in zip(group.joints, group.start, strict=True)
    }
    frames = FrameTree(robot.description).poses(starts)
    urdf = robot.description.urdf
    masses = [
        (body, frames[body.link].apply((body.origin.x, body.origin.y, body.origin.z))) for body in inertials(urdf)
    ]
    mass = sum(body.mass for body, _ in masses)
    corners = list(_corners(frames, collision_boxes(urdf)))
    return Measures(mass, _centre_of_gravity(masses, mass), _smallest(corners), _largest(corners))


def _centre_of_gravity(masses: list[tuple[Inertial, Vector]], mass: float) -> Vector:
    x, y, z = (sum(body.mass * at[axis] for body, at in masses) / (mass or 1.0) for axis in range(3))
    return x, y, z


def _corners(frames: dict[str, Transform], found: list[CollisionBox]) -> Iterator[Vector]:
    for shape in found:
        frame = frames[shape.link] @ Transform.from_pose(shape.origin)
        for signs in itertools.product((-1.0, 1.0), repeat=3):
            x, y, z = (sign * size / 2.0 for sign, size in zip(signs, shape.size, strict=True))
            yield frame.apply((x, y, z))


def _smallest(corners: list[Vector]) -> Vector:
    x, y, z = (min((corner[axis] for corner in corners), default=0.0) for axis in range(3))
    return x, y, z


def _largest(corners: list[Vector]) -> Vector:
    x, y, z = (max((corner[axis] for corner in corners), default=0.0) for axis in range(3))
    return x, y, z


class ParkingBrake(OptionalPart):
    """A brake that holds the chassis until it is released; efforts do not move it meanwhile."""

    @property
    def id(self) -> PartId:
        """The part id; a robot has at most one parking brake."""
        return PartId(ParkingBrake)

    @property
    @abstractmethod
    def engaged(self) -> bool:
        """True while it holds the chassis."""

    @abstractmethod
    def set(self, engaged: bool) -> None:
        """Engage or release the brake. The chassis then stands until its next effort."""

    def state(self) -> object:
        """Whether it is engaged."""
        return self.engaged

    def proxy(self, link: RobotLink) -> ParkingBrake:
        """The brake for other threads."""
        return _ParkingBrakeProxy(link)


@dataclass(frozen=True, slots=True)
class ParkingBrakeCommand(Command):
    """Engage or release the parking brake."""

    engaged: bool

    @property
    def part(self) -> PartId:
        """The brake."""
        return PartId(ParkingBrake)

    def apply(self, robot: Robot) -> None:
        """Set the brake."""
        if (brake := ParkingBrake.of(robot)) is not None:
            brake.set(self.engaged)


class _ParkingBrakeProxy(ParkingBrake):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    @property
    def engaged(self) -> bool:
        return self._link.snapshot.parts[self.id] is True

    def set(self, engaged: bool) -> None:
        self._link.submit(ParkingBrakeCommand(engaged))


class _HoldingBrake(ParkingBrake):
    """Holds with the brakes of the tracks."""

    engaged = False

    def __init__(self, drive: GroundDrive) -> None:
        self._drive = drive

    def set(self, engaged: bool) -> None:
        self.engaged = engaged
        self._drive.stop()


class FixedBase:
    """The `DriveBase` of a robot whose base is fixed to the world: it stays at the origin, whatever the effort."""

    optional_parts: tuple[OptionalPart, ...] = ()

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Do nothing."""

    def stop(self) -> None:
        """Do nothing: it stands."""

    def pose(self) -> Pose:
        """The world's origin."""
        return ORIGIN

    def twist(self) -> Twist:
        """Zero."""
        return AT_REST

    def acceleration(self) -> Acceleration:
        """Zero."""
        return UNACCELERATED


class GroundDrive(ABC):
    """A `DriveBase` with a parking brake, the base class of the drives of all backends."""

    def __init__(self) -> None:
        self._acceleration = Acceleration()
        self._brake = _HoldingBrake(self)
        self.optional_parts: tuple[OptionalPart, ...] = (self._brake,)

    @property
    def braked(self) -> bool:
        """True while the parking brake is engaged."""
        return self._brake.engaged

    @abstractmethod
    def stop(self) -> None:
        """Brake to a standstill and hold it, also on a slope."""

    @abstractmethod
    def pose(self) -> Pose:
        """Pose of the base in the world."""

    @abstractmethod
    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""

    def acceleration(self) -> Acceleration:
        """Mean of the last `Robot.advance`, in the frame of the base."""
        return self._acceleration

    def update_acceleration(self, before: Twist, dt: float) -> None:
        """Take the mean acceleration of the last `dt` seconds, at whose beginning the twist was `before`."""
        self._acceleration = mean_acceleration(before, self.twist(), dt)


class SkidSteerDrive(GroundDrive):
    """A `DriveBase` with two tracks."""

    def __init__(self, slip_width: float = 1.0) -> None:
        super().__init__()
        self.slip_width = slip_width
        """Distance of two wheels, in metres, that turn as the tracks do; larger than theirs because of slip."""

    def track_speeds(self) -> tuple[float, float]:
        """Speeds of the left and right track, as encoders in their drives measure them: m/s, positive forward.

        By default, those of tracks that do not slip.
        """
        twist = self.twist()
        return twist.vx - twist.wz * self.slip_width / 2.0, twist.vx + twist.wz * self.slip_width / 2.0

    def odometry(self) -> tuple[float, float, float]:
        """Velocity by the tracks, as if they did not slip: m/s forward and to the left, rad/s to the left."""
        left, right = self.track_speeds()
        return (left + right) / 2.0, 0.0, (right - left) / self.slip_width

    @abstractmethod
    def set_track_efforts(self, left: float, right: float) -> None:
        """Drive the tracks with fractions of their full efforts, -1..1; zero for both brakes and then holds."""

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:  # noqa: ARG002 - never
        """Drive with fractions of the full effort, -1..1, clamped; positive z turns left. Tracks do not go sideways."""
        if not self.braked:
            self.set_track_efforts(*mix(linear_x, rotational_z))

    def stop(self) -> None:
        """Brake to a standstill and hold it, also on a slope."""
        self.set_track_efforts(0.0, 0.0)


def mix(linear_x: float, rotational_z: float) -> tuple[float, float]:
    """Efforts of the left and right track, -1..1; if one would exceed 1, both are scaled, which keeps the curvature."""
    linear, rotational = clamp(linear_x), clamp(rotational_z)
    left, right = linear - rotational, linear + rotational
    scale = max(1.0, abs(left), abs(right))
    return left / scale, right / scale


def clamp(effort: float) -> float:
    """Limit an effort to -1..1; NaN means no effort."""
    if effort != effort:  # noqa: PLR0124 - only NaN differs from itself
        return 0.0
    return min(1.0, max(-1.0, effort))


def mean_acceleration(before: Twist, after: Twist, dt: float) -> Acceleration:
    """Mean over the `dt` seconds (more than 0) between two body twists.

    The frame rotates with the body, so the term rate times speed is added to the change of velocity.
    """
    vx, vy, vz = _mean(before.vx, after.vx), _mean(before.vy, after.vy), _mean(before.vz, after.vz)
    wx, wy, wz = _mean(before.wx, after.wx), _mean(before.wy, after.wy), _mean(before.wz, after.wz)
    return Acceleration(
        ax=(after.vx - before.vx) / dt + wy * vz - wz * vy,
        ay=(after.vy - before.vy) / dt + wz * vx - wx * vz,
        az=(after.vz - before.vz) / dt + wx * vy - wy * vx,
        wx=(after.wx - before.wx) / dt,
        wy=(after.wy - before.wy) / dt,
        wz=(after.wz - before.wz) / dt,
    )


def _mean(before: float, after: float) -> float:
    return (before + after) / 2.0
