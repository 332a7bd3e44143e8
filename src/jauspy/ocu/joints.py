"""Names, order, signs and limits of a component's joints, converted between AS6057 and the robot's description (URDF).

Plain numbers, as in `joint_positions(0.0, 0.6, metres(0.03))`, have the order and signs of the component (AS6057);
`Robot.arm.joint_positions(elbow=0.6)` takes names and positions of the description.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number, described
from jauspy.errors import ConfigError
from jauspy.geometry.vectors import Rotation, X, Y, Z, rotation_from_quaternion
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.messages.manipulator import (
    JointEffortRec,
    JointPositionRec,
    JointVelocityRec,
    QueryJointPositions,
    QueryManipulatorSpecifications,
    QueryPanTiltJointPositions,
    ReportJointPositions,
    ReportManipulatorSpecifications,
    ReportPanTiltJointPositions,
    SetJointEffort,
    SetJointPositions,
    SetJointVelocity,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.subsystems import ComponentInfo

DESCRIPTION: Final = "JointDescription"
SPECIFICATION: Final = "ManipulatorSpecificationService"
POSITION_SENSOR: Final = "ManipulatorJointPositionSensor"
PAN_TILT_SENSOR: Final = "PanTiltJointPositionSensor"
NAMES: Final = 0b10
"""Presence vector of a specification with the names of the joints."""
POSITION_TOLERANCE: Final = 1e-6
"""Radians or metres by which a position may lie beyond a limit."""


@dataclass(frozen=True, slots=True)
class DescribedJoint:
    """One joint. The component reports `sign * position + zero` for a position of the description."""

    name: str
    is_revolute: bool = True
    sign: float = 1.0
    zero: float = 0.0
    lower: float = -math.inf
    upper: float = math.inf
    max_effort: float | None = None
    """Newtons or newton metres; None when it is not known."""
    max_speed: float | None = None
    """rad/s or m/s; None when it is not known."""
    width_rate: float = 0.0
    """Of a finger: metres by which one metre of it widens the gripper."""

    @property
    def unit(self) -> str:
        """The unit of its positions."""
        return "rad" if self.is_revolute else "m"


@dataclass(frozen=True, slots=True)
class JointTable:
    """The joints that a component moves, base to tip.

    A component without the service JointDescription (which is of jauspy) has the names of its specification, or joint1,
    joint2 and so on, and its positions are as it reports them.
    """

    joints: tuple[DescribedJoint, ...]
    group: str = ""
    """The name of the group in the description, as in arm or gripper."""
    tool: Rotation = (X, Y, Z)
    """Turns directions of the tool link into those of the last joint's frame."""
    width_at_zero: float = 0.0
    """Metres between the fingers of a gripper with all joints at zero."""

    @property
    def has_width(self) -> bool:
        """True for a gripper that describes how wide its fingers are open."""
        return any(joint.width_rate for joint in self.joints)

    def width(self, positions: Mapping[str, float]) -> float:
        """Metres between the fingers, with the joints at these positions."""
        return self.width_at_zero + sum(joint.width_rate * positions[joint.name] for joint in self.joints)

    def from_reported(self, values: Sequence[float]) -> dict[str, float]:
        """Positions by name."""
        rows = zip(self.joints, values, strict=True)
        return {joint.name: joint.sign * (value - joint.zero) for joint, value in rows}

    def to_reported(self, positions: Mapping[str, float]) -> list[float]:
        """The positions of all joints as in commands (AS6057)."""
        return [joint.sign * positions[joint.name] + joint.zero for joint in self.joints]

    def check(self, positions: object) -> dict[str, float]:
        """The positions; raises `ConfigError` for unknown joints and for positions beyond a limit."""
        if not isinstance(positions, Mapping) or not positions:
            raise TypeError(
                f"joints are given by name, as in {{{self.joints[0].name!r}: 0.6}}, not {described(positions)}"
            )
        known = {joint.name: joint for joint in self.joints}
        for name, value in positions.items():
            if name not in known:
                raise ConfigError(f"there is no joint {name!r}; there are {', '.join(known)}")
            joint = known[name]
            check_number(value, f"the position of {name}")
            if not joint.lower - POSITION_TOLERANCE <= value <= joint.upper + POSITION_TOLERANCE:
                raise ConfigError(f"{name} can be {joint.lower:.4g}..{joint.upper:.4g} {joint.unit}, and not {value:g}")
        return {name: float(value) for name, value in positions.items()}


async def joint_table(connection: Connection, component: ComponentInfo) -> JointTable:
    """The names, signs and limits of this component's joints; raises `ResponseTimeout` when it does not answer."""
    if component.find(DESCRIPTION):
        report = await connection.query(component.id, QueryJointDescription(), expects=ReportJointDescription)
        assert isinstance(report, ReportJointDescription)
        return table_of(report)
    if component.find(SPECIFICATION):
        query = QueryManipulatorSpecifications(NAMES)
        specified = await connection.query(component.id, query, expects=ReportManipulatorSpecifications)
        assert isinstance(specified, ReportManipulatorSpecifications)
        return _specified(specified)
    names = (f"joint{number}" for number, _ in enumerate(await reported(connection, component), 1))
    return JointTable(tuple(map(DescribedJoint, names)))


