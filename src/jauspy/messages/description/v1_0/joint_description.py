"""urn:jauspy:description:JointDescription 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:description:JointDescription", "1.0")


@jd.message(_SERVICE, 0xFA80)
class ReportJointDescription(jd.Message):
    """ReportJointDescription (0xFA80): The group of joints that the component moves, base to tip.

    joint_list: 0..255 items. The joints that move, base to tip
    """

    @jd.record()
    class GroupRec(jd.Struct):
        """group_name: up to 255 characters. Name of the group in the description, as in arm or gripper
        tool_d: Real part of the quaternion that turns axes of the tool link into the last joint's
        tool_a: Its part along x
        tool_b: Its part along y
        tool_c: Its part along z
        width_at_zero: Metres between the fingers of a gripper with all joints at zero in the description
        """
        group_name: str = jd.field("GroupName", jd.Text(count=jd.Count("B", 0, 255)))
        tool_d: float = jd.field("ToolD", jd.Number("d"))
        tool_a: float = jd.field("ToolA", jd.Number("d"))
        tool_b: float = jd.field("ToolB", jd.Number("d"))
        tool_c: float = jd.field("ToolC", jd.Number("d"))
        width_at_zero: float = jd.field("WidthAtZero", jd.Number("d"))

    class JointType(IntEnum):
        REVOLUTE = 1
        PRISMATIC = 2
        CONTINUOUS = 3

    class Direction(IntEnum):
        SAME = 0
        REVERSED = 1

    @jd.record()
    class JointRec(jd.Struct):
        """joint_name: up to 255 characters. Name of the joint in the description
        joint_type: JointType. An angle in radians with or without limits, or a distance in metres
        direction: Direction. Whether services count along the axis of the description
        zero_position: What services report where the description has zero: radians or metres
        lower_limit: Least position in the description: radians or metres
        upper_limit: Greatest position in the description: radians or metres
        max_speed: Greatest speed: radians per second or metres per second
        max_effort: Greatest effort: newton metres or newtons
        width_rate: Metres by which a metre of this joint widens the fingers; zero if it has none
        """
        joint_name: str = jd.field("JointName", jd.Text(count=jd.Count("B", 0, 255)))
        joint_type: ReportJointDescription.JointType | int = jd.field("JointType", lambda: jd.Number("B", jd.Values(ReportJointDescription.JointType)))
        direction: ReportJointDescription.Direction | int = jd.field("Direction", lambda: jd.Number("B", jd.Values(ReportJointDescription.Direction)))
        zero_position: float = jd.field("ZeroPosition", jd.Number("d"))
        lower_limit: float = jd.field("LowerLimit", jd.Number("d"))
        upper_limit: float = jd.field("UpperLimit", jd.Number("d"))
        max_speed: float = jd.field("MaxSpeed", jd.Number("d"))
        max_effort: float = jd.field("MaxEffort", jd.Number("d"))
        width_rate: float = jd.field("WidthRate", jd.Number("d"))

    group_rec: ReportJointDescription.GroupRec = jd.field("GroupRec", lambda: ReportJointDescription.GroupRec.layout())
    joint_list: list[ReportJointDescription.JointRec] = jd.field("JointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportJointDescription.JointRec.layout()))


@jd.message(_SERVICE, 0xEA80, query=True)
class QueryJointDescription(jd.Message):
    """QueryJointDescription (0xEA80): Asks for the names, limits and zero positions of the joints."""
    REPORT = ReportJointDescription


@jd.message(_SERVICE, 0xFA81)
class ReportBlockedJoints(jd.Message):
    """ReportBlockedJoints (0xFA81): The joints that stood still short of their positions, until the next command.

    blocked_joint_list: 0..255 items. None if nothing was in the way
    """

    @jd.record()
    class BlockedJointRec(jd.Struct):
        """joint_name: up to 255 characters. Name of the joint in the description
        effort: With which it pushed: newton metres or newtons
        short: How far it was from its position: radians or metres, as in the description
        """
        joint_name: str = jd.field("JointName", jd.Text(count=jd.Count("B", 0, 255)))
        effort: float = jd.field("Effort", jd.Number("d"))
        short: float = jd.field("Short", jd.Number("d"))

    blocked_joint_list: list[ReportBlockedJoints.BlockedJointRec] = jd.field("BlockedJointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportBlockedJoints.BlockedJointRec.layout()))


@jd.message(_SERVICE, 0xEA81, query=True)
class QueryBlockedJoints(jd.Message):
    """QueryBlockedJoints (0xEA81): Asks which joints something has kept from their positions."""
    REPORT = ReportBlockedJoints
