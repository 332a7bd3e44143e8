"""Tells before an arm moves whether its tool can reach a pose, and if not, why: from the geometry that it reports."""

from __future__ import annotations

import asyncio
import math
from typing import Any, Final

from jauspy.geometry.denavit_hartenberg import DHLink
from jauspy.geometry.kinematics import InverseKinematics, Solution, forward_kinematics
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.geometry.vectors import Vector
from jauspy.messages.manipulator import (
    QueryManipulatorSpecifications,
    QueryToolOffset,
    ReportManipulatorSpecifications,
    ReportToolOffset,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.joints import SPECIFICATION, JointTable
from jauspy.ocu.subsystems import ComponentInfo

TOOL_OFFSET: Final = "ManipulatorToolOffsetService"
DISTANCE_TOLERANCE: Final = 0.005
"""Metres up to which the arm is asked nevertheless; it reports its geometry to 0.3 mm a link."""
AGREEMENT: Final = 0.02
"""Metres up to which the reported geometry agrees with the reported pose of the tool."""
ANGLE_TOLERANCE: Final = math.radians(2.0)
LIMIT_TOLERANCE: Final = 1e-3
"""Radians or metres from a limit within which a joint is at it."""
GEOMETRY_ONLY: Final = 0
"""Presence vector of a query for the specification without base and names."""
STEPS_PER_TURN: Final = 10
"""Steps of inverse kinematics between two turns of the event loop, about one millisecond."""


class Reach:
    """The kinematics of an arm, from its specification and tool offset (AS6057)."""

    def __init__(self, table: JointTable, report: ReportManipulatorSpecifications, tool: Vector) -> None:
        first, others = report.first_joint_parameters, report.joint_specification_list
        names = [joint.name for joint in table.joints]
        speeds = [joint.max_speed or 1.0 for joint in table.joints]
        self._table, self._tool = table, tool
        self._links = [_first_link(names[0], speeds[0], first)]
        self._links += [_link(*row) for row in zip(names[1:], speeds[1:], others, strict=True)]
        self._limits = [(link.joint.lower, link.joint.upper) for link in self._links]

    async def obstacle(self, goal: Transform, start: list[float], tool: Vector, *, exactly: bool) -> str:
        """Why the tool cannot get to `goal`; empty if it can, or if that cannot be told.

        In the manipulator's coordinate system; `start` are the present positions as the arm reports them, `tool` its
        tool point. Without `exactly`, any attitude will do.
        """
        if math.dist(forward_kinematics(self._links, start, self._tool).tool.position, tool) > AGREEMENT:
            return ""  # the arm moves, or it counts its joints otherwise than AS6057
        found = await self._search(goal, start, exactly=exactly)
        if found.distance > DISTANCE_TOLERANCE:
            way = f"{found.distance:.2f} m{self._at_limit(found)}"
            return f"the point is out of reach: the tool gets no nearer than {way}"
        if exactly and found.angle > ANGLE_TOLERANCE:
            turn = f"{math.degrees(found.angle):.0f}° from `rpy`{self._at_limit(found)}"
            return (
                f"the arm reaches the point only with another attitude, {turn}; leave out `rpy`, then the point counts"
            )
        return ""

    async def _search(self, goal: Transform, start: list[float], *, exactly: bool) -> Solution:
        """The best solution, or the first one that gets there; which one the arm takes is its own matter."""
        search = InverseKinematics(self._links, self._tool, goal, start, self._limits)
        while (found := search.advance(STEPS_PER_TURN)) is None:
            best = search.best
            if best.reaches_pose or (best.reaches_point and not exactly):
                return best
            await asyncio.sleep(0)
        return found

    def _at_limit(self, found: Solution) -> str:
        """The joints whose limits keep the tool away, with their limits as of the robot's description."""
        values = self._table.from_reported(found.positions)
        parts = []
        for joint in self._table.joints:
            value = values[joint.name]
            limit = next((end for end in (joint.lower, joint.upper) if abs(value - end) <= LIMIT_TOLERANCE), None)
            if limit is not None:
                parts.append(f"{joint.name} at its limit of {limit:.4g} {joint.unit}")
        return f", with {', '.join(parts)}" if parts else ""


async def reach_of(connection: Connection, component: ComponentInfo, table: JointTable) -> Reach | None:
    """The kinematics of this arm; None if it does not report its geometry; raises `ResponseTimeout`."""
    if not (component.find(SPECIFICATION) and component.find(TOOL_OFFSET)):
        return None
    query = QueryManipulatorSpecifications(GEOMETRY_ONLY)
    report = await connection.query(component.id, query, expects=ReportManipulatorSpecifications)
    offset = await connection.query(component.id, QueryToolOffset(), expects=ReportToolOffset)
    assert isinstance(report, ReportManipulatorSpecifications)
    assert isinstance(offset, ReportToolOffset)
    if len(report.joint_specification_list) + 1 != len(table.joints):
        return None
    tool = (offset.tool_point_coordinate_x, offset.tool_point_coordinate_y, offset.tool_point_coordinate_z)
    return Reach(table, report, tool)


def _first_link(name: str, speed: float, record: Any) -> DHLink:
    turns = isinstance(record, ReportManipulatorSpecifications.RevoluteJoint1OffsetRec)
    joint = _joint(name, speed, turns, record.joint1_min_value, record.joint1_max_value)
    return DHLink(joint, 0.0, 0.0, *((record.joint1_offset, 0.0) if turns else (0.0, record.joint1_angle)))


def _link(name: str, speed: float, record: Any) -> DHLink:
    turns = isinstance(record, ReportManipulatorSpecifications.RevoluteJointSpecificationRec)
    joint = _joint(name, speed, turns, record.min_value, record.max_value)
    fixed = (record.joint_offset, 0.0) if turns else (0.0, record.joint_angle)
    return DHLink(joint, record.link_length, record.twist_angle, *fixed)


def _joint(name: str, speed: float, turns: bool, lower: float | None, upper: float | None) -> Joint:
    kind = JointKind.REVOLUTE if turns else JointKind.PRISMATIC
    low, high = -math.inf if lower is None else lower, math.inf if upper is None else upper
    return Joint(name, kind, "", "", lower=low, upper=high, velocity=speed)
