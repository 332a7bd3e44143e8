"""urn:jauspy:planning:MotionPlanner 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:planning:MotionPlanner", "1.0")


@jd.message(_SERVICE, 0xDA40, command=True)
class PlanMotion(jd.Message):
    """PlanMotion (0xDA40): Plans a motion from where the joints are; an earlier plan is forgotten, and nothing moves.

    motion_goal: Where the motion is to end
    """

    @jd.record()
    class PlanRec(jd.Struct):
        """plan_number: The client's own number of a plan
        time_limit: in second. Seconds after which the search is given up; 0 for the planner's own limit
        """
        plan_number: int = jd.field("PlanNumber", jd.Number("I"))
        time_limit: float = jd.field("TimeLimit", jd.Number("f", jd.ANY, "second"))

    @jd.record()
    class JointGoalRec(jd.Struct):
        """joint_name: up to 255 characters. Name of the joint in the description
        position: Position in radians, or in metres for a joint that slides
        """
        joint_name: str = jd.field("JointName", jd.Text(count=jd.Count("B", 0, 255)))
        position: float = jd.field("Position", jd.Number("d"))

    @jd.record()
    class JointGoalList(jd.Struct):
        """Positions of joints; those that are left out stay where they are.

        joint_goal_list: 0..255 items. Positions of joints; those that are left out stay where they are
        """
        joint_goal_list: list[PlanMotion.JointGoalRec] = jd.field("JointGoalList", lambda: jd.Repeat(jd.Count("B", 0, 255), PlanMotion.JointGoalRec.layout()))

    @jd.record()
    class PoseGoalRec(jd.Struct):
        """The tool is to have this pose.

        frame: up to 255 characters. A link of the robot's description, where it is when planning begins; empty for the base
        x: in meter. X of the tool, in metres
        y: in meter. Y of the tool, in metres
        z: in meter. Z of the tool, in metres
        roll: in radian. Roll of the tool, in radians
        pitch: in radian. Pitch of the tool, in radians
        yaw: in radian. Yaw of the tool, in radians
        """
        frame: str = jd.field("Frame", jd.Text(count=jd.Count("B", 0, 255)))
        x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
        y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
        z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
        roll: float = jd.field("Roll", jd.Number("d", jd.ANY, "radian"))
        pitch: float = jd.field("Pitch", jd.Number("d", jd.ANY, "radian"))
        yaw: float = jd.field("Yaw", jd.Number("d", jd.ANY, "radian"))

    @jd.record()
    class PointGoalRec(jd.Struct):
        """The tool is to be at this point, in any attitude.

        frame: up to 255 characters. A link of the robot's description, where it is when planning begins; empty for the base
        x: in meter. X of the tool, in metres
        y: in meter. Y of the tool, in metres
        z: in meter. Z of the tool, in metres
        roll: in radian. Roll of the tool, in radians
        pitch: in radian. Pitch of the tool, in radians
        yaw: in radian. Yaw of the tool, in radians
        """
        frame: str = jd.field("Frame", jd.Text(count=jd.Count("B", 0, 255)))
        x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
        y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
        z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
        roll: float = jd.field("Roll", jd.Number("d", jd.ANY, "radian"))
        pitch: float = jd.field("Pitch", jd.Number("d", jd.ANY, "radian"))
        yaw: float = jd.field("Yaw", jd.Number("d", jd.ANY, "radian"))

    @jd.record()
    class GoalPoseRec(jd.Struct):
        """A pose of the tool in a frame; roll, pitch and yaw are about fixed axes.

        frame: up to 255 characters. A link of the robot's description, where it is when planning begins; empty for the base
        x: in meter. X of the tool, in metres
        y: in meter. Y of the tool, in metres
        z: in meter. Z of the tool, in metres
        roll: in radian. Roll of the tool, in radians
        pitch: in radian. Pitch of the tool, in radians
        yaw: in radian. Yaw of the tool, in radians
        """
        frame: str = jd.field("Frame", jd.Text(count=jd.Count("B", 0, 255)))
        x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
        y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
        z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
        roll: float = jd.field("Roll", jd.Number("d", jd.ANY, "radian"))
        pitch: float = jd.field("Pitch", jd.Number("d", jd.ANY, "radian"))
        yaw: float = jd.field("Yaw", jd.Number("d", jd.ANY, "radian"))

    @jd.record()
    class GoalRegionRec(jd.Struct):
        """size_x: in meter. Side along x of a box around the point, with the axes of the pose, in which the tool is to be
        size_y: in meter. The same along y, in metres
        size_z: in meter. The same along z, in metres
        angle: in radian. Greatest angle between the attitude of the tool and that of the pose
        """
        size_x: float = jd.field("SizeX", jd.Number("d", jd.ANY, "meter"))
        size_y: float = jd.field("SizeY", jd.Number("d", jd.ANY, "meter"))
        size_z: float = jd.field("SizeZ", jd.Number("d", jd.ANY, "meter"))
        angle: float = jd.field("Angle", jd.Number("d", jd.ANY, "radian"))

    @jd.record()
    class RegionGoalSeq(jd.Struct):
        """goal_pose_rec: A pose of the tool in a frame; roll, pitch and yaw are about fixed axes"""
        goal_pose_rec: PlanMotion.GoalPoseRec = jd.field("GoalPoseRec", lambda: PlanMotion.GoalPoseRec.layout())
        goal_region_rec: PlanMotion.GoalRegionRec = jd.field("GoalRegionRec", lambda: PlanMotion.GoalRegionRec.layout())

    plan_rec: PlanMotion.PlanRec = jd.field("PlanRec", lambda: PlanMotion.PlanRec.layout())
    motion_goal: PlanMotion.JointGoalList | PlanMotion.PoseGoalRec | PlanMotion.PointGoalRec | PlanMotion.RegionGoalSeq = jd.field("MotionGoal", lambda: jd.Union.of("B", joint_goal_list=PlanMotion.JointGoalList, pose_goal_rec=PlanMotion.PoseGoalRec, point_goal_rec=PlanMotion.PointGoalRec, region_goal_seq=PlanMotion.RegionGoalSeq))


@jd.message(_SERVICE, 0xDA41, command=True)
class ExecuteMotion(jd.Message):
    """ExecuteMotion (0xDA41): Carries out the plan of this number.

    plan_number: The client's own number of a plan
    max_replans: How often it may stop and plan again, after a deviation or for a new obstacle
    """
    plan_number: int = jd.field("PlanNumber", jd.Number("I"))
    max_replans: int = jd.field("MaxReplans", jd.Number("B"))


@jd.message(_SERVICE, 0xDA42, command=True)
class CancelMotion(jd.Message):
    """CancelMotion (0xDA42): Ends planning, or stops the arm, and forgets the plan."""


@jd.message(_SERVICE, 0xFA40)
class ReportMotionPlan(jd.Message):
    """ReportMotionPlan (0xFA40): The plan; without points if there is none.

    planned_joint_list: 0..255 items. The joints, base to tip
    planned_point_list: 0..4096 items. Positions with times, linear between them; none without a plan
    """

    @jd.record("B", kw_only=True)
    class MotionPlanRec(jd.Struct):
        """plan_number: The client's own number of a plan
        clearance: in meter, optional. Least distance to obstacles, and of the robot to itself, on the way; left out if it is not known
        planning_time: in second. How long the planning took
        """
        plan_number: int = jd.field("PlanNumber", jd.Number("I"))
        clearance: float | None = jd.field("Clearance", jd.Number("f", jd.ANY, "meter"), default=None)
        planning_time: float = jd.field("PlanningTime", jd.Number("f", jd.ANY, "second"))
        reserved_presence: int = 0

    @jd.record()
    class PlannedJointRec(jd.Struct):
        """joint_name: up to 255 characters. Name of the joint in the description"""
        joint_name: str = jd.field("JointName", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class PlannedTimeRec(jd.Struct):
        """time: in second. Seconds from the start of the motion"""
        time: float = jd.field("Time", jd.Number("d", jd.ANY, "second"))

    @jd.record()
    class PlannedPositionRec(jd.Struct):
        """position: Position in radians, or in metres for a joint that slides"""
        position: float = jd.field("Position", jd.Number("d"))

    @jd.record()
    class PlannedPointSeq(jd.Struct):
        """planned_position_list: 0..255 items. One for each joint"""
        planned_time_rec: ReportMotionPlan.PlannedTimeRec = jd.field("PlannedTimeRec", lambda: ReportMotionPlan.PlannedTimeRec.layout())
        planned_position_list: list[ReportMotionPlan.PlannedPositionRec] = jd.field("PlannedPositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMotionPlan.PlannedPositionRec.layout()))

    motion_plan_rec: ReportMotionPlan.MotionPlanRec = jd.field("MotionPlanRec", lambda: ReportMotionPlan.MotionPlanRec.layout())
    planned_joint_list: list[ReportMotionPlan.PlannedJointRec] = jd.field("PlannedJointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMotionPlan.PlannedJointRec.layout()))
    planned_point_list: list[ReportMotionPlan.PlannedPointSeq] = jd.field("PlannedPointList", lambda: jd.Repeat(jd.Count("H", 0, 4096), ReportMotionPlan.PlannedPointSeq.layout()))


@jd.message(_SERVICE, 0xEA40, query=True)
class QueryMotionPlan(jd.Message):
    """QueryMotionPlan (0xEA40): Asks for the planned positions and their times."""
    REPORT = ReportMotionPlan


@jd.message(_SERVICE, 0xFA41)
class ReportMotionPlannerState(jd.Message):
    """ReportMotionPlannerState (0xFA41): What the planner does.

    plan_number: The client's own number of a plan
    phase: Phase. What the planner does, or how the last motion ended
    reason: Reason. Why it failed, or why it plans again
    reason_text: up to 255 characters. The same in words, with the obstacle or the joint; empty without a reason
    progress: in percent. How much of the way of the motion is done
    replans: How often it has planned again during this motion
    """

    class Phase(IntEnum):
        IDLE = 0
        PLANNING = 1
        PLANNED = 2
        EXECUTING = 3
        REACHED = 4
        FAILED = 5

    class Reason(IntEnum):
        NO_REASON = 0
        OUT_OF_REACH = 1
        GOAL_COLLIDES = 2
        START_COLLIDES = 3
        OUTSIDE_LIMITS = 4
        NO_WAY = 5
        WRONG_REQUEST = 6
        NO_SUCH_PLAN = 7
        DEVIATED = 8
        NEW_OBSTACLE = 9
        ARM_REFUSED = 10
        ARM_STOPPED = 11
        CANCELLED = 12
        NO_SIGHT = 13
        PLANNER_FAILED = 14

    plan_number: int = jd.field("PlanNumber", jd.Number("I"))
    phase: ReportMotionPlannerState.Phase | int = jd.field("Phase", lambda: jd.Number("B", jd.Values(ReportMotionPlannerState.Phase)))
    reason: ReportMotionPlannerState.Reason | int = jd.field("Reason", lambda: jd.Number("B", jd.Values(ReportMotionPlannerState.Reason)))
    reason_text: str = jd.field("ReasonText", jd.Text(count=jd.Count("B", 0, 255)))
    progress: int = jd.field("Progress", jd.Number("B", jd.ANY, "percent"))
    replans: int = jd.field("Replans", jd.Number("B"))


@jd.message(_SERVICE, 0xEA41, query=True)
class QueryMotionPlannerState(jd.Message):
    """QueryMotionPlannerState (0xEA41): Asks for what the planner does; for events, too."""
    REPORT = ReportMotionPlannerState


@jd.message(_SERVICE, 0xFA42)
class ReportMotionPlannerSpecification(jd.Message):
    """ReportMotionPlannerSpecification (0xFA42): The arm for which it plans.

    planned_joint_list: 0..255 items. The joints, base to tip
    """

    @jd.record()
    class PlannedArmRec(jd.Struct):
        """subsystem_id: Subsystem of the arm's component
        node_id: Its node
        component_id: Its component
        base_frame: up to 255 characters. The frame of poses for which no frame is named
        tool_frame: up to 255 characters. The link whose pose is planned
        """
        subsystem_id: int = jd.field("SubsystemID", jd.Number("H"))
        node_id: int = jd.field("NodeID", jd.Number("B"))
        component_id: int = jd.field("ComponentID", jd.Number("B"))
        base_frame: str = jd.field("BaseFrame", jd.Text(count=jd.Count("B", 0, 255)))
        tool_frame: str = jd.field("ToolFrame", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class PlannedJointRec(jd.Struct):
        """joint_name: up to 255 characters. Name of the joint in the description"""
        joint_name: str = jd.field("JointName", jd.Text(count=jd.Count("B", 0, 255)))

    planned_arm_rec: ReportMotionPlannerSpecification.PlannedArmRec = jd.field("PlannedArmRec", lambda: ReportMotionPlannerSpecification.PlannedArmRec.layout())
    planned_joint_list: list[ReportMotionPlannerSpecification.PlannedJointRec] = jd.field("PlannedJointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportMotionPlannerSpecification.PlannedJointRec.layout()))


@jd.message(_SERVICE, 0xEA42, query=True)
class QueryMotionPlannerSpecification(jd.Message):
    """QueryMotionPlannerSpecification (0xEA42): Asks for which arm it plans."""
    REPORT = ReportMotionPlannerSpecification


@jd.message(_SERVICE, 0xDA43, command=True)
class SetHeldObject(jd.Message):
    """SetHeldObject (0xDA43): States what the gripper holds: plans that are made from now on move it along.

    shape: Shape. The shape that encloses it
    object_name: up to 255 characters. Its name in reasons, such as what it would touch
    x: in meter. X of its middle, in metres, in the frame of the tool
    y: in meter. Y of its middle, in metres
    z: in meter. Z of its middle, in metres
    roll: in radian. Roll of its axes about those of the tool, in radians
    pitch: in radian. Pitch of its axes, in radians
    yaw: in radian. Yaw of its axes, in radians
    size_x: in meter. Side along its x axis, in metres; the diameter of a sphere and of a cylinder
    size_y: in meter. Side along y, in metres; only for a box
    size_z: in meter. Side along z, in metres; the length of a cylinder; not for a sphere
    """

    class Shape(IntEnum):
        NOTHING = 0
        BOX = 1
        SPHERE = 2
        CYLINDER = 3

    shape: SetHeldObject.Shape | int = jd.field("Shape", lambda: jd.Number("B", jd.Values(SetHeldObject.Shape)))
    object_name: str = jd.field("ObjectName", jd.Text(count=jd.Count("B", 0, 255)))
    x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
    y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
    z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
    roll: float = jd.field("Roll", jd.Number("d", jd.ANY, "radian"))
    pitch: float = jd.field("Pitch", jd.Number("d", jd.ANY, "radian"))
    yaw: float = jd.field("Yaw", jd.Number("d", jd.ANY, "radian"))
    size_x: float = jd.field("SizeX", jd.Number("d", jd.ANY, "meter"))
    size_y: float = jd.field("SizeY", jd.Number("d", jd.ANY, "meter"))
    size_z: float = jd.field("SizeZ", jd.Number("d", jd.ANY, "meter"))


@jd.message(_SERVICE, 0xFA43)
class ReportHeldObject(jd.Message):
    """ReportHeldObject (0xFA43): What the planner takes the gripper to hold.

    shape: Shape. The shape that encloses it
    object_name: up to 255 characters. Its name in reasons, such as what it would touch
    x: in meter. X of its middle, in metres, in the frame of the tool
    y: in meter. Y of its middle, in metres
    z: in meter. Z of its middle, in metres
    roll: in radian. Roll of its axes about those of the tool, in radians
    pitch: in radian. Pitch of its axes, in radians
    yaw: in radian. Yaw of its axes, in radians
    size_x: in meter. Side along its x axis, in metres; the diameter of a sphere and of a cylinder
    size_y: in meter. Side along y, in metres; only for a box
    size_z: in meter. Side along z, in metres; the length of a cylinder; not for a sphere
    """

    class Shape(IntEnum):
        NOTHING = 0
        BOX = 1
        SPHERE = 2
        CYLINDER = 3

    shape: ReportHeldObject.Shape | int = jd.field("Shape", lambda: jd.Number("B", jd.Values(ReportHeldObject.Shape)))
    object_name: str = jd.field("ObjectName", jd.Text(count=jd.Count("B", 0, 255)))
    x: float = jd.field("X", jd.Number("d", jd.ANY, "meter"))
    y: float = jd.field("Y", jd.Number("d", jd.ANY, "meter"))
    z: float = jd.field("Z", jd.Number("d", jd.ANY, "meter"))
    roll: float = jd.field("Roll", jd.Number("d", jd.ANY, "radian"))
    pitch: float = jd.field("Pitch", jd.Number("d", jd.ANY, "radian"))
    yaw: float = jd.field("Yaw", jd.Number("d", jd.ANY, "radian"))
    size_x: float = jd.field("SizeX", jd.Number("d", jd.ANY, "meter"))
    size_y: float = jd.field("SizeY", jd.Number("d", jd.ANY, "meter"))
    size_z: float = jd.field("SizeZ", jd.Number("d", jd.ANY, "meter"))


@jd.message(_SERVICE, 0xEA43, query=True)
class QueryHeldObject(jd.Message):
    """QueryHeldObject (0xEA43): Asks for what is moved along."""
    REPORT = ReportHeldObject
