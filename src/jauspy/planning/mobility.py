"""What a robot can drive on: its footprint, and the slopes and steps that its tracks, wheels and flippers climb."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Pose
from jauspy.geometry.urdf import Joint, JointKind, collision_boxes
from jauspy.geometry.vectors import GRAVITY
from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.description import RobotModel
from jauspy.platform.stability import StabilityModel, gravity_direction
from jauspy.platform.stability_setup import StabilitySetup

FRICTION: Final = 0.6
"""Friction of rubber on ground that is not known; slopes above its angle are not driven."""
TILT_RESERVE: Final = math.radians(10.0)
"""Radians kept to the tilt at which the robot is stopped, for bumps and for acceleration."""
AXLE_SHARE: Final = 0.8
"""Step that tracks climb without flippers, as a part of the height of their front axle."""
WHEEL_SHARE: Final = 0.5
"""Step that wheels climb, as a part of their radius."""
FLIPPER_ANGLE: Final = 0.05
"""Elevation of flippers at a step, radians. Their belts climb its edge and lift the front before the tracks meet its
face. Higher ones, from 0.15 rad on, lift it less or pass above the edge: at the height of their axle the tracks may
slip on the face for ever."""
TIP_SHARE: Final = 0.25
"""Height of an edge above the middle of the flippers' tips that their belts climb, as a part of their thickness."""
CLIMBING_PITCH: Final = math.radians(45.0)
"""Greatest pitch, radians, on the edge of a step; with more the robot falls back over its rear."""
LEVEL: Final = 0.01
"""Metres above the lowest point of tracks up to which a part of them stands on level ground."""

TILE: Final = 0.12
"""Side of the tiles along the edge of the footprint, as a part of half its width."""


