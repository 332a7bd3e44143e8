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
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.geometry.vectors import Rotation, X, Y, Z, rotation_from_quaternion
from jauspy.joint_values import position_records, velocity_records
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.messages.manipulator import (
    JointEffortRec,
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
FORCE_SENSOR: Final = "ManipulatorJointForceTorqueSensor"
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
    """Metres by which one metre of a finger widens the gripper."""

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


def positions_query(component: ComponentInfo) -> QueryJointPositions | QueryPanTiltJointPositions:
    """The query for the positions of this component's joints."""
    return QueryJointPositions() if component.find(POSITION_SENSOR) else QueryPanTiltJointPositions()


def positions_in(report: Message) -> list[float]:
    """The positions in an answer to `positions_query`, base to tip, with the signs of the component (AS6057)."""
    if isinstance(report, ReportJointPositions):
        return [float(joint.joint_position.value) for joint in report.joint_position_list]
    assert isinstance(report, ReportPanTiltJointPositions)
    return [report.joint1_position, report.joint2_position]


async def reported(connection: Connection, component: ComponentInfo) -> list[float]:
    """The present positions, base to tip, with the signs of the component (AS6057)."""
    query = positions_query(component)
    return positions_in(await connection.query(component.id, query, expects=query.REPORT))


def table_of(report: ReportJointDescription) -> JointTable:
    """The joints that a component describes."""
    group = report.group_rec
    types = ReportJointDescription.JointType
    joints = tuple(
        DescribedJoint(
            joint.joint_name,
            is_revolute=joint.joint_type != types.PRISMATIC,
            sign=-1.0 if joint.direction == ReportJointDescription.Direction.REVERSED else 1.0,
            zero=joint.zero_position,
            lower=-math.inf if joint.joint_type == types.CONTINUOUS else joint.lower_limit,
            upper=math.inf if joint.joint_type == types.CONTINUOUS else joint.upper_limit,
            max_effort=joint.max_effort,
            max_speed=joint.max_speed,
            width_rate=joint.width_rate,
        )
        for joint in report.joint_list
    )
    parts = (group.tool_d, group.tool_a, group.tool_b, group.tool_c)
    has_tool = math.isclose(math.hypot(*parts), 1.0, abs_tol=0.01)
    tool = rotation_from_quaternion(*parts) if has_tool else (X, Y, Z)
    return JointTable(joints, group.group_name, tool, group.width_at_zero)


def _specified(report: ReportManipulatorSpecifications) -> JointTable:
    names = [record.description for record in report.joint_names_list or ()]
    first = report.first_joint_parameters
    limits: list[tuple[bool, float | None, float | None, float | None]]
    limits = [
        (hasattr(first, "joint1_max_torque"), first.joint1_min_value, first.joint1_max_value, first.joint1_max_speed)
    ]
    limits += [
        (hasattr(joint, "max_torque"), joint.min_value, joint.max_value, joint.max_speed)
        for joint in report.joint_specification_list
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
    return SetJointPositions(position_records(map(float, _checked(positions)), _typed(positions)))


def joint_velocities(*velocities: float) -> SetJointVelocity:
    """One velocity for each joint, base to tip: rad/s, or `metres(...)` per second."""
    return SetJointVelocity(velocity_records(map(float, _checked(velocities)), _typed(velocities)))


def joint_efforts(*percent: float) -> SetJointEffort:
    """One effort for each joint, base to tip, in percent."""
    return SetJointEffort([JointEffortRec(float(effort)) for effort in _checked(percent)])


def _checked(values: tuple[float, ...]) -> tuple[float, ...]:
    for number, value in enumerate(values, 1):
        check_number(value, f"joint {number}")
    return values


def _typed(values: tuple[float, ...]) -> list[DescribedJoint]:
    return [DescribedJoint("", not isinstance(entry, metres)) for entry in values]
