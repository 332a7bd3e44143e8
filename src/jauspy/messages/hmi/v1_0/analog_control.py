"""urn:jaus:jss:HMI:AnalogControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryAnalogDevices(rt.Message):
    """QueryAnalogDevices (0x2707): Asks which controls there are."""

    CODE = 0x2707
    NAME = "QueryAnalogDevices"
    SERVICE = "urn:jaus:jss:HMI:AnalogControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnalogDevices]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x07'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2707)


@dataclass(slots=True, repr=False)
class QueryAnalogAction(rt.Message):
    """QueryAnalogAction (0x2708): Asks for the deflection of a control.

    presence_vector: Which axes the report is to have, by bit
    analog_reference: Which control is meant
    """

    CODE = 0x2708
    NAME = "QueryAnalogAction"
    SERVICE = "urn:jaus:jss:HMI:AnalogControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAnalogAction]]

    presence_vector: int
    analog_reference: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PresenceVector", rt.Number("b")),
            ("AnalogReference", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.presence_vector, self.analog_reference = _S_HbH.unpack(data)
        if code != 0x2708: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HbH.pack(0x2708, self.presence_vector, self.analog_reference)


@dataclass(slots=True, repr=False)
class ReportAnalogDevices(rt.Message):
    """ReportAnalogDevices (0x4707): Tells which controls there are.

    report_analog_devices_list: 0..255 items. The controls
    """

    CODE = 0x4707
    NAME = "ReportAnalogDevices"
    SERVICE = "urn:jaus:jss:HMI:AnalogControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class ReportAnalogDevicesRec(rt.Struct):
        """ReportAnalogDevicesRec.

        reference: Number of the control
        name: up to 255 characters. Name of the control, for people
        """

        reference: int
        name: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Reference", rt.Number("H")),
                ("Name", rt.Text(count=rt.Count("B", 0, 255))),
            )

    report_analog_devices_list: list[ReportAnalogDevices.ReportAnalogDevicesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReportAnalogDevicesList", rt.Repeat(rt.Count("B", 0, 255), ReportAnalogDevices.ReportAnalogDevicesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x47: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        report_analog_devices_list_count_ = data[2]
        if report_analog_devices_list_count_ * 3 > size - 3: raise rt.Reject
        at = 3
        report_analog_devices_list_ = []
        for _ in range(report_analog_devices_list_count_):
            item_ = rt.new(ReportAnalogDevices.ReportAnalogDevicesRec)
            (item_.reference,) = _S_H.unpack_from(data, at)
            name_end_ = at + 3 + data[at + 2]
            item_.name = data[at + 3:name_end_].decode("latin-1")
            at = name_end_
            report_analog_devices_list_.append(item_)
        self.report_analog_devices_list = report_analog_devices_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x47")
        report_analog_devices_list_ = self.report_analog_devices_list
        if type(report_analog_devices_list_) is not list: raise rt.Reject
        out.append(len(report_analog_devices_list_))
        for item_ in report_analog_devices_list_:
            if type(item_) is not ReportAnalogDevices.ReportAnalogDevicesRec: raise rt.Reject
            out += _S_H.pack(item_.reference)
            name_raw_ = item_.name.encode("latin-1")
            out.append(len(name_raw_))
            out += name_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportAnalogAction(rt.Message):
    """ReportAnalogAction (0x4708): Tells the deflection of a control.

    reference: Number of the control
    longitudinal: optional. Deflection forward
    lateral: optional. Deflection to the right
    vertical: optional. Deflection upward
    roll: optional. Rotation about the forward axis
    pitch: optional. Rotation about the axis to the right
    yaw: optional. Rotation about the upward axis
    """

    CODE = 0x4708
    NAME = "ReportAnalogAction"
    SERVICE = "urn:jaus:jss:HMI:AnalogControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class LongitudinalChoice(IntEnum):
        """Values of LongitudinalChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Longitudinal(rt.Struct):
        """Deflection forward.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.LongitudinalChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.LongitudinalChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_LongitudinalChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    class LateralChoice(IntEnum):
        """Values of LateralChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Lateral(rt.Struct):
        """Deflection to the right.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.LateralChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.LateralChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_LateralChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    class VerticalChoice(IntEnum):
        """Values of VerticalChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Vertical(rt.Struct):
        """Deflection upward.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.VerticalChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.VerticalChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_VerticalChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    class RollChoice(IntEnum):
        """Values of RollChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Roll(rt.Struct):
        """Rotation about the forward axis.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.RollChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.RollChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_RollChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    class PitchChoice(IntEnum):
        """Values of PitchChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Pitch(rt.Struct):
        """Rotation about the axis to the right.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.PitchChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.PitchChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_PitchChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    class YawChoice(IntEnum):
        """Values of YawChoice."""

        ONE_0 = 0
        ONE_1 = 1
        ONE_2 = 2

    @dataclass(slots=True, repr=False)
    class Yaw(rt.Struct):
        """Rotation about the upward axis.

        0: one
        1: one
        2: one
        """

        choice: ReportAnalogAction.YawChoice | int
        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Choice(
                cls,
                {
                    0: rt.Number("b"),
                    1: rt.Number("h"),
                    2: rt.Number("i"),
                },
                rt.Values(ReportAnalogAction.YawChoice),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            choice = data[at]
            if choice == 0:
                (self.value,) = _S_b.unpack_from(data, at + 1)
                at += 2
            elif choice == 1:
                (self.value,) = _S_h.unpack_from(data, at + 1)
                at += 3
            elif choice == 2:
                (self.value,) = _S_i.unpack_from(data, at + 1)
                at += 5
            else: raise rt.Reject
            self.choice = _E_ReportAnalogAction_YawChoice[choice]
            return self, at

        def _write(self, out: bytearray) -> None:
            choice = self.choice
            if choice == 0:
                out += _S_Bb.pack(choice, self.value)
            elif choice == 1:
                out += _S_Bh.pack(choice, self.value)
            elif choice == 2:
                out += _S_Bi.pack(choice, self.value)
            else: raise rt.Reject

    reference: int
    longitudinal: ReportAnalogAction.Longitudinal | None = None
    lateral: ReportAnalogAction.Lateral | None = None
    vertical: ReportAnalogAction.Vertical | None = None
    roll: ReportAnalogAction.Roll | None = None
    pitch: ReportAnalogAction.Pitch | None = None
    yaw: ReportAnalogAction.Yaw | None = None
    reserved_presence: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, "B",
            ("Reference", rt.Number("H")),
            ("Longitudinal", ReportAnalogAction.Longitudinal.layout(), True),
            ("Lateral", ReportAnalogAction.Lateral.layout(), True),
            ("Vertical", ReportAnalogAction.Vertical.layout(), True),
            ("Roll", ReportAnalogAction.Roll.layout(), True),
            ("Pitch", ReportAnalogAction.Pitch.layout(), True),
            ("Yaw", ReportAnalogAction.Yaw.layout(), True),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x08 or data[1] != 0x47: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        mask = data[2]
        (self.reference,) = _S_H.unpack_from(data, 3)
        at = 5
        if mask & 1:
            self.longitudinal, at = ReportAnalogAction.Longitudinal._read(data, at, nesting)
        else: self.longitudinal = None
        if mask & 2:
            self.lateral, at = ReportAnalogAction.Lateral._read(data, at, nesting)
        else: self.lateral = None
        if mask & 4:
            self.vertical, at = ReportAnalogAction.Vertical._read(data, at, nesting)
        else: self.vertical = None
        if mask & 8:
            self.roll, at = ReportAnalogAction.Roll._read(data, at, nesting)
        else: self.roll = None
        if mask & 16:
            self.pitch, at = ReportAnalogAction.Pitch._read(data, at, nesting)
        else: self.pitch = None
        if mask & 32:
            self.yaw, at = ReportAnalogAction.Yaw._read(data, at, nesting)
        else: self.yaw = None
        self.reserved_presence = mask & 0xC0
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x08\x47")
        start = len(out)
        out += b"\0"
        mask = self.reserved_presence
        if mask & 0x3F: raise rt.Reject
        out += _S_H.pack(self.reference)
        longitudinal_ = self.longitudinal
        if longitudinal_ is not None:
            mask |= 1
            if type(longitudinal_) is not ReportAnalogAction.Longitudinal: raise rt.Reject
            longitudinal_._write(out)
        lateral_ = self.lateral
        if lateral_ is not None:
            mask |= 2
            if type(lateral_) is not ReportAnalogAction.Lateral: raise rt.Reject
            lateral_._write(out)
        vertical_ = self.vertical
        if vertical_ is not None:
            mask |= 4
            if type(vertical_) is not ReportAnalogAction.Vertical: raise rt.Reject
            vertical_._write(out)
        roll_ = self.roll
        if roll_ is not None:
            mask |= 8
            if type(roll_) is not ReportAnalogAction.Roll: raise rt.Reject
            roll_._write(out)
        pitch_ = self.pitch
        if pitch_ is not None:
            mask |= 16
            if type(pitch_) is not ReportAnalogAction.Pitch: raise rt.Reject
            pitch_._write(out)
        yaw_ = self.yaw
        if yaw_ is not None:
            mask |= 32
            if type(yaw_) is not ReportAnalogAction.Yaw: raise rt.Reject
            yaw_._write(out)
        _S_B.pack_into(out, start, mask)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_HbH = rt.Packer("<HbH")
_S_b = rt.Packer("<b")
_S_h = rt.Packer("<h")
_S_i = rt.Packer("<i")
_E_ReportAnalogAction_LongitudinalChoice = rt.members(ReportAnalogAction.LongitudinalChoice)
_S_Bb = rt.Packer("<Bb")
_S_Bh = rt.Packer("<Bh")
_S_Bi = rt.Packer("<Bi")
_E_ReportAnalogAction_LateralChoice = rt.members(ReportAnalogAction.LateralChoice)
_E_ReportAnalogAction_VerticalChoice = rt.members(ReportAnalogAction.VerticalChoice)
_E_ReportAnalogAction_RollChoice = rt.members(ReportAnalogAction.RollChoice)
_E_ReportAnalogAction_PitchChoice = rt.members(ReportAnalogAction.PitchChoice)
_E_ReportAnalogAction_YawChoice = rt.members(ReportAnalogAction.YawChoice)
_S_B = rt.Packer("<B")
QueryAnalogDevices.REPORT = ReportAnalogDevices
QueryAnalogAction.REPORT = ReportAnalogAction
