"""urn:jaus:jss:ugv:StabilizerDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryStabilizerEffort(rt.Message):
    """QueryStabilizerEffort (0x2503): Asks for the efforts of stabilizers.

    stabilizer_id: 0..255 items. The stabilizers
    """

    CODE = 0x2503
    NAME = "QueryStabilizerEffort"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStabilizerEffort]]

    @dataclass(slots=True, repr=False)
    class QueryStabilizerRec(rt.Struct):
        """QueryStabilizerRec.

        stabilizer_id: Identifies the stabilizer
        """

        stabilizer_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
            )

    stabilizer_id: list[QueryStabilizerEffort.QueryStabilizerRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerID", rt.Repeat(rt.Count("B", 0, 255), QueryStabilizerEffort.QueryStabilizerRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x25: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_id_count_ = data[2]
        stabilizer_id_end_ = 3 + stabilizer_id_count_ * 1
        self.stabilizer_id = [QueryStabilizerEffort.QueryStabilizerRec(stabilizer_id_) for stabilizer_id_ in _L_B[stabilizer_id_count_].unpack_from(data, 3)]
        if stabilizer_id_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x25")
        stabilizer_id_ = self.stabilizer_id
        if type(stabilizer_id_) is not list: raise rt.Reject
        out.append(len(stabilizer_id_))
        raw_: list[int | float] = []
        for item_ in stabilizer_id_:
            if type(item_) is not QueryStabilizerEffort.QueryStabilizerRec: raise rt.Reject
            raw_.append(item_.stabilizer_id)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryStabilizerCapabilities(rt.Message):
    """QueryStabilizerCapabilities (0x2505): Asks for limits and outline of stabilizers."""

    CODE = 0x2505
    NAME = "QueryStabilizerCapabilities"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStabilizerCapabilities]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x05%': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2505)


@dataclass(slots=True, repr=False)
class SetStabilizerEffort(rt.Message):
    """SetStabilizerEffort (0x0503): Sets the efforts of stabilizers.

    stabilizer_effort: 0..255 items. The stabilizers
    """

    CODE = 0x0503
    NAME = "SetStabilizerEffort"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class StabilizerEffortRec(rt.Struct):
        """One stabilizer.

        stabilizer_id: Identifies the stabilizer
        effort: -100..100. Effort, in percent of the maximum; positive is up
        """

        stabilizer_id: int
        effort: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
                ("Effort", rt.real("H", -100.0, 100.0)),
            )

    stabilizer_effort: list[SetStabilizerEffort.StabilizerEffortRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerEffort", rt.Repeat(rt.Count("B", 0, 255), SetStabilizerEffort.StabilizerEffortRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x05: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_effort_count_ = data[2]
        stabilizer_effort_end_ = 3 + stabilizer_effort_count_ * 3
        self.stabilizer_effort = [SetStabilizerEffort.StabilizerEffortRec(stabilizer_id_, -100.0 + effort_ * 0.0030518043793392844) for stabilizer_id_, effort_ in _S_BH.iter_unpack(data[3:stabilizer_effort_end_])]
        if stabilizer_effort_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x05")
        stabilizer_effort_ = self.stabilizer_effort
        if type(stabilizer_effort_) is not list: raise rt.Reject
        out.append(len(stabilizer_effort_))
        for item_ in stabilizer_effort_:
            if type(item_) is not SetStabilizerEffort.StabilizerEffortRec: raise rt.Reject
            effort_ = item_.effort
            if not -100.0 <= effort_ <= 100.0: raise rt.Reject
            near = effort_ * 327.675 + 32768.0
            effort_raw_ = int(near)
            if not 1.52587890625e-05 < near - effort_raw_ < 0.9999847412109375: effort_raw_ = rt.exact_raw(effort_, _R_3)
            out += _S_BH.pack(item_.stabilizer_id, effort_raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class SetStabilizerPosition(rt.Message):
    """SetStabilizerPosition (0x0504): Sets the angles of stabilizers.

    stabilizer_position: 0..255 items. The stabilizers
    """

    CODE = 0x0504
    NAME = "SetStabilizerPosition"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class StabilizerPositionRec(rt.Struct):
        """StabilizerPositionRec.

        stabilizer_id: Identifies the stabilizer
        position: -3.14159..3.14159 radian. Wanted angle, in radians; positive is up
        """

        stabilizer_id: int
        position: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
                ("Position", rt.real("H", -3.14159, 3.14159, "radian")),
            )

    stabilizer_position: list[SetStabilizerPosition.StabilizerPositionRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerPosition", rt.Repeat(rt.Count("B", 0, 255), SetStabilizerPosition.StabilizerPositionRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x05: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_position_count_ = data[2]
        stabilizer_position_end_ = 3 + stabilizer_position_count_ * 3
        self.stabilizer_position = [SetStabilizerPosition.StabilizerPositionRec(stabilizer_id_, -3.14159 + position_ * 9.587518120088503e-05) for stabilizer_id_, position_ in _S_BH.iter_unpack(data[3:stabilizer_position_end_])]
        if stabilizer_position_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x05")
        stabilizer_position_ = self.stabilizer_position
        if type(stabilizer_position_) is not list: raise rt.Reject
        out.append(len(stabilizer_position_))
        for item_ in stabilizer_position_:
            if type(item_) is not SetStabilizerPosition.StabilizerPositionRec: raise rt.Reject
            position_ = item_.position
            if not -3.14159 <= position_ <= 3.14159: raise rt.Reject
            near = position_ * 10430.228005564062 + 32768.0
            position_raw_ = int(near)
            if not 1.52587890625e-05 < near - position_raw_ < 0.9999847412109375: position_raw_ = rt.exact_raw(position_, _R_4)
            out += _S_BH.pack(item_.stabilizer_id, position_raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryStabilizerPosition(rt.Message):
    """QueryStabilizerPosition (0x2504): Asks for the angles of stabilizers.

    stabilizer_id: 0..255 items. The stabilizers
    """

    CODE = 0x2504
    NAME = "QueryStabilizerPosition"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStabilizerPosition]]

    @dataclass(slots=True, repr=False)
    class QueryStabilizerRec(rt.Struct):
        """QueryStabilizerRec.

        stabilizer_id: Identifies the stabilizer
        """

        stabilizer_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
            )

    stabilizer_id: list[QueryStabilizerPosition.QueryStabilizerRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerID", rt.Repeat(rt.Count("B", 0, 255), QueryStabilizerPosition.QueryStabilizerRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x25: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_id_count_ = data[2]
        stabilizer_id_end_ = 3 + stabilizer_id_count_ * 1
        self.stabilizer_id = [QueryStabilizerPosition.QueryStabilizerRec(stabilizer_id_) for stabilizer_id_ in _L_B[stabilizer_id_count_].unpack_from(data, 3)]
        if stabilizer_id_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x25")
        stabilizer_id_ = self.stabilizer_id
        if type(stabilizer_id_) is not list: raise rt.Reject
        out.append(len(stabilizer_id_))
        raw_: list[int | float] = []
        for item_ in stabilizer_id_:
            if type(item_) is not QueryStabilizerPosition.QueryStabilizerRec: raise rt.Reject
            raw_.append(item_.stabilizer_id)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStabilizerPosition(rt.Message):
    """ReportStabilizerPosition (0x4504): Tells the angles of stabilizers.

    stabilizer_position: 0..255 items. The stabilizers
    """

    CODE = 0x4504
    NAME = "ReportStabilizerPosition"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class StabilizerPositionRec(rt.Struct):
        """StabilizerPositionRec.

        stabilizer_id: Identifies the stabilizer
        commanded_position: -3.14159..3.14159 radian. Wanted angle, in radians; positive is up
        actual_position: -3.14159..3.14159 radian. Present angle, in radians; positive is up
        """

        stabilizer_id: int
        commanded_position: float
        actual_position: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
                ("CommandedPosition", rt.real("H", -3.14159, 3.14159, "radian")),
                ("ActualPosition", rt.real("H", -3.14159, 3.14159, "radian")),
            )

    stabilizer_position: list[ReportStabilizerPosition.StabilizerPositionRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerPosition", rt.Repeat(rt.Count("B", 0, 255), ReportStabilizerPosition.StabilizerPositionRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_position_count_ = data[2]
        stabilizer_position_end_ = 3 + stabilizer_position_count_ * 5
        self.stabilizer_position = [ReportStabilizerPosition.StabilizerPositionRec(stabilizer_id_, -3.14159 + commanded_position_ * 9.587518120088503e-05, -3.14159 + actual_position_ * 9.587518120088503e-05) for stabilizer_id_, commanded_position_, actual_position_ in _S_B2H.iter_unpack(data[3:stabilizer_position_end_])]
        if stabilizer_position_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x45")
        stabilizer_position_ = self.stabilizer_position
        if type(stabilizer_position_) is not list: raise rt.Reject
        out.append(len(stabilizer_position_))
        for item_ in stabilizer_position_:
            if type(item_) is not ReportStabilizerPosition.StabilizerPositionRec: raise rt.Reject
            commanded_position_ = item_.commanded_position
            if not -3.14159 <= commanded_position_ <= 3.14159: raise rt.Reject
            near = commanded_position_ * 10430.228005564062 + 32768.0
            commanded_position_raw_ = int(near)
            if not 1.52587890625e-05 < near - commanded_position_raw_ < 0.9999847412109375: commanded_position_raw_ = rt.exact_raw(commanded_position_, _R_4)
            actual_position_ = item_.actual_position
            if not -3.14159 <= actual_position_ <= 3.14159: raise rt.Reject
            near = actual_position_ * 10430.228005564062 + 32768.0
            actual_position_raw_ = int(near)
            if not 1.52587890625e-05 < near - actual_position_raw_ < 0.9999847412109375: actual_position_raw_ = rt.exact_raw(actual_position_, _R_4)
            out += _S_B2H.pack(item_.stabilizer_id, commanded_position_raw_, actual_position_raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStabilizerCapabilities(rt.Message):
    """ReportStabilizerCapabilities (0x4505): Tells limits and outline of stabilizers.

    stabilizer_capabilities: 0..255 items. The stabilizers
    """

    CODE = 0x4505
    NAME = "ReportStabilizerCapabilities"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class StabilizerCapabilitiesRec(rt.Struct):
        """StabilizerCapabilitiesRec.

        stabilizer_id: Identifies the stabilizer
        maximum_up_angle: 0..3.14159 radian. Highest angle, in radians
        maximum_down_angle: -3.14158..0 radian. Lowest angle, in radians; 0 or negative
        """

        stabilizer_id: int
        maximum_up_angle: float
        maximum_down_angle: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
                ("MaximumUpAngle", rt.real("H", 0.0, 3.14159, "radian")),
                ("MaximumDownAngle", rt.real("H", -3.14158, 0.0, "radian")),
            )

    @dataclass(slots=True, repr=False)
    class Points(rt.Struct):
        """Points.

        point_x: -32.768..32.767 meter. Position of the corner along X, in metres
        point_y: -32.768..32.767 meter. Position of the corner along Y, in metres
        point_z: -32.768..32.767 meter. Position of the corner along Z, in metres
        """

        point_x: float
        point_y: float
        point_z: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PointX", rt.real("H", -32.768, 32.767, "meter")),
                ("PointY", rt.real("H", -32.768, 32.767, "meter")),
                ("PointZ", rt.real("H", -32.768, 32.767, "meter")),
            )

    @dataclass(slots=True, repr=False)
    class StabilizerCapabilitiesSeq(rt.Struct):
        """StabilizerCapabilitiesSeq.

        stabilizer_dimensions_list: 0..255 items. Corners of the outline
        """

        stabilizer_capabilities_rec: ReportStabilizerCapabilities.StabilizerCapabilitiesRec
        stabilizer_dimensions_list: list[ReportStabilizerCapabilities.Points]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("stabilizerCapabilitiesRec", ReportStabilizerCapabilities.StabilizerCapabilitiesRec.layout()),
                ("stabilizerDimensionsList", rt.Repeat(rt.Count("B", 0, 255), ReportStabilizerCapabilities.Points.layout())),
            )

    stabilizer_capabilities: list[ReportStabilizerCapabilities.StabilizerCapabilitiesSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerCapabilities", rt.Repeat(rt.Count("B", 0, 255), ReportStabilizerCapabilities.StabilizerCapabilitiesSeq.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x05 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_capabilities_count_ = data[2]
        if stabilizer_capabilities_count_ * 6 > size - 3: raise rt.Reject
        at = 3
        stabilizer_capabilities_ = []
        for _ in range(stabilizer_capabilities_count_):
            item_ = rt.new(ReportStabilizerCapabilities.StabilizerCapabilitiesSeq)
            stabilizer_id_, maximum_up_angle_, maximum_down_angle_ = _S_B2H.unpack_from(data, at)
            item_.stabilizer_capabilities_rec = ReportStabilizerCapabilities.StabilizerCapabilitiesRec(stabilizer_id_, maximum_up_angle_ * 4.793759060044251e-05, -3.14158 + maximum_down_angle_ * 4.793743801022354e-05)
            stabilizer_dimensions_list_count_ = data[at + 5]
            stabilizer_dimensions_list_end_ = at + 6 + stabilizer_dimensions_list_count_ * 6
            item_.stabilizer_dimensions_list = [ReportStabilizerCapabilities.Points(32.767 if point_x_ == 65535 else -32.768 + point_x_ * 0.001, 32.767 if point_y_ == 65535 else -32.768 + point_y_ * 0.001, 32.767 if point_z_ == 65535 else -32.768 + point_z_ * 0.001) for point_x_, point_y_, point_z_ in _S_3H.iter_unpack(data[at + 6:stabilizer_dimensions_list_end_])]
            at = stabilizer_dimensions_list_end_
            stabilizer_capabilities_.append(item_)
        self.stabilizer_capabilities = stabilizer_capabilities_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x05\x45")
        stabilizer_capabilities_ = self.stabilizer_capabilities
        if type(stabilizer_capabilities_) is not list: raise rt.Reject
        out.append(len(stabilizer_capabilities_))
        for item_ in stabilizer_capabilities_:
            if type(item_) is not ReportStabilizerCapabilities.StabilizerCapabilitiesSeq: raise rt.Reject
            stabilizer_capabilities_rec_ = item_.stabilizer_capabilities_rec
            if type(stabilizer_capabilities_rec_) is not ReportStabilizerCapabilities.StabilizerCapabilitiesRec: raise rt.Reject
            maximum_up_angle_ = stabilizer_capabilities_rec_.maximum_up_angle
            if not 0.0 <= maximum_up_angle_ <= 3.14159: raise rt.Reject
            near = maximum_up_angle_ * 20860.456011128124 + 0.5
            maximum_up_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - maximum_up_angle_raw_ < 0.9999847412109375: maximum_up_angle_raw_ = rt.exact_raw(maximum_up_angle_, _R_7)
            maximum_down_angle_ = stabilizer_capabilities_rec_.maximum_down_angle
            if not -3.14158 <= maximum_down_angle_ <= 0.0: raise rt.Reject
            near = maximum_down_angle_ * 20860.52241228936 + 65535.5
            maximum_down_angle_raw_ = int(near)
            if not 1.52587890625e-05 < near - maximum_down_angle_raw_ < 0.9999847412109375: maximum_down_angle_raw_ = rt.exact_raw(maximum_down_angle_, _R_8)
            out += _S_B2H.pack(stabilizer_capabilities_rec_.stabilizer_id, maximum_up_angle_raw_, maximum_down_angle_raw_)
            stabilizer_dimensions_list_ = item_.stabilizer_dimensions_list
            if type(stabilizer_dimensions_list_) is not list: raise rt.Reject
            out.append(len(stabilizer_dimensions_list_))
            raw_: list[int | float] = []
            for item_2_ in stabilizer_dimensions_list_:
                if type(item_2_) is not ReportStabilizerCapabilities.Points: raise rt.Reject
                point_x_ = item_2_.point_x
                if not -32.768 <= point_x_ <= 32.767: raise rt.Reject
                near = point_x_ * 1000.0 + 32768.5
                point_x_raw_ = int(near)
                if not 1.52587890625e-05 < near - point_x_raw_ < 0.9999847412109375: point_x_raw_ = rt.exact_raw(point_x_, _R_9)
                point_y_ = item_2_.point_y
                if not -32.768 <= point_y_ <= 32.767: raise rt.Reject
                near = point_y_ * 1000.0 + 32768.5
                point_y_raw_ = int(near)
                if not 1.52587890625e-05 < near - point_y_raw_ < 0.9999847412109375: point_y_raw_ = rt.exact_raw(point_y_, _R_9)
                point_z_ = item_2_.point_z
                if not -32.768 <= point_z_ <= 32.767: raise rt.Reject
                near = point_z_ * 1000.0 + 32768.5
                point_z_raw_ = int(near)
                if not 1.52587890625e-05 < near - point_z_raw_ < 0.9999847412109375: point_z_raw_ = rt.exact_raw(point_z_, _R_9)
                raw_ += (point_x_raw_, point_y_raw_, point_z_raw_)
            out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStabilizerEffort(rt.Message):
    """ReportStabilizerEffort (0x4503): Tells the efforts of stabilizers.

    stabilizer_effort: 0..255 items. The stabilizers
    """

    CODE = 0x4503
    NAME = "ReportStabilizerEffort"
    SERVICE = "urn:jaus:jss:ugv:StabilizerDriver"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class StabilizerEffortRec(rt.Struct):
        """One stabilizer.

        stabilizer_id: Identifies the stabilizer
        effort: -100..100. Effort, in percent of the maximum; positive is up
        """

        stabilizer_id: int
        effort: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("StabilizerID", rt.Number("B")),
                ("Effort", rt.real("H", -100.0, 100.0)),
            )

    stabilizer_effort: list[ReportStabilizerEffort.StabilizerEffortRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("stabilizerEffort", rt.Repeat(rt.Count("B", 0, 255), ReportStabilizerEffort.StabilizerEffortRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x03 or data[1] != 0x45: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        stabilizer_effort_count_ = data[2]
        stabilizer_effort_end_ = 3 + stabilizer_effort_count_ * 3
        self.stabilizer_effort = [ReportStabilizerEffort.StabilizerEffortRec(stabilizer_id_, -100.0 + effort_ * 0.0030518043793392844) for stabilizer_id_, effort_ in _S_BH.iter_unpack(data[3:stabilizer_effort_end_])]
        if stabilizer_effort_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x03\x45")
        stabilizer_effort_ = self.stabilizer_effort
        if type(stabilizer_effort_) is not list: raise rt.Reject
        out.append(len(stabilizer_effort_))
        for item_ in stabilizer_effort_:
            if type(item_) is not ReportStabilizerEffort.StabilizerEffortRec: raise rt.Reject
            effort_ = item_.effort
            if not -100.0 <= effort_ <= 100.0: raise rt.Reject
            near = effort_ * 327.675 + 32768.0
            effort_raw_ = int(near)
            if not 1.52587890625e-05 < near - effort_raw_ < 0.9999847412109375: effort_raw_ = rt.exact_raw(effort_, _R_3)
            out += _S_BH.pack(item_.stabilizer_id, effort_raw_)
        return bytes(out)


_L_B = rt.Rows("B")
_S_H = rt.Packer("<H")
_S_BH = rt.Packer("<BH")
_R_3 = rt.Scaling(-100.0, 100.0, 65535)
_R_4 = rt.Scaling(-3.14159, 3.14159, 65535)
_S_B2H = rt.Packer("<B2H")
_S_3H = rt.Packer("<3H")
_R_7 = rt.Scaling(0.0, 3.14159, 65535)
_R_8 = rt.Scaling(-3.14158, 0.0, 65535)
_R_9 = rt.Scaling(-32.768, 32.767, 65535)
_L_H = rt.Rows("H")
QueryStabilizerEffort.REPORT = ReportStabilizerEffort
QueryStabilizerCapabilities.REPORT = ReportStabilizerCapabilities
QueryStabilizerPosition.REPORT = ReportStabilizerPosition
