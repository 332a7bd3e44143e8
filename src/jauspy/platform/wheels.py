"""Wheeled chassis: what they are made of, and how efforts become those of wheels and angles of steering.

Frames as in REP-103: x forward, y left, z up, in the frame of the root link; metres, radians.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Final

from annotated_types import Interval, Len, MaxLen

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription, collision_boxes
from jauspy.platform.drives import GroundDrive, clamp, mix
from jauspy.platform.tables import Table, UrdfName, check_unique

LEVEL: Final = 0.9
"""Least cosine between the axle of a wheel and the y axis."""
SKID_FACTOR: Final = 2.4
"""Distance of two wheels that turn as the skidding ones do, as a multiple of their distance."""
MAX_STEERING: Final = 1.4
"""Radians that a wheel steers at most, whatever its joint can do."""
MIN_TRACK: Final = 0.01
"""Metres between left and right wheels, and between axles, that a chassis has at least."""


class WheelKind(Enum):
    """Kinds of wheeled chassis by how they turn; the values are those of `type` in TOML."""

    SKID_STEER = "skid_steer"
    ACKERMANN = "ackermann"
    MECANUM = "mecanum"


@dataclass(frozen=True, slots=True)
class Wheel:
    """A driven wheel."""

    joint: Joint
    x: float
    y: float
    """Position of the wheel's centre in the root link, metres."""
    radius: float
    sign: float
    """1.0 if it rolls forward as its joint's position grows, -1.0 if backward."""

    @property
    def speed(self) -> float:
        """Speed of the rim without resistance, m/s."""
        return self.joint.velocity * self.radius

    @property
    def rollers(self) -> float:
        """Direction of a mecanum wheel's rollers: 1.0 if they let it move front left, -1.0 front right."""
        return math.copysign(1.0, self.x * self.y)


@dataclass(frozen=True, slots=True)
class SteeringJoint:
    """A steering joint, which turns to the left as its position times `sign` grows; its axis is at x, y."""

    joint: Joint
    x: float
    y: float
    sign: float


@dataclass(frozen=True, slots=True)
class WheelSetup:
    """The wheels of a chassis."""

    kind: WheelKind
    wheels: tuple[Wheel, ...]
    """Driven wheels."""
    inertia: float
    """Inertia of each wheel's rotor and gear, at the wheel, kg m^2."""
    steering: tuple[SteeringJoint, ...] = ()
    axle: float = 0.0
    """x of the wheels that do not steer, of an Ackermann chassis."""

    @property
    def free_speed(self) -> float:
        """Speed of the chassis without resistance, m/s."""
        return min(wheel.speed for wheel in self.wheels)

    @property
    def moves_sideways(self) -> bool:
        """True on mecanum wheels."""
        return self.kind is WheelKind.MECANUM

    @property
    def track(self) -> float:
        """Metres between the middles of left and right wheels."""
        return 2.0 * sum(abs(wheel.y) for wheel in self.wheels) / len(self.wheels)

    @property
    def wheel_base(self) -> float:
        """Metres from the first to the last axle."""
        axle_positions = [wheel.x for wheel in self.wheels] + [joint.x for joint in self.steering]
        axle_positions += [self.axle] if self.steering else []
        return max(axle_positions) - min(axle_positions)

    @property
    def steering_angle(self) -> float:
        """The greatest angle of a wheel in the middle of the steered axle; 0 for other chassis."""
        if not self.steering:
            return 0.0
        inner = min(min(joint.joint.upper, -joint.joint.lower, MAX_STEERING) for joint in self.steering)
        side = max(abs(joint.y) for joint in self.steering)
        return math.atan(self.wheel_base / (self.wheel_base / math.tan(inner) + side))

    @property
    def turning_radius(self) -> float:
        """Metres, of the narrowest curve of the middle of the fixed axle; 0 if it turns on the spot."""
        return self.wheel_base / math.tan(self.steering_angle) if self.steering else 0.0

    def efforts(self, linear_x: float, rotational_z: float, linear_y: float) -> tuple[float, ...]:
        """The efforts of the wheels, -1..1; all are scaled if one would exceed 1, which keeps the direction."""
        if self.kind is WheelKind.SKID_STEER:
            left, right = mix(linear_x, rotational_z)
            return tuple(left if wheel.y > 0.0 else right for wheel in self.wheels)
        if self.kind is WheelKind.ACKERMANN:
            return (clamp(linear_x),) * len(self.wheels)
        x, y, z = clamp(linear_x), clamp(linear_y), clamp(rotational_z)
        wanted = [x - wheel.rollers * y - math.copysign(1.0, wheel.y) * z for wheel in self.wheels]
        scale = max(1.0, *map(abs, wanted))
        return tuple(effort / scale for effort in wanted)

    def velocity(self, speeds: Sequence[float], steering: float) -> tuple[float, float, float]:
        """Velocity of the root link if no wheel slips: m/s forward and to the left, rad/s to the left.

        `speeds`: of the rims, m/s, positive forward; `steering`: the angle of the middle of the steered axle.
        """
        forward = sum(speeds) / len(speeds)
        if self.kind is WheelKind.ACKERMANN:
            rate = forward * math.tan(steering) / self.wheel_base
            return forward, -rate * self.axle, rate
        rows = list(zip(self.wheels, speeds, strict=True))
        turning = -sum(math.copysign(1.0, wheel.y) * speed for wheel, speed in rows) / len(rows)
        if self.kind is WheelKind.SKID_STEER:
            return forward, 0.0, 2.0 * turning / (SKID_FACTOR * self.track)
        sideways = -sum(wheel.rollers * speed for wheel, speed in rows) / len(rows)
        lever = sum(abs(wheel.x) + abs(wheel.y) for wheel in self.wheels) / len(rows)
        return forward, sideways, turning / lever

    def steering_angles(self, angle: float) -> tuple[float, ...]:
        """Positions of the steering joints at which all wheels roll about one point; `angle`: of the axle's middle."""
        if abs(angle) < 1e-6:
            return (0.0,) * len(self.steering)
        centre = self.wheel_base / math.tan(angle)  # y of the point about which the chassis turns
        return tuple(
            joint.sign * math.copysign(1.0, joint.x - self.axle) * math.atan(self.wheel_base / (centre - joint.y))
            for joint in self.steering
        )


