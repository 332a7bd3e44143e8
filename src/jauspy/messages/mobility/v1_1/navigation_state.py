"""urn:jaus:jss:mobility:NavigationState 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class QueryNavigation(rt.Message):
    """QueryNavigation (0x2421): Asks for pose, velocity and acceleration in one report.

    global_pose_presence_vector: Which fields of the pose on the globe the report is to have, by bit
    local_pose_presence_vector: Which fields of the local pose the report is to have, by bit
    velocity_state_presence_vector: Which fields of velocity the report is to have, by bit
    acceleration_state_presence_vector: Which fields of acceleration the report is to have, by bit
    """

    CODE = 0x2421
    NAME = "QueryNavigation"
    SERVICE = "urn:jaus:jss:mobility:NavigationState"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportNavigation]]

    global_pose_presence_vector: int
    local_pose_presence_vector: int
    velocity_state_presence_vector: int
    acceleration_state_presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("GlobalPosePresenceVector", rt.Number("H")),
            ("LocalPosePresenceVector", rt.Number("H")),
            ("VelocityStatePresenceVector", rt.Number("H")),
            ("AccelerationStatePresenceVector", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.global_pose_presence_vector, self.local_pose_presence_vector, self.velocity_state_presence_vector, self.acceleration_state_presence_vector = _S_5H.unpack(data)
        if code != 0x2421: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_5H.pack(0x2421, self.global_pose_presence_vector, self.local_pose_presence_vector, self.velocity_state_presence_vector, self.acceleration_state_presence_vector)


@dataclass(slots=True, repr=False)
class ReportNavigation(rt.Message):
    """ReportNavigation (0x4421): Tells pose, velocity and acceleration taken at one time.

    report_global_pose_ext_rec: A pose on the globe with several vertical datums
    report_local_pose_ext_rec: A pose in the local frame with several vertical datums
    report_acceleration_state_ext_rec: Acceleration in the platform frame and time of the measurement
    """

    CODE = 0x4421
    NAME = "ReportNavigation"
    SERVICE = "urn:jaus:jss:mobility:NavigationState"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ReportGlobalPoseExtRec = mobility_v1_0_types.ReportGlobalPoseExtRec
    ReportLocalPoseExtRec = mobility_v1_0_types.ReportLocalPoseExtRec
    VelocityVehicleXYZRec = mobility_v1_0_types.VelocityVehicleXYZRec
    VelocityLocalXYZRec = mobility_v1_0_types.VelocityLocalXYZRec
    VelocityNEDRec = mobility_v1_0_types.VelocityNEDRec
    ReportVelocityStateExtRec = mobility_v1_0_types.ReportVelocityStateExtRec
    ReportAccelerationStateExtRec = mobility_v1_0_types.ReportAccelerationStateExtRec

    @dataclass(slots=True, repr=False)
    class SyncTimeRec(rt.Struct):
        """SyncTimeRec.

        time_seconds: in second. Time of the measurement: whole seconds
        time_nano_seconds: Time of the measurement: nanoseconds of the second
        """

        time_seconds: int
        time_nano_seconds: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TimeSeconds", rt.Number("I", rt.ANY, "second")),
                ("TimeNanoSeconds", rt.Number("I")),
            )

    @dataclass(slots=True, repr=False)
    class ReportVelocityStateExtSeq(rt.Struct):
        """ReportVelocityStateExtSeq.

        velocity_var: Velocity and its frame
        report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
        """

        velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec
        report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("VelocityVar", rt.Union.of("B", velocity_vehicle_xyz_rec=mobility_v1_0_types.VelocityVehicleXYZRec, velocity_local_xyz_rec=mobility_v1_0_types.VelocityLocalXYZRec, velocity_ned_rec=mobility_v1_0_types.VelocityNEDRec)),
                ("ReportVelocityStateExtRec", mobility_v1_0_types.ReportVelocityStateExtRec.layout()),
            )

    sync_time_rec: ReportNavigation.SyncTimeRec
    report_global_pose_ext_rec: mobility_v1_0_types.ReportGlobalPoseExtRec
    report_local_pose_ext_rec: mobility_v1_0_types.ReportLocalPoseExtRec
    report_velocity_state_ext_seq: ReportNavigation.ReportVelocityStateExtSeq
    report_acceleration_state_ext_rec: mobility_v1_0_types.ReportAccelerationStateExtRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SyncTimeRec", ReportNavigation.SyncTimeRec.layout()),
            ("ReportGlobalPoseExtRec", mobility_v1_0_types.ReportGlobalPoseExtRec.layout()),
            ("ReportLocalPoseExtRec", mobility_v1_0_types.ReportLocalPoseExtRec.layout()),
            ("ReportVelocityStateExtSeq", ReportNavigation.ReportVelocityStateExtSeq.layout()),
            ("ReportAccelerationStateExtRec", mobility_v1_0_types.ReportAccelerationStateExtRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x21 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        time_seconds_, time_nano_seconds_ = _S_2I.unpack_from(data, 2)
        self.sync_time_rec = ReportNavigation.SyncTimeRec(time_seconds_, time_nano_seconds_)
        at = 10
        self.report_global_pose_ext_rec, at = mobility_v1_0_types.ReportGlobalPoseExtRec._read(data, at, nesting)
        self.report_local_pose_ext_rec, at = mobility_v1_0_types.ReportLocalPoseExtRec._read(data, at, nesting)
        self.report_velocity_state_ext_seq = report_velocity_state_ext_seq_ = rt.new(ReportNavigation.ReportVelocityStateExtSeq)
        tag = data[at]
        at += 1
        report_velocity_state_ext_seq_.velocity_var, at = _U_2[tag]._read(data, at, nesting)
        report_velocity_state_ext_seq_.report_velocity_state_ext_rec, at = mobility_v1_0_types.ReportVelocityStateExtRec._read(data, at, nesting)
        self.report_acceleration_state_ext_rec, at = mobility_v1_0_types.ReportAccelerationStateExtRec._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x21\x44")
        sync_time_rec_ = self.sync_time_rec
        if type(sync_time_rec_) is not ReportNavigation.SyncTimeRec: raise rt.Reject
        out += _S_2I.pack(sync_time_rec_.time_seconds, sync_time_rec_.time_nano_seconds)
        report_global_pose_ext_rec_ = self.report_global_pose_ext_rec
        if type(report_global_pose_ext_rec_) is not mobility_v1_0_types.ReportGlobalPoseExtRec: raise rt.Reject
        report_global_pose_ext_rec_._write(out)
        report_local_pose_ext_rec_ = self.report_local_pose_ext_rec
        if type(report_local_pose_ext_rec_) is not mobility_v1_0_types.ReportLocalPoseExtRec: raise rt.Reject
        report_local_pose_ext_rec_._write(out)
        report_velocity_state_ext_seq_ = self.report_velocity_state_ext_seq
        if type(report_velocity_state_ext_seq_) is not ReportNavigation.ReportVelocityStateExtSeq: raise rt.Reject
        velocity_var_ = report_velocity_state_ext_seq_.velocity_var
        out.append(_T_3[type(velocity_var_)])
        velocity_var_._write(out)
        report_velocity_state_ext_rec_ = report_velocity_state_ext_seq_.report_velocity_state_ext_rec
        if type(report_velocity_state_ext_rec_) is not mobility_v1_0_types.ReportVelocityStateExtRec: raise rt.Reject
        report_velocity_state_ext_rec_._write(out)
        report_acceleration_state_ext_rec_ = self.report_acceleration_state_ext_rec
        if type(report_acceleration_state_ext_rec_) is not mobility_v1_0_types.ReportAccelerationStateExtRec: raise rt.Reject
        report_acceleration_state_ext_rec_._write(out)
        return bytes(out)


_S_5H = rt.Packer("<5H")
_S_2I = rt.Packer("<2I")
_U_2: tuple[type[mobility_v1_0_types.VelocityVehicleXYZRec] | type[mobility_v1_0_types.VelocityLocalXYZRec] | type[mobility_v1_0_types.VelocityNEDRec], ...] = (mobility_v1_0_types.VelocityVehicleXYZRec, mobility_v1_0_types.VelocityLocalXYZRec, mobility_v1_0_types.VelocityNEDRec)
_T_3: dict[type[rt.Struct], int] = {mobility_v1_0_types.VelocityVehicleXYZRec: 0, mobility_v1_0_types.VelocityLocalXYZRec: 1, mobility_v1_0_types.VelocityNEDRec: 2}
QueryNavigation.REPORT = ReportNavigation