@dataclass(frozen=True, slots=True)
class Mobility:
    """Footprint of a robot and the ground that it can drive on; metres and radians."""

    front: float
    back: float
    half_width: float
    step: float
    """Highest step, up or down, that it passes as it is."""
    flipper_step: float
    """Highest step up with flippers; `step` for a robot without."""
    up: float
    down: float
    side: float
    """Steepest slope ahead, upward and downward, and across."""
    min_turn_radius: float = 0.0
    """0 if it turns on the spot."""

    @property
    def circles(self) -> tuple[tuple[float, ...], float]:
        """Few circles that cover the footprint, and some decimetres before and behind it.

        Positions of their centres along x, and their radius.
        """
        length = self.front + self.back
        count = max(1, math.ceil(length / (0.5 * self.half_width)))
        part = length / count
        centres = tuple(-self.back + (number + 0.5) * part for number in range(count))
        return centres, math.hypot(self.half_width, part / 2.0)

    @property
    def tiles(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Many circles that cover the footprint, and a hundredth of its width beside it.

        Their centres, x and y, shape (n, 2), and their radii, shape (n,). Each surrounds a tile of the footprint: the
        tiles along its edge are the smallest ones.
        """
        low, high = np.array([-self.back, -self.half_width]), np.array([self.front, self.half_width])
        side = TILE * self.half_width
        centres, radii = [], []
        while (high > low).all():
            counts = np.maximum(1, np.ceil((high - low) / side - 1e-9)).astype(int)
            numbers = np.indices(counts).reshape(2, -1).T
            edge = ((numbers == 0) | (numbers == counts - 1)).any(axis=1)
            size = (high - low) / counts
            centres.append(low + (numbers[edge] + 0.5) * size)
            radii.append(np.full(np.count_nonzero(edge), 0.5 * float(np.hypot(*size))))
            low, high, side = low + size, high - size, 2.0 * side
        return np.concatenate(centres), np.concatenate(radii)


def mobility_of(robot: RobotModel) -> Mobility:
    """The mobility of a robot in the posture at its start (`with_posture`); raises `ConfigError` for a fixed base."""
    chassis = chassis_of(robot)
    posture = {
        joint: value for group in robot.groups.values() for joint, value in zip(group.joints, group.start, strict=True)
    }
    up, down, side = _slopes(robot, chassis, posture)
    step, flipper_step = _steps(robot, chassis, posture, _pitch_limit(robot, chassis, posture))
    return Mobility(
        chassis.front,
        chassis.back,
        max(chassis.left, chassis.right),
        step,
        flipper_step,
        up,
        down,
        side,
        chassis.min_turn_radius,
    )


def with_posture(robot: RobotModel, positions: Mapping[str, float]) -> RobotModel:
    """The robot with its joints at these positions, as far as they are given, in place of those at the start."""
    groups = {
        name: replace(
            group,
            start=tuple(positions.get(joint, start) for joint, start in zip(group.joints, group.start, strict=True)),
        )
        for name, group in robot.groups.items()
    }
    return replace(robot, groups=groups)


def flipper_joints(robot: RobotModel) -> tuple[str, ...]:
    """Names of the joints that turn flippers; none for a robot without."""
    if robot.tracks is None:
        return ()
    turning = [_carrier(robot, name) for name in (*robot.tracks.left[1:], *robot.tracks.right[1:])]
    return tuple(dict.fromkeys(joint.name for joint in turning if joint and joint.kind is JointKind.REVOLUTE))


def _tipping_limits(robot: RobotModel, posture: Mapping[str, float]) -> dict[str, float]:
    """The tilt, in radians, at which the margin of tipping over each edge is that at which the robot stops."""
    setup, model = robot.stability or StabilitySetup(), StabilityModel(robot)
    if not model.can_tip:
        return {}
    margins = model.margins(model.frames(posture), gravity_direction(Pose()))
    return {margin.edge: margin.angle - setup.stop for margin in margins}


def _pitch_limit(robot: RobotModel, chassis: Chassis, posture: Mapping[str, float]) -> float:
    """Greatest pitch, nose up, in radians, at which the robot neither tips nor is stopped by its guard."""
    guard = math.inf if chassis.tilt_guard is None else chassis.tilt_guard.pitch - TILT_RESERVE
    return max(0.0, min(guard, _tipping_limits(robot, posture).get("rear", math.pi / 3.0)))


def _slopes(robot: RobotModel, chassis: Chassis, posture: Mapping[str, float]) -> tuple[float, float, float]:
    """Steepest slopes upward, downward and across: by tipping, guard, friction and force."""
    tipping = _tipping_limits(robot, posture)
    guard = chassis.tilt_guard
    pitch = math.inf if guard is None else guard.pitch - TILT_RESERVE
    roll = math.inf if guard is None else guard.roll - TILT_RESERVE
    grip = math.atan(FRICTION)
    if robot.tracks is not None:
        force = sum(robot.description.joint(side[0]).effort for side in (robot.tracks.left, robot.tracks.right))
        grip = min(grip, math.asin(min(1.0, force / (chassis.mass * GRAVITY))))
    across = min(tipping.get("left", math.inf), tipping.get("right", math.inf))
    limits = (
        min(grip, pitch, tipping.get("rear", math.inf)),
        min(grip, pitch, tipping.get("front", math.inf)),
        min(grip, roll, across),
    )
    up, down, side = (max(0.0, limit) for limit in limits)
    return up, down, side


def _steps(robot: RobotModel, chassis: Chassis, posture: Mapping[str, float], pitch: float) -> tuple[float, float]:
    """Highest step without and with flippers, which may raise the robot to this pitch, in radians."""
    if robot.tracks is None:
        return WHEEL_SHARE * chassis.wheel_radius, WHEEL_SHARE * chassis.wheel_radius
    frames = FrameTree(robot.description).poses(posture)
    belt = robot.description.joint(robot.tracks.left[0]).child
    shapes = [
        (frames[belt].apply((shape.origin.x, shape.origin.y, shape.origin.z)), shape.size)
        for shape in collision_boxes(robot.description.urdf)
        if shape.link == belt
    ]
    if not shapes:
        return 0.0, 0.0
    nose = max(shapes, key=lambda shape: shape[0][0] + shape[1][0] / 2.0)
    ground = min(place[2] - size[2] / 2.0 for place, size in shapes)
    step = AXLE_SHARE * (nose[0][2] - ground)
    turning = [_carrier(robot, name) for name in robot.tracks.left[1:]]
    axles = [frames[joint.child].position[2] for joint in turning if joint and joint.kind is JointKind.REVOLUTE]
    if not axles:
        return step, step
    rear = -min(place[0] - size[0] / 2.0 for place, size in shapes if place[2] - size[2] / 2.0 <= ground + LEVEL)
    # where the centre of mass passes the edge
    lifted = (rear + chassis.centre_of_gravity[0]) * math.sin(min(pitch, CLIMBING_PITCH))
    length, thickness = _flipper_size(robot)
    tip = max(axles) - ground + length * math.sin(FLIPPER_ANGLE) + TIP_SHARE * thickness
    return step, max(step, min(lifted, tip))


def _carrier(robot: RobotModel, belt: str) -> Joint | None:
    """The joint that turns the flipper on which a belt runs; None if nothing does."""
    parent = robot.description.joint(belt).parent
    return next((joint for joint in robot.description.joints.values() if joint.child == parent), None)


def _flipper_size(robot: RobotModel) -> tuple[float, float]:
    """Length from the axle and thickness of the flippers, metres."""
    assert robot.tracks is not None
    links = {robot.description.joint(name).child for name in robot.tracks.left[1:]}
    shapes = [shape for shape in collision_boxes(robot.description.urdf) if shape.link in links]
    length = max((abs(shape.origin.x) + shape.size[0] / 2.0 for shape in shapes), default=0.0)
    return length, max((shape.size[2] for shape in shapes), default=0.0)
