"""urn:jaus:jss:iop:PathReporter 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types


@dataclass(slots=True, repr=False)
class QueryPathReporterCapabilities(rt.Message):
    """QueryPathReporterCapabilities (0xDEF0): Asks which paths can be reported."""

    CODE = 0xDEF0
    NAME = "QueryPathReporterCapabilities"
    SERVICE = "urn:jaus:jss:iop:PathReporter"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPathReporterCapabilities]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\xf0\xde': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xDEF0)


@dataclass(slots=True, repr=False)
class QueryPath(rt.Message):
    """QueryPath (0xDEF1): Asks for a path.

    path_type: PathType. Whether the path was travelled or is planned, and its frame
    target_resolution: 0..10000 meter, optional. Wanted distance of points, in metres
    maximum_points: optional. Largest number of points
    maximum_distance: in meter, optional. Largest length of the path, in metres
    maximum_time: in second, optional. Longest time that the path covers, in seconds
    """

    CODE = 0xDEF1
    NAME = "QueryPath"
    SERVICE = "urn:jaus:jss:iop:PathReporter"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPath]]

    class PathType(IntEnum):
        """Values of PathType."""

        HISTORICAL_GLOBAL_PATH = 0
        HISTORICAL_LOCAL_PATH = 1
        PLANNED_GLOBAL_PATH = 2
        PLANNED_LOCAL_PATH = 3

    path_type: QueryPath.PathType | int
    target_resolution: float | None = None
    maximum_points: int | None = None
    maximum_distance: int | None = None
    maximum_time: int | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("PathType", rt.Number("B", rt.Values(QueryPath.PathType))),
            ("TargetResolution", rt.real("H", 0.0, 10000.0, "meter"), True),
            ("MaximumPoints", rt.Number("H"), True),
            ("MaximumDistance", rt.Number("I", rt.ANY, "meter"), True),
            ("MaximumTime", rt.Number("I", rt.ANY, "second"), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        code, mask = _S_HB.unpack_from(data)
        if code != 0xDEF1: raise rt.Reject
        raw = iter(_M_QueryPath[mask & 0xF].unpack(data)).__next__
        self = rt.new(cls)
        path_type_ = raw()
        self.path_type = _E_QueryPath_PathType[path_type_]
        self.target_resolution = raw() * 0.15259021896696423 if mask & 1 else None
        self.maximum_points = raw() if mask & 2 else None
        self.maximum_distance = raw() if mask & 4 else None
        self.maximum_time = raw() if mask & 8 else None
        self.reserved_presence = mask & 0xF0
        return self

    def _pack(self) -> bytes:
        mask = self.reserved_presence
        if mask & 0xF: raise rt.Reject
        raw: list[int | float | bytes] = []
        path_type_ = self.path_type
        if path_type_ not in _E_QueryPath_PathType: raise rt.Reject
        raw.append(path_type_)
        target_resolution_ = self.target_resolution
        if target_resolution_ is not None:
            mask |= 1
            if not 0.0 <= target_resolution_ <= 10000.0: raise rt.Reject
            near = target_resolution_ * 6.5535 + 0.5
            target_resolution_raw_ = int(near)
            if not 1.52587890625e-05 < near - target_resolution_raw_ < 0.9999847412109375: target_resolution_raw_ = rt.exact_raw(target_resolution_, _R_4)
            raw.append(target_resolution_raw_)
        maximum_points_ = self.maximum_points
        if maximum_points_ is not None:
            mask |= 2
            raw.append(maximum_points_)
        maximum_distance_ = self.maximum_distance
        if maximum_distance_ is not None:
            mask |= 4
            raw.append(maximum_distance_)
        maximum_time_ = self.maximum_time
        if maximum_time_ is not None:
            mask |= 8
            raw.append(maximum_time_)
        return _M_QueryPath_pack[mask & 0xF].pack(0xDEF1, mask, *raw)


@dataclass(slots=True, repr=False)
class ReportPathReporterCapabilities(rt.Message):
    """ReportPathReporterCapabilities (0xDEF2): Tells which paths can be reported.

    path_reporter_capabilities_list: 0..255 items. The kinds of path
    """

    CODE = 0xDEF2
    NAME = "ReportPathReporterCapabilities"
    SERVICE = "urn:jaus:jss:iop:PathReporter"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    PathReporterCapabilitiesRec = iop_v1_0_types.PathReporterCapabilitiesRec

    path_reporter_capabilities_list: list[iop_v1_0_types.PathReporterCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PathReporterCapabilitiesList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.PathReporterCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF2 or data[1] != 0xDE: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        path_reporter_capabilities_list_count_ = data[2]
        if path_reporter_capabilities_list_count_ * 2 > size - 3: raise rt.Reject
        at = 3
        path_reporter_capabilities_list_ = []
        for _ in range(path_reporter_capabilities_list_count_):
            item_, at = iop_v1_0_types.PathReporterCapabilitiesRec._read(data, at, nesting)
            path_reporter_capabilities_list_.append(item_)
        self.path_reporter_capabilities_list = path_reporter_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf2\xde")
        path_reporter_capabilities_list_ = self.path_reporter_capabilities_list
        if type(path_reporter_capabilities_list_) is not list: raise rt.Reject
        out.append(len(path_reporter_capabilities_list_))
        for item_ in path_reporter_capabilities_list_:
            if type(item_) is not iop_v1_0_types.PathReporterCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportPath(rt.Message):
    """ReportPath (0xDEF3): Tells a path.

    path_var: The points, in the order of travel
    """

    CODE = 0xDEF3
    NAME = "ReportPath"
    SERVICE = "urn:jaus:jss:iop:PathReporter"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    GlobalPoseRec = mobility_v1_0_types.GlobalPoseRec
    LocalPoseRec = mobility_v1_0_types.LocalPoseRec

    @dataclass(slots=True, repr=False)
    class HistoricalGlobalPath(rt.Struct):
        """The path travelled, on the globe.

        historical_global_path: 0..65535 items. The path travelled, on the globe
        """

        historical_global_path: list[mobility_v1_0_types.GlobalPoseRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HistoricalGlobalPath", rt.Repeat(rt.Count("H", 0, 65535), mobility_v1_0_types.GlobalPoseRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            (historical_global_path_count_,) = _S_H.unpack_from(data, at)
            if historical_global_path_count_ * 2 > size - (at + 2): raise rt.Reject
            at += 2
            historical_global_path_ = []
            for _ in range(historical_global_path_count_):
                item_, at = mobility_v1_0_types.GlobalPoseRec._read(data, at, nesting)
                historical_global_path_.append(item_)
            self.historical_global_path = historical_global_path_
            return self, at

        def _write(self, out: bytearray) -> None:
            historical_global_path_ = self.historical_global_path
            if type(historical_global_path_) is not list: raise rt.Reject
            out += _S_H.pack(len(historical_global_path_))
            for item_ in historical_global_path_:
                if type(item_) is not mobility_v1_0_types.GlobalPoseRec: raise rt.Reject
                item_._write(out)

    @dataclass(slots=True, repr=False)
    class HistoricalLocalPath(rt.Struct):
        """The path travelled, in the local frame.

        historical_local_path: 0..65535 items. The path travelled, in the local frame
        """

        historical_local_path: list[mobility_v1_0_types.LocalPoseRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("HistoricalLocalPath", rt.Repeat(rt.Count("H", 0, 65535), mobility_v1_0_types.LocalPoseRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            (historical_local_path_count_,) = _S_H.unpack_from(data, at)
            if historical_local_path_count_ * 2 > size - (at + 2): raise rt.Reject
            at += 2
            historical_local_path_ = []
            for _ in range(historical_local_path_count_):
                item_, at = mobility_v1_0_types.LocalPoseRec._read(data, at, nesting)
                historical_local_path_.append(item_)
            self.historical_local_path = historical_local_path_
            return self, at

        def _write(self, out: bytearray) -> None:
            historical_local_path_ = self.historical_local_path
            if type(historical_local_path_) is not list: raise rt.Reject
            out += _S_H.pack(len(historical_local_path_))
            for item_ in historical_local_path_:
                if type(item_) is not mobility_v1_0_types.LocalPoseRec: raise rt.Reject
                item_._write(out)

    @dataclass(slots=True, repr=False)
    class PlannedGlobalPath(rt.Struct):
        """The path planned, on the globe.

        planned_global_path: 0..65535 items. The path planned, on the globe
        """

        planned_global_path: list[mobility_v1_0_types.GlobalPoseRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PlannedGlobalPath", rt.Repeat(rt.Count("H", 0, 65535), mobility_v1_0_types.GlobalPoseRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            (planned_global_path_count_,) = _S_H.unpack_from(data, at)
            if planned_global_path_count_ * 2 > size - (at + 2): raise rt.Reject
            at += 2
            planned_global_path_ = []
            for _ in range(planned_global_path_count_):
                item_, at = mobility_v1_0_types.GlobalPoseRec._read(data, at, nesting)
                planned_global_path_.append(item_)
            self.planned_global_path = planned_global_path_
            return self, at

        def _write(self, out: bytearray) -> None:
            planned_global_path_ = self.planned_global_path
            if type(planned_global_path_) is not list: raise rt.Reject
            out += _S_H.pack(len(planned_global_path_))
            for item_ in planned_global_path_:
                if type(item_) is not mobility_v1_0_types.GlobalPoseRec: raise rt.Reject
                item_._write(out)

    @dataclass(slots=True, repr=False)
    class PlannedLocalPath(rt.Struct):
        """The path planned, in the local frame.

        planned_local_path: 0..65535 items. The path planned, in the local frame
        """

        planned_local_path: list[mobility_v1_0_types.LocalPoseRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PlannedLocalPath", rt.Repeat(rt.Count("H", 0, 65535), mobility_v1_0_types.LocalPoseRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            (planned_local_path_count_,) = _S_H.unpack_from(data, at)
            if planned_local_path_count_ * 2 > size - (at + 2): raise rt.Reject
            at += 2
            planned_local_path_ = []
            for _ in range(planned_local_path_count_):
                item_, at = mobility_v1_0_types.LocalPoseRec._read(data, at, nesting)
                planned_local_path_.append(item_)
            self.planned_local_path = planned_local_path_
            return self, at

        def _write(self, out: bytearray) -> None:
            planned_local_path_ = self.planned_local_path
            if type(planned_local_path_) is not list: raise rt.Reject
            out += _S_H.pack(len(planned_local_path_))
            for item_ in planned_local_path_:
                if type(item_) is not mobility_v1_0_types.LocalPoseRec: raise rt.Reject
                item_._write(out)

    path_var: ReportPath.HistoricalGlobalPath | ReportPath.HistoricalLocalPath | ReportPath.PlannedGlobalPath | ReportPath.PlannedLocalPath

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PathVar", rt.Union.of("B", historical_global_path=ReportPath.HistoricalGlobalPath, historical_local_path=ReportPath.HistoricalLocalPath, planned_global_path=ReportPath.PlannedGlobalPath, planned_local_path=ReportPath.PlannedLocalPath)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0xF3 or data[1] != 0xDE: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        tag = data[2]
        at = 3
        self.path_var, at = _U_6[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\xf3\xde")
        path_var_ = self.path_var
        out.append(_T_7[type(path_var_)])
        path_var_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_HB = rt.Packer("<HB")
_M_QueryPath = rt.Masks("3x", ((0, "B"), (1, "H"), (2, "H"), (4, "I"), (8, "I")))
_E_QueryPath_PathType = rt.members(QueryPath.PathType)
_R_4 = rt.Scaling(0.0, 10000.0, 65535)
_M_QueryPath_pack = rt.Masks("HB", ((0, "B"), (1, "H"), (2, "H"), (4, "I"), (8, "I")))
_U_6: tuple[type[ReportPath.HistoricalGlobalPath] | type[ReportPath.HistoricalLocalPath] | type[ReportPath.PlannedGlobalPath] | type[ReportPath.PlannedLocalPath], ...] = (ReportPath.HistoricalGlobalPath, ReportPath.HistoricalLocalPath, ReportPath.PlannedGlobalPath, ReportPath.PlannedLocalPath)
_T_7: dict[type[rt.Struct], int] = {ReportPath.HistoricalGlobalPath: 0, ReportPath.HistoricalLocalPath: 1, ReportPath.PlannedGlobalPath: 2, ReportPath.PlannedLocalPath: 3}
QueryPathReporterCapabilities.REPORT = ReportPathReporterCapabilities
QueryPath.REPORT = ReportPath
