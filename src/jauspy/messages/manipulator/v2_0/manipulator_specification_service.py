"""urn:jaus:jss:manipulator:ManipulatorSpecificationService 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorSpecificationService", "2.0")


@jd.message(_SERVICE, 0x4600, presence="B", kw_only=True)
class ReportManipulatorSpecifications(jd.Message):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator.

    manipulator_coordinate_system_rec: optional. Where the base is mounted on the vehicle
    first_joint_parameters: The first joint, revolute or prismatic
    joint_specification_list: 0..255 items. The joints after the first
    joint_names_list: 0..255 items, optional. The joints, from the base
    """
    ManipulatorCoordinateSystemRec = manipulator_v1_0_types.ManipulatorCoordinateSystemRec

    @jd.record("B")
    class RevoluteJoint1OffsetRec(jd.Struct):
        """The first joint, when revolute.

        joint1_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
        joint1_min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
        joint1_max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
        joint1_max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
        joint1_max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
        offset_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the offset, in metres
        """
        joint1_offset: float = jd.field("Joint1Offset", jd.real("H", -10.0, 10.0, "meter"))
        joint1_min_value: float | None = jd.field("Joint1MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
        joint1_max_value: float | None = jd.field("Joint1MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
        joint1_max_speed: float | None = jd.field("Joint1MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"), default=None)
        joint1_max_torque: float | None = jd.field("Joint1MaxTorque", jd.real("I", 0.0, 5000.0, "newton meter"), default=None)
        offset_bounding_cylinder_radius: float | None = jd.field("OffsetBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class PrismaticJoint1AngleRec(jd.Struct):
        """The first joint, when prismatic.

        joint1_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
        joint1_min_value: -10..10 meter. Smallest position, in metres
        joint1_max_value: -10..10 meter. Largest position, in metres
        joint1_max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
        joint1_max_force: 0..5000 newton, optional. Largest force, in newtons
        joint_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the joint, in metres
        """
        joint1_angle: float = jd.field("Joint1Angle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
        joint1_min_value: float = jd.field("Joint1MinValue", jd.real("I", -10.0, 10.0, "meter"))
        joint1_max_value: float = jd.field("Joint1MaxValue", jd.real("I", -10.0, 10.0, "meter"))
        joint1_max_speed: float | None = jd.field("Joint1MaxSpeed", jd.real("I", -5.0, 5.0, "meter per second"), default=None)
        joint1_max_force: float | None = jd.field("Joint1MaxForce", jd.real("I", 0.0, 5000.0, "newton"), default=None)
        joint_bounding_cylinder_radius: float | None = jd.field("JointBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class RevoluteJointSpecificationRec(jd.Struct):
        """A revolute joint.

        link_length: -10..10 meter. Distance to the axis of the joint before, in metres
        twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
        joint_offset: -10..10 meter. Fixed offset along the axis of the joint, in metres
        min_value: -25.1327412287..25.1327412287 radian, optional. Smallest position, in radians
        max_value: -25.1327412287..25.1327412287 radian, optional. Largest position, in radians
        max_speed: 0..31.4159265359 radian per second, optional. Largest speed, in radians per second
        max_torque: 0..5000 newton meter, optional. Largest torque, in newton metres
        offset_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the offset, in metres
        link_length_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the link, in metres
        """
        link_length: float = jd.field("LinkLength", jd.real("H", -10.0, 10.0, "meter"))
        twist_angle: float = jd.field("TwistAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
        joint_offset: float = jd.field("JointOffset", jd.real("H", -10.0, 10.0, "meter"))
        min_value: float | None = jd.field("MinValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
        max_value: float | None = jd.field("MaxValue", jd.real("I", -25.132741228718345, 25.132741228718345, "radian"), default=None)
        max_speed: float | None = jd.field("MaxSpeed", jd.real("I", 0.0, 31.41592653589793, "radian per second"), default=None)
        max_torque: float | None = jd.field("MaxTorque", jd.real("I", 0.0, 5000.0, "newton meter"), default=None)
        offset_bounding_cylinder_radius: float | None = jd.field("OffsetBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        link_length_bounding_cylinder_radius: float | None = jd.field("LinkLengthBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class PrismaticJointSpecificationRec(jd.Struct):
        """A prismatic joint.

        link_length: -10..10 meter. Distance to the axis of the joint before, in metres
        twist_angle: -3.14159265359..3.14159265359 radian. Angle to the axis of the joint before, in radians
        joint_angle: -3.14159265359..3.14159265359 radian. Fixed angle of the joint, in radians
        min_value: -10..10 meter. Smallest position, in metres
        max_value: -10..10 meter. Largest position, in metres
        max_speed: -5..5 meter per second, optional. Largest speed, in metres per second
        max_force: 0..5000 newton, optional. Largest force, in newtons
        joint_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the joint, in metres
        link_length_bounding_cylinder_radius: 0..10 meter, optional. Radius of a cylinder around the link, in metres
        """
        link_length: float = jd.field("LinkLength", jd.real("H", -10.0, 10.0, "meter"))
        twist_angle: float = jd.field("TwistAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
        joint_angle: float = jd.field("JointAngle", jd.real("H", -3.141592653589793, 3.141592653589793, "radian"))
        min_value: float = jd.field("MinValue", jd.real("I", -10.0, 10.0, "meter"))
        max_value: float = jd.field("MaxValue", jd.real("I", -10.0, 10.0, "meter"))
        max_speed: float | None = jd.field("MaxSpeed", jd.real("I", -5.0, 5.0, "meter per second"), default=None)
        max_force: float | None = jd.field("MaxForce", jd.real("I", 0.0, 5000.0, "newton"), default=None)
        joint_bounding_cylinder_radius: float | None = jd.field("JointBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        link_length_bounding_cylinder_radius: float | None = jd.field("LinkLengthBoundingCylinderRadius", jd.real("H", 0.0, 10.0, "meter"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class JointNameRec(jd.Struct):
        """description: up to 255 characters. Name of the joint, for people"""
        description: str = jd.field("Description", jd.Text(count=jd.Count("B", 0, 255)))

    manipulator_coordinate_system_rec: manipulator_v1_0_types.ManipulatorCoordinateSystemRec | None = jd.field("ManipulatorCoordinateSystemRec", lambda: manipulator_v1_0_types.ManipulatorCoordinateSystemRec.layout(), default=None)
    first_joint_parameters: ReportManipulatorSpecifications.RevoluteJoint1OffsetRec | ReportManipulatorSpecifications.PrismaticJoint1AngleRec = jd.field("FirstJointParameters", lambda: jd.Union.of("B", revolute_joint1_offset_rec=ReportManipulatorSpecifications.RevoluteJoint1OffsetRec, prismatic_joint1_angle_rec=ReportManipulatorSpecifications.PrismaticJoint1AngleRec))
    joint_specification_list: list[ReportManipulatorSpecifications.RevoluteJointSpecificationRec | ReportManipulatorSpecifications.PrismaticJointSpecificationRec] = jd.field("JointSpecificationList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_joint_specification_rec=ReportManipulatorSpecifications.RevoluteJointSpecificationRec, prismatic_joint_specification_rec=ReportManipulatorSpecifications.PrismaticJointSpecificationRec)))
    joint_names_list: list[ReportManipulatorSpecifications.JointNameRec] | None = jd.field("JointNamesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportManipulatorSpecifications.JointNameRec.layout()), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2600, query=True)
class QueryManipulatorSpecifications(jd.Message):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportManipulatorSpecifications
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x3)
