"""urn:jaus:jss:mobility:PrimitiveDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:PrimitiveDriver", "1.0")


@jd.message(_SERVICE, 0x0405, presence="H", command=True)
class SetWrenchEffort(jd.Message):
    """SetWrenchEffort (0x0405): Sets propulsive and resistive efforts.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """
    propulsive_linear_effort_x: float | None = jd.field("PropulsiveLinearEffortX", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_linear_effort_y: float | None = jd.field("PropulsiveLinearEffortY", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_linear_effort_z: float | None = jd.field("PropulsiveLinearEffortZ", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_x: float | None = jd.field("PropulsiveRotationalEffortX", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_y: float | None = jd.field("PropulsiveRotationalEffortY", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_z: float | None = jd.field("PropulsiveRotationalEffortZ", jd.real("H", -100.0, 100.0, "percent"), default=None)
    resistive_linear_effort_x: float | None = jd.field("ResistiveLinearEffortX", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_linear_effort_y: float | None = jd.field("ResistiveLinearEffortY", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_linear_effort_z: float | None = jd.field("ResistiveLinearEffortZ", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_x: float | None = jd.field("ResistiveRotationalEffortX", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_y: float | None = jd.field("ResistiveRotationalEffortY", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_z: float | None = jd.field("ResistiveRotationalEffortZ", jd.real("B", 0.0, 100.0, "percent"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x4405, presence="H")
class ReportWrenchEffort(jd.Message):
    """ReportWrenchEffort (0x4405): Tells the efforts in use.

    propulsive_linear_effort_x: -100..100 percent, optional. Effort forward (X), in percent of the maximum
    propulsive_linear_effort_y: -100..100 percent, optional. Effort to the right (Y), in percent of the maximum
    propulsive_linear_effort_z: -100..100 percent, optional. Effort down (Z), in percent of the maximum
    propulsive_rotational_effort_x: -100..100 percent, optional. Effort to roll to the right (about X), in percent of the maximum
    propulsive_rotational_effort_y: -100..100 percent, optional. Effort to pitch up (about Y), in percent of the maximum
    propulsive_rotational_effort_z: -100..100 percent, optional. Effort to turn to the right (about Z), in percent of the maximum
    resistive_linear_effort_x: 0..100 percent, optional. Braking effort along X, in percent of the maximum
    resistive_linear_effort_y: 0..100 percent, optional. Braking effort along Y, in percent of the maximum
    resistive_linear_effort_z: 0..100 percent, optional. Braking effort along Z, in percent of the maximum
    resistive_rotational_effort_x: 0..100 percent, optional. Braking effort about X, in percent of the maximum
    resistive_rotational_effort_y: 0..100 percent, optional. Braking effort about Y, in percent of the maximum
    resistive_rotational_effort_z: 0..100 percent, optional. Braking effort about Z, in percent of the maximum
    """
    propulsive_linear_effort_x: float | None = jd.field("PropulsiveLinearEffortX", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_linear_effort_y: float | None = jd.field("PropulsiveLinearEffortY", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_linear_effort_z: float | None = jd.field("PropulsiveLinearEffortZ", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_x: float | None = jd.field("PropulsiveRotationalEffortX", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_y: float | None = jd.field("PropulsiveRotationalEffortY", jd.real("H", -100.0, 100.0, "percent"), default=None)
    propulsive_rotational_effort_z: float | None = jd.field("PropulsiveRotationalEffortZ", jd.real("H", -100.0, 100.0, "percent"), default=None)
    resistive_linear_effort_x: float | None = jd.field("ResistiveLinearEffortX", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_linear_effort_y: float | None = jd.field("ResistiveLinearEffortY", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_linear_effort_z: float | None = jd.field("ResistiveLinearEffortZ", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_x: float | None = jd.field("ResistiveRotationalEffortX", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_y: float | None = jd.field("ResistiveRotationalEffortY", jd.real("B", 0.0, 100.0, "percent"), default=None)
    resistive_rotational_effort_z: float | None = jd.field("ResistiveRotationalEffortZ", jd.real("B", 0.0, 100.0, "percent"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2405, query=True)
class QueryWrenchEffort(jd.Message):
    """QueryWrenchEffort (0x2405): Asks for the efforts in use.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportWrenchEffort
    presence_vector: int = jd.field("PresenceVector", jd.Number("H"), default=0xFFF)
