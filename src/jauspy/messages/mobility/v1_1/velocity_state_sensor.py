"""urn:jaus:jss:mobility:VelocityStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_0 import velocity_state_sensor as mobility_v1_0_velocity_state_sensor

_SERVICE = jd.Service("urn:jaus:jss:mobility:VelocityStateSensor", "1.1")

@jd.derived(_SERVICE)
class ReportVelocityState(mobility_v1_0_velocity_state_sensor.ReportVelocityState): ...

@jd.derived(_SERVICE)
class QueryVelocityState(mobility_v1_0_velocity_state_sensor.QueryVelocityState):
    REPORT = ReportVelocityState


@jd.message(_SERVICE, 0x44A4)
class ReportVelocityStateExt(jd.Message):
    """ReportVelocityStateExt (0x44A4): Tells the velocity in one of three frames, with speeds and shaft rotation.

    velocity_var: Velocity and its frame
    report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
    """
    VelocityVehicleXYZRec = mobility_v1_0_types.VelocityVehicleXYZRec
    VelocityLocalXYZRec = mobility_v1_0_types.VelocityLocalXYZRec
    VelocityNEDRec = mobility_v1_0_types.VelocityNEDRec
    ReportVelocityStateExtRec = mobility_v1_0_types.ReportVelocityStateExtRec
    velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec = jd.field("VelocityVar", lambda: jd.Union.of("B", velocity_vehicle_xyz_rec=mobility_v1_0_types.VelocityVehicleXYZRec, velocity_local_xyz_rec=mobility_v1_0_types.VelocityLocalXYZRec, velocity_ned_rec=mobility_v1_0_types.VelocityNEDRec))
    report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec = jd.field("ReportVelocityStateExtRec", lambda: mobility_v1_0_types.ReportVelocityStateExtRec.layout())


@jd.message(_SERVICE, 0x24A4, query=True)
class QueryVelocityStateExt(jd.Message):
    """QueryVelocityStateExt (0x24A4): Asks for the velocity in its wider form.

    velocity_var_presence_vector: Which velocity components the report is to have, by bit
    report_velocity_state_ext_rec_presence_vector: Which other fields the report is to have, by bit
    """
    REPORT = ReportVelocityStateExt
    velocity_var_presence_vector: int = jd.field("VelocityVarPresenceVector", jd.Number("B"))
    report_velocity_state_ext_rec_presence_vector: int = jd.field("ReportVelocityStateExtRecPresenceVector", jd.Number("H"))
