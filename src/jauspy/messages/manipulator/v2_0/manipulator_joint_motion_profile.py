"""urn:jaus:jss:manipulator:ManipulatorJointMotionProfile 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorJointMotionProfile", "2.0")


@jd.message(_SERVICE, 0x4607)
class ReportJointMotionProfile(jd.Message):
    """ReportJointMotionProfile (0x4607): Tells the limits of speed and acceleration of each joint.

    joint_motion_profile_list: 0..255 items. The joints, from the base
    """

    @jd.record()
    class RevoluteJointMotionProfileRec(jd.Struct):
        """Limits of a revolute joint.

        joint_max_speed: 0..31.4159265359 radian per second. Largest speed, in radians per second
        joint_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration, in radians per second squared
        joint_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration, in radians per second squared
        """
        joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
        joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
        joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))

    @jd.record()
    class PrismaticJointMotionProfileRec(jd.Struct):
        """Limits of a prismatic joint.

        joint_max_speed: 0..5 meter per second. Largest speed, in metres per second
        joint_max_acceleration_rate: 0..20 meter per second squared. Largest acceleration, in metres per second squared
        joint_max_deceleration_rate: 0..20 meter per second squared. Largest deceleration, in metres per second squared
        """
        joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 5.0, "meter per second"))
        joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))
        joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))

    joint_motion_profile_list: list[ReportJointMotionProfile.RevoluteJointMotionProfileRec | ReportJointMotionProfile.PrismaticJointMotionProfileRec] = jd.field("JointMotionProfileList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_joint_motion_profile_rec=ReportJointMotionProfile.RevoluteJointMotionProfileRec, prismatic_joint_motion_profile_rec=ReportJointMotionProfile.PrismaticJointMotionProfileRec)))


@jd.message(_SERVICE, 0x2607, query=True)
class QueryJointMotionProfile(jd.Message):
    """QueryJointMotionProfile (0x2607): Asks for the limits of speed and acceleration of each joint."""
    REPORT = ReportJointMotionProfile


@jd.message(_SERVICE, 0x0607, command=True)
class SetJointMotionProfile(jd.Message):
    """SetJointMotionProfile (0x0607): Sets limits of speed and acceleration of each joint.

    joint_motion_profile_list: 0..255 items. The joints, from the base
    """

    @jd.record()
    class RevoluteJointMotionProfileRec(jd.Struct):
        """Limits of a revolute joint.

        joint_max_speed: 0..31.4159265359 radian per second. Largest speed, in radians per second
        joint_max_acceleration_rate: 0..31.4159265359 radian per second squared. Largest acceleration, in radians per second squared
        joint_max_deceleration_rate: 0..31.4159265359 radian per second squared. Largest deceleration, in radians per second squared
        """
        joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"))
        joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))
        joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 31.41592653589793, "radian per second squared"))

    @jd.record()
    class PrismaticJointMotionProfileRec(jd.Struct):
        """Limits of a prismatic joint.

        joint_max_speed: 0..5 meter per second. Largest speed, in metres per second
        joint_max_acceleration_rate: 0..20 meter per second squared. Largest acceleration, in metres per second squared
        joint_max_deceleration_rate: 0..20 meter per second squared. Largest deceleration, in metres per second squared
        """
        joint_max_speed: float = jd.field("JointMaxSpeed", jd.real("I", 0.0, 5.0, "meter per second"))
        joint_max_acceleration_rate: float = jd.field("JointMaxAccelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))
        joint_max_deceleration_rate: float = jd.field("JointMaxDecelerationRate", jd.real("I", 0.0, 20.0, "meter per second squared"))

    joint_motion_profile_list: list[SetJointMotionProfile.RevoluteJointMotionProfileRec | SetJointMotionProfile.PrismaticJointMotionProfileRec] = jd.field("JointMotionProfileList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_joint_motion_profile_rec=SetJointMotionProfile.RevoluteJointMotionProfileRec, prismatic_joint_motion_profile_rec=SetJointMotionProfile.PrismaticJointMotionProfileRec)))
