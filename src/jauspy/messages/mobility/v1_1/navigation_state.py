"""urn:jaus:jss:mobility:NavigationState 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:NavigationState", "1.1")


@jd.message(_SERVICE, 0x4421)
class ReportNavigation(jd.Message):
    """ReportNavigation (0x4421): Tells pose, velocity and acceleration taken at one time.

    report_global_pose_ext_rec: A pose on the globe with several vertical datums
    report_local_pose_ext_rec: A pose in the local frame with several vertical datums
    report_acceleration_state_ext_rec: Acceleration in the platform frame and time of the measurement
    """
    ReportGlobalPoseExtRec = mobility_v1_0_types.ReportGlobalPoseExtRec
    ReportLocalPoseExtRec = mobility_v1_0_types.ReportLocalPoseExtRec
    VelocityVehicleXYZRec = mobility_v1_0_types.VelocityVehicleXYZRec
    VelocityLocalXYZRec = mobility_v1_0_types.VelocityLocalXYZRec
    VelocityNEDRec = mobility_v1_0_types.VelocityNEDRec
    ReportVelocityStateExtRec = mobility_v1_0_types.ReportVelocityStateExtRec
    ReportAccelerationStateExtRec = mobility_v1_0_types.ReportAccelerationStateExtRec

    @jd.record()
    class SyncTimeRec(jd.Struct):
        """time_seconds: in second. Time of the measurement: whole seconds
        time_nano_seconds: Time of the measurement: nanoseconds of the second
        """
        time_seconds: int = jd.field("TimeSeconds", jd.Number("I", jd.ANY, "second"))
        time_nano_seconds: int = jd.field("TimeNanoSeconds", jd.Number("I"))

    @jd.record()
    class ReportVelocityStateExtSeq(jd.Struct):
        """velocity_var: Velocity and its frame
        report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
        """
        velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec = jd.field("VelocityVar", lambda: jd.Union.of("B", velocity_vehicle_xyz_rec=mobility_v1_0_types.VelocityVehicleXYZRec, velocity_local_xyz_rec=mobility_v1_0_types.VelocityLocalXYZRec, velocity_ned_rec=mobility_v1_0_types.VelocityNEDRec))
        report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec = jd.field("ReportVelocityStateExtRec", lambda: mobility_v1_0_types.ReportVelocityStateExtRec.layout())

    sync_time_rec: ReportNavigation.SyncTimeRec = jd.field("SyncTimeRec", lambda: ReportNavigation.SyncTimeRec.layout())
    report_global_pose_ext_rec: mobility_v1_0_types.ReportGlobalPoseExtRec = jd.field("ReportGlobalPoseExtRec", lambda: mobility_v1_0_types.ReportGlobalPoseExtRec.layout())
    report_local_pose_ext_rec: mobility_v1_0_types.ReportLocalPoseExtRec = jd.field("ReportLocalPoseExtRec", lambda: mobility_v1_0_types.ReportLocalPoseExtRec.layout())
    report_velocity_state_ext_seq: ReportNavigation.ReportVelocityStateExtSeq = jd.field("ReportVelocityStateExtSeq", lambda: ReportNavigation.ReportVelocityStateExtSeq.layout())
    report_acceleration_state_ext_rec: mobility_v1_0_types.ReportAccelerationStateExtRec = jd.field("ReportAccelerationStateExtRec", lambda: mobility_v1_0_types.ReportAccelerationStateExtRec.layout())


@jd.message(_SERVICE, 0x2421, query=True)
class QueryNavigation(jd.Message):
    """QueryNavigation (0x2421): Asks for pose, velocity and acceleration in one report.

    global_pose_presence_vector: Which fields of the pose on the globe the report is to have, by bit
    local_pose_presence_vector: Which fields of the local pose the report is to have, by bit
    velocity_state_presence_vector: Which fields of velocity the report is to have, by bit
    acceleration_state_presence_vector: Which fields of acceleration the report is to have, by bit
    """
    REPORT = ReportNavigation
    global_pose_presence_vector: int = jd.field("GlobalPosePresenceVector", jd.Number("H"))
    local_pose_presence_vector: int = jd.field("LocalPosePresenceVector", jd.Number("H"))
    velocity_state_presence_vector: int = jd.field("VelocityStatePresenceVector", jd.Number("H"))
    acceleration_state_presence_vector: int = jd.field("AccelerationStatePresenceVector", jd.Number("H"))