class WheelDrive(GroundDrive):
    """A `DriveBase` on wheels: what the drives of both backends share."""

    def __init__(self, wheels: WheelSetup) -> None:
        super().__init__()
        self.wheels = wheels

    @abstractmethod
    def rim_speeds(self) -> Sequence[float]:
        """Speeds of the wheels' rims, as encoders measure them, m/s, positive forward."""

    @property
    @abstractmethod
    def steering(self) -> float:
        """The present angle of the middle of the steered axle, to the left."""

    def odometry(self) -> tuple[float, float, float]:
        """Velocity by the wheels, as if they did not slip: m/s forward and to the left, rad/s to the left."""
        return self.wheels.velocity(self.rim_speeds(), self.steering)

    @abstractmethod
    def set_wheel_efforts(self, efforts: tuple[float, ...], steering: float | None) -> None:
        """Drive each wheel with a fraction of its effort, all zero to brake; steer to an angle, None to keep it."""

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort, -1..1, clamped; positive y is left.

        Positive z turns left; it is the steering angle of an Ackermann chassis, as a fraction of the greatest one.
        """
        if self.braked:
            return
        steering = clamp(rotational_z) * self.wheels.steering_angle if self.wheels.steering else None
        self.set_wheel_efforts(self.wheels.efforts(linear_x, rotational_z, linear_y), steering)

    def stop(self) -> None:
        """Brake to a standstill and hold it; the steering stays as it is."""
        self.set_wheel_efforts((0.0,) * len(self.wheels.wheels), None)


@dataclass(frozen=True, slots=True, kw_only=True)
class WheelJoints(Table):
    """A chassis on wheels, the table `[wheels]`: the continuous joints of its driven wheels; others roll freely."""

    type: WheelKind
    left: Annotated[tuple[UrdfName, ...], Len(1, 8)]
    right: Annotated[tuple[UrdfName, ...], Len(1, 8)]
    steered: Annotated[tuple[UrdfName, ...], MaxLen(8)] = ()
    """Revolute joints that turn the wheels of one axle, of an ackermann chassis."""
    radius: Annotated[float, Interval(gt=0.0, le=5.0)] | None = None
    """Metres; None: that of the collision shape of each wheel."""
    inertia: Annotated[float, Interval(gt=0.0, le=1000.0)] = 0.02
    """Inertia of rotor and gear of each driven wheel, at the wheel, kg m^2."""

    def __post_init__(self) -> None:
        check_unique("left", (*self.left, *self.right, *self.steered))


def wheel_setup(description: RobotDescription, joints: WheelJoints) -> WheelSetup:
    """Measure the wheels in the URDF. Raises `ConfigError` with the key of `[wheels]` that does not match it."""
    frames = FrameTree(description).poses()
    radii = _radii(description)

    def wheel(key: str, name: str) -> Wheel:
        joint = _moving(description, f"wheels.{key}", name, (JointKind.CONTINUOUS,))
        frame = frames[joint.child]
        cosine = frame.rotate(joint.axis)[1]
        if abs(cosine) < LEVEL:
            raise ConfigError(f"wheels.{key}: the axle of {name!r} does not point to the side (y) of the robot")
        found = joints.radius or radii.get(joint.child)
        if found is None:
            raise ConfigError(
                f"wheels.{key}: the wheel {joint.child!r} has no cylinder or sphere as collision shape; "
                "give its radius as wheels.radius, in metres"
            )
        return Wheel(joint, frame.position[0], frame.position[1], found, math.copysign(1.0, cosine))

    def steering(name: str) -> SteeringJoint:
        joint = _moving(description, "wheels.steered", name, (JointKind.REVOLUTE,))
        frame = frames[joint.child]
        up = frame.rotate(joint.axis)[2]
        if abs(up) < LEVEL or not joint.lower < 0.0 < joint.upper:
            raise ConfigError(f"wheels.steered: {name!r} must turn about z, by limits below and above zero")
        return SteeringJoint(joint, frame.position[0], frame.position[1], math.copysign(1.0, up))

    sides = {
        "left": [wheel("left", name) for name in joints.left],
        "right": [wheel("right", name) for name in joints.right],
    }
    for key, sign in (("left", 1.0), ("right", -1.0)):
        for side in sides[key]:
            if sign * side.y < MIN_TRACK / 2.0:
                raise ConfigError(f"wheels.{key}: {side.joint.name!r} is not on the {key} of the robot")
    wheels = (*sides["left"], *sides["right"])
    steered = tuple(map(steering, joints.steered))
    axle = _fixed_axle(description, wheels, steered) if joints.type is WheelKind.ACKERMANN else 0.0
    setup = WheelSetup(joints.type, wheels, joints.inertia, steered, axle)
    _check_layout(setup)
    return setup


def _moving(description: RobotDescription, key: str, name: str, kinds: tuple[JointKind, ...]) -> Joint:
    joint = description.joints.get(name)
    if joint is None or joint.kind not in kinds or joint.mimics is not None:
        words = " or ".join(kind.value for kind in kinds)
        known = [joint.name for joint in description.joints.values() if joint.kind in kinds and joint.mimics is None]
        raise ConfigError(
            f"{key}: {name!r} is not a {words} joint of the URDF; those are: {', '.join(known) or 'none'}"
        )
    if joint.effort <= 0.0 or joint.velocity <= 0.0:
        raise ConfigError(f'{key}: the joint {name!r} needs <limit effort="..." velocity="..."> above zero in the URDF')
    return joint


def _radii(description: RobotDescription) -> dict[str, float]:
    """Radii of wheels by link: half of the diameter of its first collision shape that is round."""
    return {box.link: box.size[0] / 2.0 for box in reversed(collision_boxes(description.urdf)) if box.is_round}


def _fixed_axle(description: RobotDescription, wheels: tuple[Wheel, ...], steering: tuple[SteeringJoint, ...]) -> float:
    """X of the wheels that no steering joint turns; driven ones if there are, or else the others that roll."""
    frames = FrameTree(description)
    turned = {steered.joint.name for steered in steering}
    poses = frames.poses()
    rolling = [joint for joint in description.joints.values() if joint.kind is JointKind.CONTINUOUS]
    fixed = [j for j in rolling if not turned & {joint.name for joint in description.chain(frames.root, j.child)}]
    driven = [wheel.x for wheel in wheels if wheel.joint in fixed]
    places = driven or [poses[joint.child].position[0] for joint in fixed]
    if not places:
        raise ConfigError("wheels.steered: all wheels steer; an Ackermann chassis has wheels that do not")
    return sum(places) / len(places)


def _check_layout(setup: WheelSetup) -> None:
    if (setup.kind is WheelKind.ACKERMANN) != bool(setup.steering):
        raise ConfigError("wheels.steered: an ackermann chassis has steering joints, and no other type has any")
    if setup.kind is WheelKind.ACKERMANN and setup.wheel_base < MIN_TRACK:
        raise ConfigError("wheels.steered: the steered wheels are beside those that do not steer; they must be apart")
    if setup.kind is WheelKind.MECANUM and sorted((w.x > 0.0, w.y > 0.0) for w in setup.wheels) != _CORNERS:
        raise ConfigError("wheels: mecanum wheels are four: one in front and one behind the origin on each side")


_CORNERS: Final = [(False, False), (False, True), (True, False), (True, True)]
