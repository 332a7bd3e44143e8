"""urn:jaus:jss:iop:MeasurementSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types


@dataclass(slots=True, repr=False)
class QueryMeasurement(rt.Message):
    """QueryMeasurement (0xF92A): Asks for readings."""

    CODE = 0xF92A
    NAME = "QueryMeasurement"
    SERVICE = "urn:jaus:jss:iop:MeasurementSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportMeasurement]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'*\xf9': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xF92A)


@dataclass(slots=True, repr=False)
class ReportMeasurement(rt.Message):
    """ReportMeasurement (0xF92B): Tells readings.

    device_rec: The device
    readings_list: 0..255 items. The readings
    global_pose_rec: optional. A pose on the globe
    timestamp_rec: optional. Time of the readings
    """

    CODE = 0xF92B
    NAME = "ReportMeasurement"
    SERVICE = "urn:jaus:jss:iop:MeasurementSensor"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    DeviceRec = iop_v1_0_types.DeviceRec
    ReadingRec = iop_v1_0_types.ReadingRec
    ValueRec = iop_v1_0_types.ValueRec
    GlobalPoseRec = iop_v1_0_types.GlobalPoseRec
    TimestampRec = iop_v1_0_types.TimestampRec

    @dataclass(slots=True, repr=False)
    class ReadingSeq(rt.Struct):
        """ReadingSeq.

        reading_rec: One reading
        value_list: 0..255 items. The values
        """

        reading_rec: iop_v1_0_types.ReadingRec
        value_list: list[iop_v1_0_types.ValueRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ReadingRec", iop_v1_0_types.ReadingRec.layout()),
                ("ValueList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.ValueRec.layout())),
            )

    device_rec: iop_v1_0_types.DeviceRec
    readings_list: list[ReportMeasurement.ReadingSeq]
    global_pose_rec: iop_v1_0_types.GlobalPoseRec | None = None
    timestamp_rec: iop_v1_0_types.TimestampRec | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("DeviceRec", iop_v1_0_types.DeviceRec.layout()),
            ("ReadingsList", rt.Repeat(rt.Count("B", 0, 255), ReportMeasurement.ReadingSeq.layout())),
            ("GlobalPoseRec", iop_v1_0_types.GlobalPoseRec.layout(), True),
            ("TimestampRec", iop_v1_0_types.TimestampRec.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x2B or data[1] != 0xF9: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        at = 3
        self.device_rec, at = iop_v1_0_types.DeviceRec._read(data, at, nesting)
        readings_list_count_ = data[at]
        if readings_list_count_ * 5 > size - (at + 1): raise rt.Reject
        at += 1
        readings_list_ = []
        for _ in range(readings_list_count_):
            item_ = rt.new(ReportMeasurement.ReadingSeq)
            item_.reading_rec, at = iop_v1_0_types.ReadingRec._read(data, at, nesting)
            value_list_count_ = data[at]
            value_list_end_ = at + 1 + value_list_count_ * 4
            item_.value_list = [iop_v1_0_types.ValueRec(-10000.0 + value_ * 4.656612874161595e-06) for value_ in _L_I[value_list_count_].unpack_from(data, at + 1)]
            at = value_list_end_
            readings_list_.append(item_)
        self.readings_list = readings_list_
        if mask & 1:
            self.global_pose_rec, at = iop_v1_0_types.GlobalPoseRec._read(data, at, nesting)
        else: self.global_pose_rec = None
        packer = _M_ReportMeasurement_3[mask & 0x2]
        raw = iter(packer.unpack_from(data, at)).__next__
        at += packer.size
        if mask & 2:
            time_stamp_ = raw()
            milliseconds_ = time_stamp_ & 0x3FF
            if milliseconds_ > 999: raise rt.Reject
            seconds_ = time_stamp_ >> 10 & 0x3F
            if seconds_ > 59: raise rt.Reject
            minutes_ = time_stamp_ >> 16 & 0x3F
            if minutes_ > 59: raise rt.Reject
            hour_ = time_stamp_ >> 22 & 0x1F
            if hour_ > 23: raise rt.Reject
            day_ = time_stamp_ >> 27 & 0x1F
            if day_ < 1: raise rt.Reject
            self.timestamp_rec = iop_v1_0_types.TimestampRec(core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_))
        else: self.timestamp_rec = None
        self.reserved_presence = mask & 0xFC
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x2b\xf9")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3: raise rt.Reject
        device_rec_ = self.device_rec
        if type(device_rec_) is not iop_v1_0_types.DeviceRec: raise rt.Reject
        device_rec_._write(out)
        readings_list_ = self.readings_list
        if type(readings_list_) is not list: raise rt.Reject
        out.append(len(readings_list_))
        for item_ in readings_list_:
            if type(item_) is not ReportMeasurement.ReadingSeq: raise rt.Reject
            reading_rec_ = item_.reading_rec
            if type(reading_rec_) is not iop_v1_0_types.ReadingRec: raise rt.Reject
            reading_rec_._write(out)
            value_list_ = item_.value_list
            if type(value_list_) is not list: raise rt.Reject
            out.append(len(value_list_))
            raw_: list[int | float] = []
            for item_2_ in value_list_:
                if type(item_2_) is not iop_v1_0_types.ValueRec: raise rt.Reject
                value_ = item_2_.value
                if not -10000.0 <= value_ <= 10000.0: raise rt.Reject
                near = value_ * 214748.36475 + 2147483648.0
                value_raw_ = int(near)
                if not 1.52587890625e-05 < near - value_raw_ < 0.9999847412109375: value_raw_ = rt.exact_raw(value_, _R_3)
                raw_.append(value_raw_)
            out += _L_I[len(raw_)].pack(*raw_)
        global_pose_rec_ = self.global_pose_rec
        if global_pose_rec_ is not None:
            mask |= 1
            if type(global_pose_rec_) is not iop_v1_0_types.GlobalPoseRec: raise rt.Reject
            global_pose_rec_._write(out)
        raw: list[int | float | bytes] = []
        timestamp_rec_ = self.timestamp_rec
        if timestamp_rec_ is not None:
            mask |= 2
            if type(timestamp_rec_) is not iop_v1_0_types.TimestampRec: raise rt.Reject
            time_stamp_ = timestamp_rec_.time_stamp
            if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
            milliseconds_ = time_stamp_.milliseconds
            if not 0 <= milliseconds_ <= 999: raise rt.Reject
            seconds_ = time_stamp_.seconds
            if not 0 <= seconds_ <= 59: raise rt.Reject
            minutes_ = time_stamp_.minutes
            if not 0 <= minutes_ <= 59: raise rt.Reject
            hour_ = time_stamp_.hour
            if not 0 <= hour_ <= 23: raise rt.Reject
            day_ = time_stamp_.day
            if not 1 <= day_ <= 31: raise rt.Reject
            raw.append(milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
        out += _M_ReportMeasurement_3[mask & 0x2].pack(*raw)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_S_H = rt.Packer("<H")
_L_I = rt.Rows("I")
_M_ReportMeasurement_3 = rt.Masks("", ((2, "I"),))
_R_3 = rt.Scaling(-10000.0, 10000.0, 4294967295)
_S_B = rt.Packer("<B")
QueryMeasurement.REPORT = ReportMeasurement
