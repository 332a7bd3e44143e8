"""urn:jaus:jss:iop:ExtendedPrimitiveManipulator 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:ExtendedPrimitiveManipulator", "1.1")


@jd.message(_SERVICE, 0xF293)
class ReportManipulatorHost(jd.Message):
    """ReportManipulatorHost (0xF293): Tells which manipulator, and which joint of it, carries this one.

    parent_id: JAUS address of the carrying manipulator; 0 if there is none
    parent_joint: Joint of the carrying manipulator whose frame is the base here, counted from 1 at its base; 0 if there is none
    """
    ParentID = iop_v1_0_types.ParentID
    parent_id: iop_v1_0_types.ParentID = jd.field("ParentID", lambda: iop_v1_0_types.ParentID.layout())
    parent_joint: int = jd.field("ParentJoint", jd.Number("B"))


@jd.message(_SERVICE, 0xF292, query=True)
class QueryHostManipulator(jd.Message):
    """QueryHostManipulator (0xF292): Asks which manipulator, and which joint of it, carries this one."""
    REPORT = ReportManipulatorHost


@jd.message(_SERVICE, 0xF291)
class ReportOperationalParameters(jd.Message):
    """ReportOperationalParameters (0xF291): Tells the operating data of the joints.

    joint_operational_parameters_list: 0..255 items. One element a joint
    """

    @jd.record("B")
    class JointOperationalParameterRec(jd.Struct):
        """joint_number: Joint, counted from 1 at the base outwards
        joint_temperature: -50..150 degree Celsius, optional. Temperature of the joint
        bus_voltage: 0..150 volt, optional. Voltage of the joint's supply
        bus_current: 0..200 ampere, optional. Current taken from the supply
        phase_current: 0..200 ampere, optional. Current in the motor's phases
        """
        joint_number: int = jd.field("JointNumber", jd.Number("B"))
        joint_temperature: float | None = jd.field("JointTemperature", jd.real("H", -50.0, 150.0, "degree Celsius"), default=None)
        bus_voltage: float | None = jd.field("BusVoltage", jd.real("H", 0.0, 150.0, "volt"), default=None)
        bus_current: float | None = jd.field("BusCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)
        phase_current: float | None = jd.field("PhaseCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)
        reserved_presence: int = 0

    joint_operational_parameters_list: list[ReportOperationalParameters.JointOperationalParameterRec] = jd.field("JointOperationalParametersList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportOperationalParameters.JointOperationalParameterRec.layout()))


@jd.message(_SERVICE, 0xF290, query=True)
class QueryJointOperationalParameters(jd.Message):
    """QueryJointOperationalParameters (0xF290): Asks for the operating data of the joints.

    presence_vector: Wanted values, one bit each: 0 JointTemperature, 1 BusVoltage, 2 BusCurrent, 3 PhaseCurrent
    """
    REPORT = ReportOperationalParameters
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))
