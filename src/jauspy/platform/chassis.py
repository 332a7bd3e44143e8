"""Size, mass and limits of chassis."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, Inertial, collision_boxes, inertials
from jauspy.geometry.vectors import Vector
from jauspy.platform.description import RobotModel, TiltSetup
from jauspy.platform.wheels import WheelSetup

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
    x, y, z = (sum(body.mass * position[axis] for body, position in masses) / (mass or 1.0) for axis in range(3))
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
