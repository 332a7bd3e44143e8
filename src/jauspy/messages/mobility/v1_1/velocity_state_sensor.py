"""urn:jaus:jss:mobility:VelocityStateSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_0 import velocity_state_sensor as mobility_v1_0_velocity_state_sensor


class QueryVelocityState(mobility_v1_0_velocity_state_sensor.QueryVelocityState):
    """QueryVelocityState (0x2404): Asks for the velocity."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportVelocityState]]


@dataclass(slots=True, repr=False)
class QueryVelocityStateExt(rt.Message):
    """QueryVelocityStateExt (0x24A4): Asks for the velocity in its wider form.

    velocity_var_presence_vector: Which velocity components the report is to have, by bit
    report_velocity_state_ext_rec_presence_vector: Which other fields the report is to have, by bit
    """

    CODE = 0x24A4
    NAME = "QueryVelocityStateExt"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportVelocityStateExt]]

    velocity_var_presence_vector: int
    report_velocity_state_ext_rec_presence_vector: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("VelocityVarPresenceVector", rt.Number("B")),
            ("ReportVelocityStateExtRecPresenceVector", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.velocity_var_presence_vector, self.report_velocity_state_ext_rec_presence_vector = _S_HBH.unpack(data)
        if code != 0x24A4: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HBH.pack(0x24A4, self.velocity_var_presence_vector, self.report_velocity_state_ext_rec_presence_vector)


class ReportVelocityState(mobility_v1_0_velocity_state_sensor.ReportVelocityState):
    """ReportVelocityState (0x4404): Tells the velocity."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ReportVelocityStateExt(rt.Message):
    """ReportVelocityStateExt (0x44A4): Tells the velocity in one of three frames, with speeds and shaft rotation.

    velocity_var: Velocity and its frame
    report_velocity_state_ext_rec: Angular velocity, speeds and time of the measurement
    """

    CODE = 0x44A4
    NAME = "ReportVelocityStateExt"
    SERVICE = "urn:jaus:jss:mobility:VelocityStateSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    VelocityVehicleXYZRec = mobility_v1_0_types.VelocityVehicleXYZRec
    VelocityLocalXYZRec = mobility_v1_0_types.VelocityLocalXYZRec
    VelocityNEDRec = mobility_v1_0_types.VelocityNEDRec
    ReportVelocityStateExtRec = mobility_v1_0_types.ReportVelocityStateExtRec

    velocity_var: mobility_v1_0_types.VelocityVehicleXYZRec | mobility_v1_0_types.VelocityLocalXYZRec | mobility_v1_0_types.VelocityNEDRec
    report_velocity_state_ext_rec: mobility_v1_0_types.ReportVelocityStateExtRec

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("VelocityVar", rt.Union.of("B", velocity_vehicle_xyz_rec=mobility_v1_0_types.VelocityVehicleXYZRec, velocity_local_xyz_rec=mobility_v1_0_types.VelocityLocalXYZRec, velocity_ned_rec=mobility_v1_0_types.VelocityNEDRec)),
            ("ReportVelocityStateExtRec", mobility_v1_0_types.ReportVelocityStateExtRec.layout()),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xA4 or data[1] != 0x44: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        tag = data[2]
        at = 3
        self.velocity_var, at = _U_1[tag]._read(data, at, nesting)
        self.report_velocity_state_ext_rec, at = mobility_v1_0_types.ReportVelocityStateExtRec._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xa4\x44")
        velocity_var_ = self.velocity_var
        out.append(_T_2[type(velocity_var_)])
        velocity_var_._write(out)
        report_velocity_state_ext_rec_ = self.report_velocity_state_ext_rec
        if type(report_velocity_state_ext_rec_) is not mobility_v1_0_types.ReportVelocityStateExtRec: raise rt.Reject
        report_velocity_state_ext_rec_._write(out)
        return bytes(out)


_S_HBH = rt.Packer("<HBH")
_U_1: tuple[type[mobility_v1_0_types.VelocityVehicleXYZRec] | type[mobility_v1_0_types.VelocityLocalXYZRec] | type[mobility_v1_0_types.VelocityNEDRec], ...] = (mobility_v1_0_types.VelocityVehicleXYZRec, mobility_v1_0_types.VelocityLocalXYZRec, mobility_v1_0_types.VelocityNEDRec)
_T_2: dict[type[rt.Struct], int] = {mobility_v1_0_types.VelocityVehicleXYZRec: 0, mobility_v1_0_types.VelocityLocalXYZRec: 1, mobility_v1_0_types.VelocityNEDRec: 2}
QueryVelocityState.REPORT = ReportVelocityState
QueryVelocityStateExt.REPORT = ReportVelocityStateExt
