"""Base classes of the drives of all backends, and the parking brake."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.poses import AT_REST, ORIGIN, UNACCELERATED, Acceleration, Pose, Twist
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink

SLIP_FACTOR: Final = 2.4
"""Distance of two wheels that turn as the tracks do, as a multiple of the tracks' distance; slip makes it larger."""


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
        """True while the brake is engaged."""
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
