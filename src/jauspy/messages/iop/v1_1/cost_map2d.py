"""urn:jaus:jss:iop:CostMap2D 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types


@dataclass(slots=True, repr=False)
class QueryCostMap2D(rt.Message):
    """QueryCostMap2D (0xD738): Asks for the map of an area.

    query_cost_map2d_rec: optional. Size of the wanted map
    query_cost_map2d_center_var: optional. Middle of the wanted map, on the globe or in the local frame
    """

    CODE = 0xD738
    NAME = "QueryCostMap2D"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportCostMap2D]]

    QueryCostMap2DRec = iop_v1_0_types.QueryCostMap2DRec
    CostMap2DGlobalPoseRec = iop_v1_0_types.CostMap2DGlobalPoseRec
    CostMap2DLocalPoseRec = iop_v1_0_types.CostMap2DLocalPoseRec

    query_cost_map2d_rec: iop_v1_0_types.QueryCostMap2DRec | None = None
    query_cost_map2d_center_var: iop_v1_0_types.CostMap2DGlobalPoseRec | iop_v1_0_types.CostMap2DLocalPoseRec | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("QueryCostMap2DRec", iop_v1_0_types.QueryCostMap2DRec.layout(), True),
            ("QueryCostMap2DCenterVar", rt.Union.of("B", cost_map2d_global_pose_rec=iop_v1_0_types.CostMap2DGlobalPoseRec, cost_map2d_local_pose_rec=iop_v1_0_types.CostMap2DLocalPoseRec), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x38 or data[1] != 0xD7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        if mask & 1:
            max_width_, max_height_ = _S_2H.unpack_from(data, at)
            self.query_cost_map2d_rec = iop_v1_0_types.QueryCostMap2DRec(max_width_ * 0.15259021896696423, max_height_ * 0.15259021896696423)
            at += 4
        else: self.query_cost_map2d_rec = None
        if mask & 2:
            tag = data[at]
            at += 1
            self.query_cost_map2d_center_var, at = _U_1[tag]._read(data, at, nesting)
        else: self.query_cost_map2d_center_var = None
        self.reserved_presence = mask & 0xFC
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x38\xd7")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        query_cost_map2d_rec_ = self.query_cost_map2d_rec
        if query_cost_map2d_rec_ is not None:
            mask |= 1
            if type(query_cost_map2d_rec_) is not iop_v1_0_types.QueryCostMap2DRec: raise rt.Reject
            max_width_ = query_cost_map2d_rec_.max_width
            if not 0.0 <= max_width_ <= 10000.0: raise rt.Reject
            near = max_width_ * 6.5535 + 0.5
            max_width_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_width_raw_ < 0.9999847412109375: max_width_raw_ = rt.exact_raw(max_width_, _R_2)
            max_height_ = query_cost_map2d_rec_.max_height
            if not 0.0 <= max_height_ <= 10000.0: raise rt.Reject
            near = max_height_ * 6.5535 + 0.5
            max_height_raw_ = int(near)
            if not 1.52587890625e-05 < near - max_height_raw_ < 0.9999847412109375: max_height_raw_ = rt.exact_raw(max_height_, _R_2)
            out += _S_2H.pack(max_width_raw_, max_height_raw_)
        query_cost_map2d_center_var_ = self.query_cost_map2d_center_var
        if query_cost_map2d_center_var_ is not None:
            mask |= 2
            out.append(_T_3[type(query_cost_map2d_center_var_)])
            query_cost_map2d_center_var_._write(out)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryNoGoZones(rt.Message):
    """QueryNoGoZones (0xD739): Asks for the zones that must not be entered.

    zone_id: Number of the zone
    """

    CODE = 0xD739
    NAME = "QueryNoGoZones"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportNoGoZones]]

    zone_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ZoneID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.zone_id = _S_2H.unpack(data)
        if code != 0xD739: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0xD739, self.zone_id)


@dataclass(slots=True, repr=False)
class AddNoGoZone(rt.Message):
    """AddNoGoZone (0xD740): Adds a zone that must not be entered.

    request_id_rec: The number of the request
    vertex_var: Corners, on the globe or in the local frame
    """

    CODE = 0xD740
    NAME = "AddNoGoZone"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    GlobalVertexRec = iop_v1_0_types.GlobalVertexRec
    LocalVertexRec = iop_v1_0_types.LocalVertexRec

    @dataclass(slots=True, repr=False)
    class RequestIDRec(rt.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GlobalVertexList(rt.Struct):
        """Corners on the globe.

        global_vertex_list: 0..255 items. Corners on the globe
        """

        global_vertex_list: list[iop_v1_0_types.GlobalVertexRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GlobalVertexList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.GlobalVertexRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            global_vertex_list_count_ = data[at]
            global_vertex_list_end_ = at + 1 + global_vertex_list_count_ * 8
            self.global_vertex_list = [iop_v1_0_types.GlobalVertexRec(-90.0 + latitude_ * 4.190951586745435e-08, -180.0 + longitude_ * 8.38190317349087e-08) for latitude_, longitude_ in _S_2I.iter_unpack(data[at + 1:global_vertex_list_end_])]
            return self, global_vertex_list_end_

        def _write(self, out: bytearray) -> None:
            global_vertex_list_ = self.global_vertex_list
            if type(global_vertex_list_) is not list: raise rt.Reject
            out.append(len(global_vertex_list_))
            raw_: list[int | float] = []
            for item_ in global_vertex_list_:
                if type(item_) is not iop_v1_0_types.GlobalVertexRec: raise rt.Reject
                latitude_ = item_.latitude
                if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
                near = latitude_ * 23860929.416666668 + 2147483648.0
                latitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_6)
                longitude_ = item_.longitude
                if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
                near = longitude_ * 11930464.708333334 + 2147483648.0
                longitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_7)
                raw_ += (latitude_raw_, longitude_raw_)
            out += _L_I[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class LocalVertexList(rt.Struct):
        """Corners in the local frame.

        local_vertex_list: 0..255 items. Corners in the local frame
        """

        local_vertex_list: list[iop_v1_0_types.LocalVertexRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LocalVertexList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.LocalVertexRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            local_vertex_list_count_ = data[at]
            local_vertex_list_end_ = at + 1 + local_vertex_list_count_ * 8
            self.local_vertex_list = [iop_v1_0_types.LocalVertexRec(-100000.0 + x_ * 4.656612874161595e-05, -100000.0 + y_ * 4.656612874161595e-05) for x_, y_ in _S_2I.iter_unpack(data[at + 1:local_vertex_list_end_])]
            return self, local_vertex_list_end_

        def _write(self, out: bytearray) -> None:
            local_vertex_list_ = self.local_vertex_list
            if type(local_vertex_list_) is not list: raise rt.Reject
            out.append(len(local_vertex_list_))
            raw_: list[int | float] = []
            for item_ in local_vertex_list_:
                if type(item_) is not iop_v1_0_types.LocalVertexRec: raise rt.Reject
                x_ = item_.x
                if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
                near = x_ * 21474.836475 + 2147483648.0
                x_raw_ = int(near)
                if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_9)
                y_ = item_.y
                if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
                near = y_ * 21474.836475 + 2147483648.0
                y_raw_ = int(near)
                if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_9)
                raw_ += (x_raw_, y_raw_)
            out += _L_I[len(raw_)].pack(*raw_)

    request_id_rec: AddNoGoZone.RequestIDRec
    vertex_var: AddNoGoZone.GlobalVertexList | AddNoGoZone.LocalVertexList

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIDRec", AddNoGoZone.RequestIDRec.layout()),
            ("VertexVar", rt.Union.of("B", global_vertex_list=AddNoGoZone.GlobalVertexList, local_vertex_list=AddNoGoZone.LocalVertexList)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x40 or data[1] != 0xD7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (request_id_,) = _S_H.unpack_from(data, 2)
        self.request_id_rec = AddNoGoZone.RequestIDRec(request_id_)
        tag = data[4]
        at = 5
        self.vertex_var, at = _U_11[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x40\xd7")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not AddNoGoZone.RequestIDRec: raise rt.Reject
        out += _S_H.pack(request_id_rec_.request_id)
        vertex_var_ = self.vertex_var
        out.append(_T_12[type(vertex_var_)])
        vertex_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class RemoveNoGoZone(rt.Message):
    """RemoveNoGoZone (0xD741): Removes a zone.

    zone_id: Number of the zone
    """

    CODE = 0xD741
    NAME = "RemoveNoGoZone"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    zone_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ZoneID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.zone_id = _S_2H.unpack(data)
        if code != 0xD741: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0xD741, self.zone_id)


@dataclass(slots=True, repr=False)
class ReportCostMap2D(rt.Message):
    """ReportCostMap2D (0xD742): Tells the map of an area.

    cost_map2d_rec: Size of the map
    cost_map2d_pose_var: Middle of the map, on the globe or in the local frame
    cost_map2d_data_var: The cells, row by row: costs, costs with confidence, or runs of equal cost
    """

    CODE = 0xD742
    NAME = "ReportCostMap2D"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    CostMap2DRec = iop_v1_0_types.CostMap2DRec
    CostMap2DGlobalPoseRec = iop_v1_0_types.CostMap2DGlobalPoseRec
    CostMap2DLocalPoseRec = iop_v1_0_types.CostMap2DLocalPoseRec
    CostDataRec = iop_v1_0_types.CostDataRec
    CostAndConfidenceDataRec = iop_v1_0_types.CostAndConfidenceDataRec
    RunLengthEncodedDataRec = iop_v1_0_types.RunLengthEncodedDataRec

    @dataclass(slots=True, repr=False)
    class CostDataList(rt.Struct):
        """The cells.

        cost_data_list: 0..65535 items. The cells
        """

        cost_data_list: list[iop_v1_0_types.CostDataRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("CostDataList", rt.Repeat(rt.Count("H", 0, 65535), iop_v1_0_types.CostDataRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (cost_data_list_count_,) = _S_H.unpack_from(data, at)
            cost_data_list_end_ = at + 2 + cost_data_list_count_ * 1
            self.cost_data_list = [iop_v1_0_types.CostDataRec(cost_) for cost_ in _L_B[cost_data_list_count_].unpack_from(data, at + 2)]
            return self, cost_data_list_end_

        def _write(self, out: bytearray) -> None:
            cost_data_list_ = self.cost_data_list
            if type(cost_data_list_) is not list: raise rt.Reject
            out += _S_H.pack(len(cost_data_list_))
            raw_: list[int | float] = []
            for item_ in cost_data_list_:
                if type(item_) is not iop_v1_0_types.CostDataRec: raise rt.Reject
                raw_.append(item_.cost)
            out += _L_B[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class CostAndConfidenceDataList(rt.Struct):
        """The cells.

        cost_and_confidence_data_list: 0..65535 items. The cells
        """

        cost_and_confidence_data_list: list[iop_v1_0_types.CostAndConfidenceDataRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("CostAndConfidenceDataList", rt.Repeat(rt.Count("H", 0, 65535), iop_v1_0_types.CostAndConfidenceDataRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (cost_and_confidence_data_list_count_,) = _S_H.unpack_from(data, at)
            cost_and_confidence_data_list_end_ = at + 2 + cost_and_confidence_data_list_count_ * 2
            cost_and_confidence_data_list_ = []
            for cost_, confidence_ in _S_2B.iter_unpack(data[at + 2:cost_and_confidence_data_list_end_]):
                if cost_ > 254: raise rt.Reject
                cost_and_confidence_data_list_.append(iop_v1_0_types.CostAndConfidenceDataRec(cost_, confidence_ * 0.39215686274509803))
            self.cost_and_confidence_data_list = cost_and_confidence_data_list_
            return self, cost_and_confidence_data_list_end_

        def _write(self, out: bytearray) -> None:
            cost_and_confidence_data_list_ = self.cost_and_confidence_data_list
            if type(cost_and_confidence_data_list_) is not list: raise rt.Reject
            out += _S_H.pack(len(cost_and_confidence_data_list_))
            raw_: list[int | float] = []
            for item_ in cost_and_confidence_data_list_:
                if type(item_) is not iop_v1_0_types.CostAndConfidenceDataRec: raise rt.Reject
                cost_ = item_.cost
                if not 0 <= cost_ <= 254: raise rt.Reject
                confidence_ = item_.confidence
                if not 0.0 <= confidence_ <= 100.0: raise rt.Reject
                near = confidence_ * 2.55 + 0.5
                confidence_raw_ = int(near)
                if not 1.52587890625e-05 < near - confidence_raw_ < 0.9999847412109375: confidence_raw_ = rt.exact_raw(confidence_, _R_15)
                raw_ += (cost_, confidence_raw_)
            out += _L_B[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class RunLengthEncodedDataList(rt.Struct):
        """The runs.

        run_length_encoded_data_list: 0..65535 items. The runs
        """

        run_length_encoded_data_list: list[iop_v1_0_types.RunLengthEncodedDataRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RunLengthEncodedDataList", rt.Repeat(rt.Count("H", 0, 65535), iop_v1_0_types.RunLengthEncodedDataRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (run_length_encoded_data_list_count_,) = _S_H.unpack_from(data, at)
            run_length_encoded_data_list_end_ = at + 2 + run_length_encoded_data_list_count_ * 2
            self.run_length_encoded_data_list = [iop_v1_0_types.RunLengthEncodedDataRec(iop_v1_0_types.RunLengthEncodedDataRec.CostAndRunLength(cost_and_run_length_ & 0x7, _E_RunLengthEncodedDataRec_CertaintySubField.get(cost_and_run_length_ >> 3 & 0x1, cost_and_run_length_ >> 3 & 0x1), cost_and_run_length_ >> 4 & 0xFFF)) for cost_and_run_length_ in _L_H[run_length_encoded_data_list_count_].unpack_from(data, at + 2)]
            return self, run_length_encoded_data_list_end_

        def _write(self, out: bytearray) -> None:
            run_length_encoded_data_list_ = self.run_length_encoded_data_list
            if type(run_length_encoded_data_list_) is not list: raise rt.Reject
            out += _S_H.pack(len(run_length_encoded_data_list_))
            raw_: list[int | float] = []
            for item_ in run_length_encoded_data_list_:
                if type(item_) is not iop_v1_0_types.RunLengthEncodedDataRec: raise rt.Reject
                cost_and_run_length_ = item_.cost_and_run_length
                if type(cost_and_run_length_) is not iop_v1_0_types.RunLengthEncodedDataRec.CostAndRunLength: raise rt.Reject
                cost_sub_field_ = cost_and_run_length_.cost_sub_field
                if not 0 <= cost_sub_field_ <= 7: raise rt.Reject
                certainty_sub_field_ = cost_and_run_length_.certainty_sub_field
                if not 0 <= certainty_sub_field_ <= 1: raise rt.Reject
                number_cells_sub_field_ = cost_and_run_length_.number_cells_sub_field
                if not 0 <= number_cells_sub_field_ <= 4095: raise rt.Reject
                raw_.append(cost_sub_field_ | certainty_sub_field_ << 3 | number_cells_sub_field_ << 4)
            out += _L_H[len(raw_)].pack(*raw_)

    cost_map2d_rec: iop_v1_0_types.CostMap2DRec
    cost_map2d_pose_var: iop_v1_0_types.CostMap2DGlobalPoseRec | iop_v1_0_types.CostMap2DLocalPoseRec
    cost_map2d_data_var: ReportCostMap2D.CostDataList | ReportCostMap2D.CostAndConfidenceDataList | ReportCostMap2D.RunLengthEncodedDataList

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("CostMap2DRec", iop_v1_0_types.CostMap2DRec.layout()),
            ("CostMap2DPoseVar", rt.Union.of("B", cost_map2d_global_pose_rec=iop_v1_0_types.CostMap2DGlobalPoseRec, cost_map2d_local_pose_rec=iop_v1_0_types.CostMap2DLocalPoseRec)),
            ("CostMap2DDataVar", rt.Union.of("B", cost_data_list=ReportCostMap2D.CostDataList, cost_and_confidence_data_list=ReportCostMap2D.CostAndConfidenceDataList, run_length_encoded_data_list=ReportCostMap2D.RunLengthEncodedDataList)),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x42 or data[1] != 0xD7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        number_of_rows_, number_of_columns_, map_width_, map_height_ = _S_4H.unpack_from(data, 2)
        self.cost_map2d_rec = iop_v1_0_types.CostMap2DRec(number_of_rows_, number_of_columns_, map_width_ * 0.15259021896696423, map_height_ * 0.15259021896696423)
        tag = data[10]
        at = 11
        self.cost_map2d_pose_var, at = _U_1[tag]._read(data, at, nesting)
        tag = data[at]
        at += 1
        self.cost_map2d_data_var, at = _U_19[tag]._read(data, at, nesting)
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x42\xd7")
        cost_map2d_rec_ = self.cost_map2d_rec
        if type(cost_map2d_rec_) is not iop_v1_0_types.CostMap2DRec: raise rt.Reject
        map_width_ = cost_map2d_rec_.map_width
        if not 0.0 <= map_width_ <= 10000.0: raise rt.Reject
        near = map_width_ * 6.5535 + 0.5
        map_width_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_width_raw_ < 0.9999847412109375: map_width_raw_ = rt.exact_raw(map_width_, _R_2)
        map_height_ = cost_map2d_rec_.map_height
        if not 0.0 <= map_height_ <= 10000.0: raise rt.Reject
        near = map_height_ * 6.5535 + 0.5
        map_height_raw_ = int(near)
        if not 1.52587890625e-05 < near - map_height_raw_ < 0.9999847412109375: map_height_raw_ = rt.exact_raw(map_height_, _R_2)
        out += _S_4H.pack(cost_map2d_rec_.number_of_rows, cost_map2d_rec_.number_of_columns, map_width_raw_, map_height_raw_)
        cost_map2d_pose_var_ = self.cost_map2d_pose_var
        out.append(_T_3[type(cost_map2d_pose_var_)])
        cost_map2d_pose_var_._write(out)
        cost_map2d_data_var_ = self.cost_map2d_data_var
        out.append(_T_20[type(cost_map2d_data_var_)])
        cost_map2d_data_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportNoGoZones(rt.Message):
    """ReportNoGoZones (0xD743): Tells the zones that must not be entered.

    no_go_zones_list: 0..65535 items. The zones
    """

    CODE = 0xD743
    NAME = "ReportNoGoZones"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    GlobalVertexRec = iop_v1_0_types.GlobalVertexRec
    LocalVertexRec = iop_v1_0_types.LocalVertexRec

    @dataclass(slots=True, repr=False)
    class ZoneIDRec(rt.Struct):
        """One zone.

        zone_id: Number of the zone
        """

        zone_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneID", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GlobalVertexList(rt.Struct):
        """Corners on the globe.

        global_vertex_list: 0..255 items. Corners on the globe
        """

        global_vertex_list: list[iop_v1_0_types.GlobalVertexRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GlobalVertexList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.GlobalVertexRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            global_vertex_list_count_ = data[at]
            global_vertex_list_end_ = at + 1 + global_vertex_list_count_ * 8
            self.global_vertex_list = [iop_v1_0_types.GlobalVertexRec(-90.0 + latitude_ * 4.190951586745435e-08, -180.0 + longitude_ * 8.38190317349087e-08) for latitude_, longitude_ in _S_2I.iter_unpack(data[at + 1:global_vertex_list_end_])]
            return self, global_vertex_list_end_

        def _write(self, out: bytearray) -> None:
            global_vertex_list_ = self.global_vertex_list
            if type(global_vertex_list_) is not list: raise rt.Reject
            out.append(len(global_vertex_list_))
            raw_: list[int | float] = []
            for item_ in global_vertex_list_:
                if type(item_) is not iop_v1_0_types.GlobalVertexRec: raise rt.Reject
                latitude_ = item_.latitude
                if not -90.0 <= latitude_ <= 90.0: raise rt.Reject
                near = latitude_ * 23860929.416666668 + 2147483648.0
                latitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - latitude_raw_ < 0.9999847412109375: latitude_raw_ = rt.exact_raw(latitude_, _R_6)
                longitude_ = item_.longitude
                if not -180.0 <= longitude_ <= 180.0: raise rt.Reject
                near = longitude_ * 11930464.708333334 + 2147483648.0
                longitude_raw_ = int(near)
                if not 1.52587890625e-05 < near - longitude_raw_ < 0.9999847412109375: longitude_raw_ = rt.exact_raw(longitude_, _R_7)
                raw_ += (latitude_raw_, longitude_raw_)
            out += _L_I[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class LocalVertexList(rt.Struct):
        """Corners in the local frame.

        local_vertex_list: 0..255 items. Corners in the local frame
        """

        local_vertex_list: list[iop_v1_0_types.LocalVertexRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LocalVertexList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.LocalVertexRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            local_vertex_list_count_ = data[at]
            local_vertex_list_end_ = at + 1 + local_vertex_list_count_ * 8
            self.local_vertex_list = [iop_v1_0_types.LocalVertexRec(-100000.0 + x_ * 4.656612874161595e-05, -100000.0 + y_ * 4.656612874161595e-05) for x_, y_ in _S_2I.iter_unpack(data[at + 1:local_vertex_list_end_])]
            return self, local_vertex_list_end_

        def _write(self, out: bytearray) -> None:
            local_vertex_list_ = self.local_vertex_list
            if type(local_vertex_list_) is not list: raise rt.Reject
            out.append(len(local_vertex_list_))
            raw_: list[int | float] = []
            for item_ in local_vertex_list_:
                if type(item_) is not iop_v1_0_types.LocalVertexRec: raise rt.Reject
                x_ = item_.x
                if not -100000.0 <= x_ <= 100000.0: raise rt.Reject
                near = x_ * 21474.836475 + 2147483648.0
                x_raw_ = int(near)
                if not 1.52587890625e-05 < near - x_raw_ < 0.9999847412109375: x_raw_ = rt.exact_raw(x_, _R_9)
                y_ = item_.y
                if not -100000.0 <= y_ <= 100000.0: raise rt.Reject
                near = y_ * 21474.836475 + 2147483648.0
                y_raw_ = int(near)
                if not 1.52587890625e-05 < near - y_raw_ < 0.9999847412109375: y_raw_ = rt.exact_raw(y_, _R_9)
                raw_ += (x_raw_, y_raw_)
            out += _L_I[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class NoGoZoneSeq(rt.Struct):
        """NoGoZoneSeq.

        zone_id_rec: One zone
        vertex_var: Corners, on the globe or in the local frame
        """

        zone_id_rec: ReportNoGoZones.ZoneIDRec
        vertex_var: ReportNoGoZones.GlobalVertexList | ReportNoGoZones.LocalVertexList

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ZoneIDRec", ReportNoGoZones.ZoneIDRec.layout()),
                ("VertexVar", rt.Union.of("B", global_vertex_list=ReportNoGoZones.GlobalVertexList, local_vertex_list=ReportNoGoZones.LocalVertexList)),
            )

    no_go_zones_list: list[ReportNoGoZones.NoGoZoneSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("NoGoZonesList", rt.Repeat(rt.Count("H", 0, 65535), ReportNoGoZones.NoGoZoneSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x43 or data[1] != 0xD7: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (no_go_zones_list_count_,) = _S_H.unpack_from(data, 2)
        if no_go_zones_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        no_go_zones_list_ = []
        for _ in range(no_go_zones_list_count_):
            item_ = rt.new(ReportNoGoZones.NoGoZoneSeq)
            (zone_id_,) = _S_H.unpack_from(data, at)
            item_.zone_id_rec = ReportNoGoZones.ZoneIDRec(zone_id_)
            tag = data[at + 2]
            at += 3
            item_.vertex_var, at = _U_21[tag]._read(data, at, nesting)
            no_go_zones_list_.append(item_)
        self.no_go_zones_list = no_go_zones_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x43\xd7")
        no_go_zones_list_ = self.no_go_zones_list
        if type(no_go_zones_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(no_go_zones_list_))
        for item_ in no_go_zones_list_:
            if type(item_) is not ReportNoGoZones.NoGoZoneSeq: raise rt.Reject
            zone_id_rec_ = item_.zone_id_rec
            if type(zone_id_rec_) is not ReportNoGoZones.ZoneIDRec: raise rt.Reject
            out += _S_H.pack(zone_id_rec_.zone_id)
            vertex_var_ = item_.vertex_var
            out.append(_T_22[type(vertex_var_)])
            vertex_var_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class AddNoGoZoneResponse(rt.Message):
    """AddNoGoZoneResponse (0xD744): Tells whether a zone was added.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. Whether the zone was added, and if not, why
    zone_id: Number of the zone
    """

    CODE = 0xD744
    NAME = "AddNoGoZoneResponse"
    SERVICE = "urn:jaus:jss:iop:CostMap2D"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        SUCCESS = 0
        GLOBAL_VERTICES_NOT_SUPPORTED = 1
        LOCAL_VERTICES_NOT_SUPPORTED = 2

    request_id: int
    response_code: AddNoGoZoneResponse.ResponseCode | int
    zone_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("H")),
            ("ResponseCode", rt.Number("B", rt.Values(AddNoGoZoneResponse.ResponseCode))),
            ("ZoneID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id, response_code_, self.zone_id = _S_2HBH.unpack(data)
        if code != 0xD744: raise rt.Reject
        self.response_code = _E_AddNoGoZoneResponse_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_AddNoGoZoneResponse_ResponseCode: raise rt.Reject
        return _S_2HBH.pack(0xD744, self.request_id, response_code_, self.zone_id)


_S_2H = rt.Packer("<2H")
_U_1: tuple[type[iop_v1_0_types.CostMap2DGlobalPoseRec] | type[iop_v1_0_types.CostMap2DLocalPoseRec], ...] = (iop_v1_0_types.CostMap2DGlobalPoseRec, iop_v1_0_types.CostMap2DLocalPoseRec)
_R_2 = rt.Scaling(0.0, 10000.0, 65535)
_T_3: dict[type[rt.Struct], int] = {iop_v1_0_types.CostMap2DGlobalPoseRec: 0, iop_v1_0_types.CostMap2DLocalPoseRec: 1}
_S_B = rt.Packer("<B")
_S_2I = rt.Packer("<2I")
_R_6 = rt.Scaling(-90.0, 90.0, 4294967295)
_R_7 = rt.Scaling(-180.0, 180.0, 4294967295)
_L_I = rt.Rows("I")
_R_9 = rt.Scaling(-100000.0, 100000.0, 4294967295)
_S_H = rt.Packer("<H")
_U_11: tuple[type[AddNoGoZone.GlobalVertexList] | type[AddNoGoZone.LocalVertexList], ...] = (AddNoGoZone.GlobalVertexList, AddNoGoZone.LocalVertexList)
_T_12: dict[type[rt.Struct], int] = {AddNoGoZone.GlobalVertexList: 0, AddNoGoZone.LocalVertexList: 1}
_L_B = rt.Rows("B")
_S_2B = rt.Packer("<2B")
_R_15 = rt.Scaling(0.0, 100.0, 255)
_E_RunLengthEncodedDataRec_CertaintySubField = rt.members(iop_v1_0_types.RunLengthEncodedDataRec.CertaintySubField)
_L_H = rt.Rows("H")
_S_4H = rt.Packer("<4H")
_U_19: tuple[type[ReportCostMap2D.CostDataList] | type[ReportCostMap2D.CostAndConfidenceDataList] | type[ReportCostMap2D.RunLengthEncodedDataList], ...] = (ReportCostMap2D.CostDataList, ReportCostMap2D.CostAndConfidenceDataList, ReportCostMap2D.RunLengthEncodedDataList)
_T_20: dict[type[rt.Struct], int] = {ReportCostMap2D.CostDataList: 0, ReportCostMap2D.CostAndConfidenceDataList: 1, ReportCostMap2D.RunLengthEncodedDataList: 2}
_U_21: tuple[type[ReportNoGoZones.GlobalVertexList] | type[ReportNoGoZones.LocalVertexList], ...] = (ReportNoGoZones.GlobalVertexList, ReportNoGoZones.LocalVertexList)
_T_22: dict[type[rt.Struct], int] = {ReportNoGoZones.GlobalVertexList: 0, ReportNoGoZones.LocalVertexList: 1}
_E_AddNoGoZoneResponse_ResponseCode = rt.members(AddNoGoZoneResponse.ResponseCode)
_S_2HBH = rt.Packer("<2HBH")
QueryCostMap2D.REPORT = ReportCostMap2D
QueryNoGoZones.REPORT = ReportNoGoZones
