"""urn:jauspy:cell:ModularArm 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:ModularArm", "1.0")


@jd.message(_SERVICE, 0xDA65, command=True)
class MoveModularArm(jd.Message):
    """MoveModularArm (0xDA65): Moves the joints to positions.

    position_list: 0..255 items. One for each joint
    """

    @jd.record()
    class MotionDurationRec(jd.Struct):
        """duration: in second. Seconds until the arm is there; with 0 it takes as long as limits demand"""
        duration: float = jd.field("Duration", jd.Number("d", jd.ANY, "second"))

    @jd.record("B")
    class JointPositionRec(jd.Struct):
        """position: in radian, optional. Position in radians, of any number of turns; left out, the joint stays as it is"""
        position: float | None = jd.field("Position", jd.Number("d", jd.ANY, "radian"), default=None)
        reserved_presence: int = 0

    motion_duration_rec: MoveModularArm.MotionDurationRec = jd.field("MotionDurationRec", lambda: MoveModularArm.MotionDurationRec.layout())
    position_list: list[MoveModularArm.JointPositionRec] = jd.field("PositionList", lambda: jd.Repeat(jd.Count("B", 0, 255), MoveModularArm.JointPositionRec.layout()))


@jd.message(_SERVICE, 0xDA66, command=True)
class HoldModularArm(jd.Message):
    """HoldModularArm (0xDA66): Brakes along the present path, and holds all joints."""


@jd.message(_SERVICE, 0xDA67, command=True)
class SetModularArmController(jd.Message):
    """SetModularArmController (0xDA67): Chooses how the joints follow their trajectories.

    controller: Controller. How the joints follow: one PID controller each, or inverse dynamics of the arm as it is
    """

    class Controller(IntEnum):
        INDEPENDENT_PID = 0
        INVERSE_DYNAMICS = 1

    controller: SetModularArmController.Controller | int = jd.field("Controller", lambda: jd.Number("B", jd.Values(SetModularArmController.Controller)))


@jd.message(_SERVICE, 0xDA68, command=True)
class SetModularArmOrder(jd.Message):
    """SetModularArmOrder (0xDA68): Fixes the order of the joints; an empty list finds it by attachments.

    joint_list: 0..255 items. The joints, base to tip
    """

    @jd.record()
    class JointNameRec(jd.Struct):
        """name: up to 255 characters. Name of the servo module"""
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))

    joint_list: list[SetModularArmOrder.JointNameRec] = jd.field("JointList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetModularArmOrder.JointNameRec.layout()))


@jd.message(_SERVICE, 0xDA69, command=True)
class SetModularArmTrajectory(jd.Message):
    """SetModularArmTrajectory (0xDA69): Moves joints through points at given times, and to rest at the last one.

    joint_list: 0..255 items. The joints that move; none means all, base to tip
    point_list: 0..255 items. The points, in the order of their times
    """

    @jd.record()
    class ModularArmTrajectoryRec(jd.Struct):
        """motion_number: The client's own number of a motion; 0 in a query means the last motion"""
        motion_number: int = jd.field("MotionNumber", jd.Number("I"))

    @jd.record()
    class JointNameRec(jd.Struct):
        """name: up to 255 characters. Name of the servo module"""
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class PointTimeRec(jd.Struct):
        """time: in second. Seconds from the start; 0 for a single point takes as long as limits demand"""
        time: float = jd.field("Time", jd.Number("d", jd.ANY, "second"))

    @jd.record("B")
    class JointValuesRec(jd.Struct):
        """position: in radian. Position in radians, of any number of turns
        velocity: in radian per second, optional. Velocity in rad/s; left out, it is that of the smoothest path
        acceleration: in radian per second squared, optional. Acceleration in rad/s^2; left out, it is that of the smoothest path
        """
        position: float = jd.field("Position", jd.Number("d", jd.ANY, "radian"))
        velocity: float | None = jd.field("Velocity", jd.Number("f", jd.ANY, "radian per second"), default=None)
        acceleration: float | None = jd.field("Acceleration", jd.Number("f", jd.ANY, "radian per second squared"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class TrajectoryPointSeq(jd.Struct):
        """value_list: 0..255 items. One for each joint of the list of joints"""
        point_time_rec: SetModularArmTrajectory.PointTimeRec = jd.field("PointTimeRec", lambda: SetModularArmTrajectory.PointTimeRec.layout())
        value_list: list[SetModularArmTrajectory.JointValuesRec] = jd.field("ValueList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetModularArmTrajectory.JointValuesRec.layout()))

    modular_arm_trajectory_rec: SetModularArmTrajectory.ModularArmTrajectoryRec = jd.field("ModularArmTrajectoryRec", lambda: SetModularArmTrajectory.ModularArmTrajectoryRec.layout())
    joint_list: list[SetModularArmTrajectory.JointNameRec] = jd.field("JointList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetModularArmTrajectory.JointNameRec.layout()))
    point_list: list[SetModularArmTrajectory.TrajectoryPointSeq] = jd.field("PointList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetModularArmTrajectory.TrajectoryPointSeq.layout()))


@jd.message(_SERVICE, 0xFA68)
class ReportModularArmState(jd.Message):
    """ReportModularArmState (0xFA68): Tells joints and motion.

    joint_list: 0..255 items. The joints
    """

    class Moving(IntEnum):
        AT_REST = 0
        MOVING = 1

    class Controller(IntEnum):
        INDEPENDENT_PID = 0
        INVERSE_DYNAMICS = 1

    @jd.record()
    class ModularArmMotionRec(jd.Struct):
        """moving: Moving. Whether a motion is carried out
        controller: Controller. How the joints follow: one PID controller each, or inverse dynamics of the arm as it is
        payload: in kilogram. Estimated mass at the tip, in kilograms
        tip_x: in meter. X of the frame of the tip in that of the world, z up, by the model, in metres
        tip_y: in meter. Y of the frame of the tip in that of the world, z up, by the model, in metres
        tip_z: in meter. Z of the frame of the tip in that of the world, z up, by the model, in metres
        tip_orientation_w: W of the unit quaternion from the frame of the tip to that of the world
        tip_orientation_x: X of the unit quaternion from the frame of the tip to that of the world
        tip_orientation_y: Y of the unit quaternion from the frame of the tip to that of the world
        tip_orientation_z: Z of the unit quaternion from the frame of the tip to that of the world
        error: up to 255 characters. Why the last motion ended early or was not begun; empty after a success
        """
        moving: ReportModularArmState.Moving | int = jd.field("Moving", lambda: jd.Number("B", jd.Values(ReportModularArmState.Moving)))
        controller: ReportModularArmState.Controller | int = jd.field("Controller", lambda: jd.Number("B", jd.Values(ReportModularArmState.Controller)))
        payload: float = jd.field("Payload", jd.Number("f", jd.ANY, "kilogram"))
        tip_x: float = jd.field("TipX", jd.Number("d", jd.ANY, "meter"))
        tip_y: float = jd.field("TipY", jd.Number("d", jd.ANY, "meter"))
        tip_z: float = jd.field("TipZ", jd.Number("d", jd.ANY, "meter"))
        tip_orientation_w: float = jd.field("TipOrientationW", jd.Number("f"))
        tip_orientation_x: float = jd.field("TipOrientationX", jd.Number("f"))
        tip_orientation_y: float = jd.field("TipOrientationY", jd.Number("f"))
        tip_orientation_z: float = jd.field("TipOrientationZ", jd.Number("f"))
        error: str = jd.field("Error", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class ModularJointRec(jd.Struct):
        """name: up to 255 characters. Name of the servo module
        position: in radian. Position of any number of turns, in radians
        velocity: in radian per second. Velocity, in radians per second
        effort: in newton meter. Torque, in newton metres
        target: in radian. Position at the end of the present motion, in radians
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        position: float = jd.field("Position", jd.Number("d", jd.ANY, "radian"))
        velocity: float = jd.field("Velocity", jd.Number("f", jd.ANY, "radian per second"))
        effort: float = jd.field("Effort", jd.Number("f", jd.ANY, "newton meter"))
        target: float = jd.field("Target", jd.Number("d", jd.ANY, "radian"))

    modular_arm_motion_rec: ReportModularArmState.ModularArmMotionRec = jd.field("ModularArmMotionRec", lambda: ReportModularArmState.ModularArmMotionRec.layout())
    joint_list: list[ReportModularArmState.ModularJointRec] = jd.field("JointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModularArmState.ModularJointRec.layout()))


@jd.message(_SERVICE, 0xEA68, query=True)
class QueryModularArmState(jd.Message):
    """QueryModularArmState (0xEA68): Asks for joints and motion."""
    REPORT = ReportModularArmState


@jd.message(_SERVICE, 0xFA69)
class ReportModularArmSpecification(jd.Message):
    """ReportModularArmSpecification (0xFA69): Tells what the arm is made of, and the limits of its joints.

    joint_list: 0..255 items. The joints
    part_list: 0..255 items. All parts, base to tip
    """

    @jd.record()
    class ModularArmEndsRec(jd.Struct):
        """base: up to 255 characters. Connector that carries the arm; empty without one
        tip: up to 255 characters. Connector at its end; empty without one
        """
        base: str = jd.field("Base", jd.Text(count=jd.Count("B", 0, 255)))
        tip: str = jd.field("Tip", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class JointLimitsRec(jd.Struct):
        """name: up to 255 characters. Name of the servo module
        type: up to 255 characters. Type of the part
        max_torque: in newton meter. Largest torque, in newton metres
        max_speed: in radian per second. Largest speed, in radians per second
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        type: str = jd.field("Type", jd.Text(count=jd.Count("B", 0, 255)))
        max_torque: float = jd.field("MaxTorque", jd.Number("f", jd.ANY, "newton meter"))
        max_speed: float = jd.field("MaxSpeed", jd.Number("f", jd.ANY, "radian per second"))

    @jd.record()
    class ArmPartRec(jd.Struct):
        """part_name: up to 255 characters. Name of the part"""
        part_name: str = jd.field("PartName", jd.Text(count=jd.Count("B", 0, 255)))

    modular_arm_ends_rec: ReportModularArmSpecification.ModularArmEndsRec = jd.field("ModularArmEndsRec", lambda: ReportModularArmSpecification.ModularArmEndsRec.layout())
    joint_list: list[ReportModularArmSpecification.JointLimitsRec] = jd.field("JointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModularArmSpecification.JointLimitsRec.layout()))
    part_list: list[ReportModularArmSpecification.ArmPartRec] = jd.field("PartList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModularArmSpecification.ArmPartRec.layout()))


@jd.message(_SERVICE, 0xEA69, query=True)
class QueryModularArmSpecification(jd.Message):
    """QueryModularArmSpecification (0xEA69): Asks what the arm is made of, and for the limits of its joints."""
    REPORT = ReportModularArmSpecification


@jd.message(_SERVICE, 0xFA6A)
class ReportModularArmMotionResult(jd.Message):
    """ReportModularArmMotionResult (0xFA6A): Tells how a motion ended, and why.

    motion_number: The client's own number of a motion; 0 in a query means the last motion
    result: Result. How the motion ended, if it has
    reason: up to 255 characters. Why it was refused or ended early; empty otherwise
    """

    class Result(IntEnum):
        UNKNOWN = 0
        IN_PROGRESS = 1
        REACHED = 2
        REFUSED = 3
        STOPPED = 4
        REPLACED = 5
        BLOCKED = 6
        FAILED = 7

    motion_number: int = jd.field("MotionNumber", jd.Number("I"))
    result: ReportModularArmMotionResult.Result | int = jd.field("Result", lambda: jd.Number("B", jd.Values(ReportModularArmMotionResult.Result)))
    reason: str = jd.field("Reason", jd.Text(count=jd.Count("B", 0, 255)))


@jd.message(_SERVICE, 0xEA6A, query=True)
class QueryModularArmMotionResult(jd.Message):
    """QueryModularArmMotionResult (0xEA6A): Asks how a motion ended.

    motion_number: The client's own number of a motion; 0 in a query means the last motion
    """
    REPORT = ReportModularArmMotionResult
    motion_number: int = jd.field("MotionNumber", jd.Number("I"))