async def reported(connection: Connection, component: ComponentInfo) -> list[float]:
    """The present positions, base to tip, with the signs of the component (AS6057)."""
    if component.find(POSITION_SENSOR):
        report = await connection.query(component.id, QueryJointPositions(), expects=ReportJointPositions)
        assert isinstance(report, ReportJointPositions)
        return [float(each.joint_position.value) for each in report.joint_position_list]
    angles = await connection.query(component.id, QueryPanTiltJointPositions(), expects=ReportPanTiltJointPositions)
    assert isinstance(angles, ReportPanTiltJointPositions)
    return [angles.joint1_position, angles.joint2_position]


def position_records(table: JointTable, values: Sequence[float]) -> list[JointPositionRec]:
    """The records of a command, base to tip."""
    make, kinds = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    return [
        JointPositionRec(make(kinds(1 if joint.is_revolute else 2), value))
        for joint, value in zip(table.joints, values, strict=True)
    ]


def table_of(report: ReportJointDescription) -> JointTable:
    """The joints that a component describes."""
    group = report.group_rec
    types = ReportJointDescription.JointType
    joints = tuple(
        DescribedJoint(
            each.joint_name,
            is_revolute=each.joint_type != types.PRISMATIC,
            sign=-1.0 if each.direction == ReportJointDescription.Direction.REVERSED else 1.0,
            zero=each.zero_position,
            lower=-math.inf if each.joint_type == types.CONTINUOUS else each.lower_limit,
            upper=math.inf if each.joint_type == types.CONTINUOUS else each.upper_limit,
            max_effort=each.max_effort,
            max_speed=each.max_speed,
            width_rate=each.width_rate,
        )
        for each in report.joint_list
    )
    parts = (group.tool_d, group.tool_a, group.tool_b, group.tool_c)
    has_tool = math.isclose(math.hypot(*parts), 1.0, abs_tol=0.01)
    tool = rotation_from_quaternion(*parts) if has_tool else (X, Y, Z)
    return JointTable(joints, group.group_name, tool, group.width_at_zero)


def _specified(report: ReportManipulatorSpecifications) -> JointTable:
    names = [each.description for each in report.joint_names_list or ()]
    first = report.first_joint_parameters
    limits: list[tuple[bool, float | None, float | None, float | None]]
    limits = [
        (hasattr(first, "joint1_max_torque"), first.joint1_min_value, first.joint1_max_value, first.joint1_max_speed)
    ]
    limits += [
        (hasattr(each, "max_torque"), each.min_value, each.max_value, each.max_speed)
        for each in report.joint_specification_list
    ]
    names += [f"joint{number}" for number in range(len(names) + 1, len(limits) + 1)]
    rows = zip(names, limits, strict=False)
    return JointTable(
        tuple(
            DescribedJoint(
                name,
                turns,
                lower=-math.inf if low is None else low,
                upper=math.inf if high is None else high,
                max_speed=speed,
            )
            for name, (turns, low, high, speed) in rows
        )
    )


class metres(float):  # noqa: N801 - it is used as a function
    """A number of metres, or m/s, for a joint that slides; plain numbers are radians, or rad/s."""

    __slots__ = ()


def joint_positions(*positions: float) -> SetJointPositions:
    """One position for each joint, base to tip: radians, or `metres(...)`."""
    make, kinds = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    return SetJointPositions([JointPositionRec(make(kinds(_kind(each)), float(each))) for each in _checked(positions)])


def joint_velocities(*velocities: float) -> SetJointVelocity:
    """One velocity for each joint, base to tip: rad/s, or `metres(...)` per second."""
    make, kinds = JointVelocityRec.JointVelocity, JointVelocityRec.JointVelocityChoice
    return SetJointVelocity([JointVelocityRec(make(kinds(_kind(each)), float(each))) for each in _checked(velocities)])


def joint_efforts(*percent: float) -> SetJointEffort:
    """One effort for each joint, base to tip, in percent."""
    return SetJointEffort([JointEffortRec(float(each)) for each in _checked(percent)])


def _checked(values: tuple[float, ...]) -> tuple[float, ...]:
    for number, each in enumerate(values, 1):
        check_number(each, f"joint {number}")
    return values


def _kind(value: float) -> int:
    return 2 if isinstance(value, metres) else 1


DURATION_ROUNDING: Final = 1e-6
"""Seconds by which a duration may be shorter than possible (rounding)."""


@dataclass(frozen=True, slots=True)
class MotionLimits:
    """Limits of a joint's motion: rad/s and rad/s^2, or m/s and m/s^2; infinite where there is none.

    The speed profile is a trapezoid.
    """

    speed: float = math.inf
    acceleration: float = math.inf
    deceleration: float = math.inf

    @property
    def _ramps(self) -> float:
        """Seconds that both ramps take for a unit of speed, halved: what they add to the time at that speed."""
        return (1.0 / self.acceleration + 1.0 / self.deceleration) / 2.0

    def least_duration(self, way: float) -> float:
        """The least time in seconds for a motion of this many radians or metres."""
        way, ramps = abs(way), self._ramps
        if not way:
            return 0.0
        if not ramps:
            return way / self.speed
        top = min(self.speed, math.sqrt(way / ramps))
        return way / top + ramps * top

    def speed_for(self, way: float, duration: float) -> float | None:
        """The speed with which the motion takes `duration` seconds; None if the joint is not as fast."""
        way, ramps = abs(way), self._ramps
        if duration < self.least_duration(way) - DURATION_ROUNDING or not duration:
            return None
        if not ramps:
            return way / duration
        speed = (duration - math.sqrt(max(0.0, duration * duration - 4.0 * ramps * way))) / (2.0 * ramps)
        return min(speed, self.speed)
