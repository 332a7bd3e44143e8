"""urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.manipulator.v1_0 import types as manipulator_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:manipulator:ManipulatorActuatorForceTorqueDriver", "1.0")


@jd.message(_SERVICE, 0x4600, presence="B", kw_only=True)
class ReportManipulatorSpecifications(jd.Message):
    """ReportManipulatorSpecifications (0x4600): Tells geometry and limits of the manipulator.

    manipulator_coordinate_system_rec: optional. Where the base is mounted on the vehicle
    first_joint_parameters: The first joint, revolute or prismatic
    joint_specification_list: 0..255 items. The joints after the first
    """
    ManipulatorCoordinateSystemRec = manipulator_v1_0_types.ManipulatorCoordinateSystemRec
    RevoluteJoint1OffsetRec = manipulator_v1_0_types.RevoluteJoint1OffsetRec
    PrismaticJoint1AngleRec = manipulator_v1_0_types.PrismaticJoint1AngleRec
    RevoluteJointSpecificationRec = manipulator_v1_0_types.RevoluteJointSpecificationRec
    PrismaticJointSpecificationRec = manipulator_v1_0_types.PrismaticJointSpecificationRec
    manipulator_coordinate_system_rec: manipulator_v1_0_types.ManipulatorCoordinateSystemRec | None = jd.field("ManipulatorCoordinateSystemRec", lambda: manipulator_v1_0_types.ManipulatorCoordinateSystemRec.layout(), default=None)
    first_joint_parameters: manipulator_v1_0_types.RevoluteJoint1OffsetRec | manipulator_v1_0_types.PrismaticJoint1AngleRec = jd.field("FirstJointParameters", lambda: jd.Union.of("B", revolute_joint1_offset_rec=manipulator_v1_0_types.RevoluteJoint1OffsetRec, prismatic_joint1_angle_rec=manipulator_v1_0_types.PrismaticJoint1AngleRec))
    joint_specification_list: list[manipulator_v1_0_types.RevoluteJointSpecificationRec | manipulator_v1_0_types.PrismaticJointSpecificationRec] = jd.field("JointSpecificationList", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Union.of("B", revolute_joint_specification_rec=manipulator_v1_0_types.RevoluteJointSpecificationRec, prismatic_joint_specification_rec=manipulator_v1_0_types.PrismaticJointSpecificationRec)))
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2600, query=True)
class QueryManipulatorSpecifications(jd.Message):
    """QueryManipulatorSpecifications (0x2600): Asks for geometry and limits of the manipulator.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportManipulatorSpecifications
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x1)


@jd.message(_SERVICE, 0x4613)
class ReportCommandedActuatorForceTorques(jd.Message):
    """ReportCommandedActuatorForceTorques (0x4613): Tells the commanded force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """
    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec
    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec] = jd.field("ActuatorForceTorqueList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout()))


@jd.message(_SERVICE, 0x2613, query=True)
class QueryCommandedActuatorForceTorques(jd.Message):
    """QueryCommandedActuatorForceTorques (0x2613): Asks for the commanded force or torque of each joint."""
    REPORT = ReportCommandedActuatorForceTorques


@jd.message(_SERVICE, 0x0613, command=True)
class SetActuatorForceTorques(jd.Message):
    """SetActuatorForceTorques (0x0613): Sets the force or torque of each joint.

    actuator_force_torque_list: 0..255 items. The joints, from the base
    """
    ActuatorForceTorqueRec = manipulator_v1_0_types.ActuatorForceTorqueRec
    actuator_force_torque_list: list[manipulator_v1_0_types.ActuatorForceTorqueRec] = jd.field("ActuatorForceTorqueList", lambda: jd.Repeat(jd.Count("B", 0, 255), manipulator_v1_0_types.ActuatorForceTorqueRec.layout()))
