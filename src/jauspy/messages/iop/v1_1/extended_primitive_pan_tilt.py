"""urn:jaus:jss:iop:ExtendedPrimitivePanTilt 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:ExtendedPrimitivePanTilt", "1.1")


@jd.message(_SERVICE, 0xF29B)
class ReportPanTiltManipulatorHost(jd.Message):
    """ReportPanTiltManipulatorHost (0xF29B): Manipulator and joint that carry the unit.

    parent_id: JAUS address of the carrying manipulator; zero when there is none
    parent_joint: Joint whose frame carries the unit; zero when there is none
    """
    ParentID = iop_v1_0_types.ParentID
    parent_id: iop_v1_0_types.ParentID = jd.field("ParentID", lambda: iop_v1_0_types.ParentID.layout())
    parent_joint: int = jd.field("ParentJoint", jd.Number("B"))


@jd.message(_SERVICE, 0xF29A, query=True)
class QueryPanTiltHostManipulator(jd.Message):
    """QueryPanTiltHostManipulator (0xF29A): Asks which manipulator and joint carry the unit (joint 1 is the one at the base)."""
    REPORT = ReportPanTiltManipulatorHost


@jd.message(_SERVICE, 0xF299, presence="B")
class ReportPanTiltOperationalParameters(jd.Message):
    """ReportPanTiltOperationalParameters (0xF299): Temperature, voltage and currents of the two joints.

    joint1_temperature: -50..150 degree Celsius, optional. Temperature of joint 1 in degrees Celsius
    joint1_bus_voltage: 0..150 volt, optional. Supply voltage of joint 1
    joint1_bus_current: 0..200 ampere, optional. Supply current of joint 1
    joint1_phase_current: 0..200 ampere, optional. Motor phase current of joint 1
    joint2_temperature: -50..150 degree Celsius, optional. Temperature of joint 2 in degrees Celsius
    joint2_bus_voltage: 0..150 volt, optional. Supply voltage of joint 2
    joint2_bus_current: 0..200 ampere, optional. Supply current of joint 2
    joint2_phase_current: 0..200 ampere, optional. Motor phase current of joint 2
    """
    joint1_temperature: float | None = jd.field("Joint1Temperature", jd.real("H", -50.0, 150.0, "degree Celsius"), default=None)
    joint1_bus_voltage: float | None = jd.field("Joint1BusVoltage", jd.real("H", 0.0, 150.0, "volt"), default=None)
    joint1_bus_current: float | None = jd.field("Joint1BusCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)
    joint1_phase_current: float | None = jd.field("Joint1PhaseCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)
    joint2_temperature: float | None = jd.field("Joint2Temperature", jd.real("H", -50.0, 150.0, "degree Celsius"), default=None)
    joint2_bus_voltage: float | None = jd.field("Joint2BusVoltage", jd.real("H", 0.0, 150.0, "volt"), default=None)
    joint2_bus_current: float | None = jd.field("Joint2BusCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)
    joint2_phase_current: float | None = jd.field("Joint2PhaseCurrent", jd.real("H", 0.0, 200.0, "ampere"), default=None)


@jd.message(_SERVICE, 0xF298, query=True)
class QueryPanTiltOperationalParameters(jd.Message):
    """QueryPanTiltOperationalParameters (0xF298): Asks for the joint readings; fields that the unit cannot supply may be left out.

    presence_vector: Which fields of the report are wanted; bits as in the presence vector of F299
    """
    REPORT = ReportPanTiltOperationalParameters
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0xFF)
