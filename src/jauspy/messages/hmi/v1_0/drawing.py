"""urn:jaus:jss:HMI:Drawing 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class QueryDrawingDefinition(rt.Message):
    """QueryDrawingDefinition (0x2700): Asks for the picture."""

    CODE = 0x2700
    NAME = "QueryDrawingDefinition"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDrawingDefinition]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x00'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2700)


@dataclass(slots=True, repr=False)
class QueryDataDefinition(rt.Message):
    """QueryDataDefinition (0x2701): Asks which data the picture uses."""

    CODE = 0x2701
    NAME = "QueryDataDefinition"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDataDefinition]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b"\x01'": raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2701)


@dataclass(slots=True, repr=False)
class QueryData(rt.Message):
    """QueryData (0x2702): Asks for data that the picture uses.

    data_structure_reference: Number of the data structure
    """

    CODE = 0x2702
    NAME = "QueryData"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportData]]

    data_structure_reference: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DataStructureReference", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.data_structure_reference = _S_2H.unpack(data)
        if code != 0x2702: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2702, self.data_structure_reference)


@dataclass(slots=True, repr=False)
class ReportDrawingDefinition(rt.Message):
    """ReportDrawingDefinition (0x4700): Tells the commands that draw the picture.

    graphics_command_list: 0..65535 items. The commands, in order
    """

    CODE = 0x4700
    NAME = "ReportDrawingDefinition"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class ReferenceFieldRec(rt.Struct):
        """ReferenceFieldRec.

        drawing_definition_reference: Number of another drawing to be drawn here
        """

        drawing_definition_reference: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("DrawingDefinitionReference", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class Literal(rt.Struct):
        """A number in the command itself.

        value: The number
        """

        value: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Value", rt.Number("i")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.value,) = _S_i.unpack_from(data, at)
            return self, at + 4

        def _write(self, out: bytearray) -> None:
            out += _S_i.pack(self.value)

    @dataclass(slots=True, repr=False)
    class Reference(rt.Struct):
        """A number in the data of the picture.

        structure: Number of the data structure
        field: Number of the field in it
        """

        structure: int
        field: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Structure", rt.Number("H")),
                ("Field", rt.Number("H")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.structure, self.field = _S_2H.unpack_from(data, at)
            return self, at + 4

        def _write(self, out: bytearray) -> None:
            out += _S_2H.pack(self.structure, self.field)

    @dataclass(slots=True, repr=False)
    class PageSeq(rt.Struct):
        """PageSeq.

        minimum_x: X of the left edge
        minimum_y: Y of the lower edge
        maximum_x: X of the right edge
        maximum_y: Y of the upper edge
        """

        minimum_x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        minimum_y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        maximum_x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        maximum_y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("MinimumX", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("MinimumY", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("MaximumX", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("MaximumY", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.minimum_x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.minimum_y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.maximum_x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.maximum_y, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            minimum_x_ = self.minimum_x
            out.append(_T_4[type(minimum_x_)])
            minimum_x_._write(out)
            minimum_y_ = self.minimum_y
            out.append(_T_4[type(minimum_y_)])
            minimum_y_._write(out)
            maximum_x_ = self.maximum_x
            out.append(_T_4[type(maximum_x_)])
            maximum_x_._write(out)
            maximum_y_ = self.maximum_y
            out.append(_T_4[type(maximum_y_)])
            maximum_y_._write(out)

    @dataclass(slots=True, repr=False)
    class BackgroundRec(rt.Struct):
        """BackgroundRec.

        red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """

        red_color: int
        green_color: int
        blue_color: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RedColor", rt.Number("b")),
                ("GreenColor", rt.Number("b")),
                ("BlueColor", rt.Number("b")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.red_color, self.green_color, self.blue_color = _S_3b.unpack_from(data, at)
            return self, at + 3

        def _write(self, out: bytearray) -> None:
            out += _S_3b.pack(self.red_color, self.green_color, self.blue_color)

    @dataclass(slots=True, repr=False)
    class PenRec(rt.Struct):
        """PenRec.

        red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """

        red_color: int
        green_color: int
        blue_color: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RedColor", rt.Number("b")),
                ("GreenColor", rt.Number("b")),
                ("BlueColor", rt.Number("b")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.red_color, self.green_color, self.blue_color = _S_3b.unpack_from(data, at)
            return self, at + 3

        def _write(self, out: bytearray) -> None:
            out += _S_3b.pack(self.red_color, self.green_color, self.blue_color)

    @dataclass(slots=True, repr=False)
    class PenWidthRec(rt.Struct):
        """PenWidthRec.

        width: Width of lines
        """

        width: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Width", rt.Number("b")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.width,) = _S_b.unpack_from(data, at)
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            out += _S_b.pack(self.width)

    @dataclass(slots=True, repr=False)
    class BrushRec(rt.Struct):
        """BrushRec.

        red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """

        red_color: int
        green_color: int
        blue_color: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RedColor", rt.Number("b")),
                ("GreenColor", rt.Number("b")),
                ("BlueColor", rt.Number("b")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.red_color, self.green_color, self.blue_color = _S_3b.unpack_from(data, at)
            return self, at + 3

        def _write(self, out: bytearray) -> None:
            out += _S_3b.pack(self.red_color, self.green_color, self.blue_color)

    class Group(IntEnum):
        """Values of Group."""

        TOP = 0
        LEFT = 1
        RIGHT = 2
        BOTTOM = 3

    @dataclass(slots=True, repr=False)
    class DigitalControlRec(rt.Struct):
        """DigitalControlRec.

        reference: Number of the control
        group: Group. Edge of the display that the control is at
        digital_control_rec: 0..4. Place in its group
        label: up to 12 characters. Text on the control
        """

        reference: int
        group: ReportDrawingDefinition.Group | int
        digital_control_rec: int
        label: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Reference", rt.Number("H")),
                ("Group", rt.Number("b", rt.Values(ReportDrawingDefinition.Group))),
                ("DigitalControlRec", rt.Number("b", rt.Values(None, ((0, 4),)))),
                ("Label", rt.Text(12)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.reference, group_, digital_control_rec_, label_ = _S_H2b12s.unpack_from(data, at)
            self.group = _E_ReportDrawingDefinition_Group[group_]
            if not 0 <= digital_control_rec_ <= 4: raise rt.Reject
            self.digital_control_rec = digital_control_rec_
            self.label = label_.rstrip(b"\0").decode("latin-1")
            return self, at + 16

        def _write(self, out: bytearray) -> None:
            group_ = self.group
            if group_ not in _E_ReportDrawingDefinition_Group: raise rt.Reject
            digital_control_rec_ = self.digital_control_rec
            if not 0 <= digital_control_rec_ <= 4: raise rt.Reject
            label_raw_ = self.label.encode("latin-1")
            if len(label_raw_) > 12: raise rt.Reject
            out += _S_H2b12s.pack(self.reference, group_, digital_control_rec_, label_raw_)

    @dataclass(slots=True, repr=False)
    class DigitalControlGroupRec(rt.Struct):
        """DigitalControlGroupRec.

        group: Group. Edge of the display that the group is at
        label: up to 12 characters. Text on the group
        """

        group: ReportDrawingDefinition.Group | int
        label: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Group", rt.Number("b", rt.Values(ReportDrawingDefinition.Group))),
                ("Label", rt.Text(12)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            group_, label_ = _S_b12s.unpack_from(data, at)
            self.group = _E_ReportDrawingDefinition_Group[group_]
            self.label = label_.rstrip(b"\0").decode("latin-1")
            return self, at + 13

        def _write(self, out: bytearray) -> None:
            group_ = self.group
            if group_ not in _E_ReportDrawingDefinition_Group: raise rt.Reject
            label_raw_ = self.label.encode("latin-1")
            if len(label_raw_) > 12: raise rt.Reject
            out += _S_b12s.pack(group_, label_raw_)

    class Alignment(IntEnum):
        """Values of Alignment."""

        TOP_LEFT = 0
        MIDDLE_LEFT = 1
        BOTTOM_LEFT = 2
        MIDDLE_CENTER = 3
        MIDDLE_RIGHT = 4
        BOTTOM_CENTER = 5
        BOTTOM_RIGHT = 6
        TOP_CENTER = 7
        TOP_RIGHT = 8

    @dataclass(slots=True, repr=False)
    class AlignmentRec(rt.Struct):
        """Alignment of text.

        alignment: Alignment. Which point of the text is at the position
        """

        alignment: ReportDrawingDefinition.Alignment | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Alignment", rt.Number("b", rt.Values(ReportDrawingDefinition.Alignment))),
            )

    @dataclass(slots=True, repr=False)
    class TextRec(rt.Struct):
        """TextRec.

        text: up to 255 characters. Text to draw
        """

        text: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Text", rt.Text(count=rt.Count("B", 0, 255))),
            )

    @dataclass(slots=True, repr=False)
    class LabelSeq(rt.Struct):
        """LabelSeq.

        x: X of the figure
        y: Y of the figure
        alignment_rec: Alignment of text
        font_size: Size of the text
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        alignment_rec: ReportDrawingDefinition.AlignmentRec
        font_size: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        text_rec: ReportDrawingDefinition.TextRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("AlignmentRec", ReportDrawingDefinition.AlignmentRec.layout()),
                ("FontSize", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("TextRec", ReportDrawingDefinition.TextRec.layout()),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            (alignment_,) = _S_b.unpack_from(data, at)
            self.alignment_rec = ReportDrawingDefinition.AlignmentRec(_E_ReportDrawingDefinition_Alignment[alignment_])
            tag = data[at + 1]
            at += 2
            self.font_size, at = _U_3[tag]._read(data, at, nesting)
            self.text_rec = text_rec_ = rt.new(ReportDrawingDefinition.TextRec)
            text_end_ = at + 1 + data[at]
            text_rec_.text = data[at + 1:text_end_].decode("latin-1")
            return self, text_end_

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            alignment_rec_ = self.alignment_rec
            if type(alignment_rec_) is not ReportDrawingDefinition.AlignmentRec: raise rt.Reject
            alignment_ = alignment_rec_.alignment
            if alignment_ not in _E_ReportDrawingDefinition_Alignment: raise rt.Reject
            out += _S_b.pack(alignment_)
            font_size_ = self.font_size
            out.append(_T_4[type(font_size_)])
            font_size_._write(out)
            text_rec_ = self.text_rec
            if type(text_rec_) is not ReportDrawingDefinition.TextRec: raise rt.Reject
            text_raw_ = text_rec_.text.encode("latin-1")
            out.append(len(text_raw_))
            out += text_raw_

    @dataclass(slots=True, repr=False)
    class ValueSeq(rt.Struct):
        """ValueSeq.

        x: X of the figure
        y: Y of the figure
        alignment_rec: Alignment of text
        font_size: Size of the text
        data_reference: The number to show
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        alignment_rec: ReportDrawingDefinition.AlignmentRec
        font_size: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        data_reference: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("AlignmentRec", ReportDrawingDefinition.AlignmentRec.layout()),
                ("FontSize", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("DataReference", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            (alignment_,) = _S_b.unpack_from(data, at)
            self.alignment_rec = ReportDrawingDefinition.AlignmentRec(_E_ReportDrawingDefinition_Alignment[alignment_])
            tag = data[at + 1]
            at += 2
            self.font_size, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.data_reference, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            alignment_rec_ = self.alignment_rec
            if type(alignment_rec_) is not ReportDrawingDefinition.AlignmentRec: raise rt.Reject
            alignment_ = alignment_rec_.alignment
            if alignment_ not in _E_ReportDrawingDefinition_Alignment: raise rt.Reject
            out += _S_b.pack(alignment_)
            font_size_ = self.font_size
            out.append(_T_4[type(font_size_)])
            font_size_._write(out)
            data_reference_ = self.data_reference
            out.append(_T_4[type(data_reference_)])
            data_reference_._write(out)

    @dataclass(slots=True, repr=False)
    class RotateSeq(rt.Struct):
        """RotateSeq.

        angle: Angle to turn by
        """

        angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Angle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.angle, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            angle_ = self.angle
            out.append(_T_4[type(angle_)])
            angle_._write(out)

    @dataclass(slots=True, repr=False)
    class AntiRotateSeq(rt.Struct):
        """AntiRotateSeq.

        angle: Angle to turn back by
        """

        angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Angle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.angle, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            angle_ = self.angle
            out.append(_T_4[type(angle_)])
            angle_._write(out)

    @dataclass(slots=True, repr=False)
    class TranslateSeq(rt.Struct):
        """TranslateSeq.

        tx: Distance to move along X
        ty: Distance to move along Y
        """

        tx: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        ty: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TX", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("TY", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.tx, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.ty, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            tx_ = self.tx
            out.append(_T_4[type(tx_)])
            tx_._write(out)
            ty_ = self.ty
            out.append(_T_4[type(ty_)])
            ty_._write(out)

    @dataclass(slots=True, repr=False)
    class AntiTranslateSeq(rt.Struct):
        """AntiTranslateSeq.

        tx: Distance to move back along X
        ty: Distance to move back along Y
        """

        tx: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        ty: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("TX", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("TY", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.tx, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.ty, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            tx_ = self.tx
            out.append(_T_4[type(tx_)])
            tx_._write(out)
            ty_ = self.ty
            out.append(_T_4[type(ty_)])
            ty_._write(out)

    @dataclass(slots=True, repr=False)
    class RectangleSeq(rt.Struct):
        """RectangleSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)

    @dataclass(slots=True, repr=False)
    class FilledRectangleSeq(rt.Struct):
        """FilledRectangleSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)

    @dataclass(slots=True, repr=False)
    class CircleSeq(rt.Struct):
        """CircleSeq.

        x: X of the figure
        y: Y of the figure
        radius: Radius of the circle
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        radius: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Radius", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.radius, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            radius_ = self.radius
            out.append(_T_4[type(radius_)])
            radius_._write(out)

    @dataclass(slots=True, repr=False)
    class FilledCircleSeq(rt.Struct):
        """FilledCircleSeq.

        x: X of the figure
        y: Y of the figure
        radius: Radius of the circle
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        radius: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Radius", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.radius, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            radius_ = self.radius
            out.append(_T_4[type(radius_)])
            radius_._write(out)

    @dataclass(slots=True, repr=False)
    class EllipseSeq(rt.Struct):
        """EllipseSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)

    @dataclass(slots=True, repr=False)
    class FilledEllipseSeq(rt.Struct):
        """FilledEllipseSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)

    @dataclass(slots=True, repr=False)
    class LineSeq(rt.Struct):
        """LineSeq.

        x1: X of the start
        y1: Y of the start
        x2: X of the end
        y2: Y of the end
        """

        x1: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y1: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        x2: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y2: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X1", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y1", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("X2", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y2", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x1, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y1, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.x2, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y2, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x1_ = self.x1
            out.append(_T_4[type(x1_)])
            x1_._write(out)
            y1_ = self.y1
            out.append(_T_4[type(y1_)])
            y1_._write(out)
            x2_ = self.x2
            out.append(_T_4[type(x2_)])
            x2_._write(out)
            y2_ = self.y2
            out.append(_T_4[type(y2_)])
            y2_._write(out)

    @dataclass(slots=True, repr=False)
    class PolylineSeq(rt.Struct):
        """PolylineSeq.

        x: X of the corner
        y: Y of the corner
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

    @dataclass(slots=True, repr=False)
    class PolylineList(rt.Struct):
        """Corners of a line.

        polyline_list: 0..255 items. Corners of a line
        """

        polyline_list: list[ReportDrawingDefinition.PolylineSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PolylineList", rt.Repeat(rt.Count("B", 0, 255), ReportDrawingDefinition.PolylineSeq.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            polyline_list_count_ = data[at]
            if polyline_list_count_ * 10 > size - (at + 1): raise rt.Reject
            at += 1
            polyline_list_ = []
            for _ in range(polyline_list_count_):
                item_ = rt.new(ReportDrawingDefinition.PolylineSeq)
                tag = data[at]
                at += 1
                item_.x, at = _U_3[tag]._read(data, at, nesting)
                tag = data[at]
                at += 1
                item_.y, at = _U_3[tag]._read(data, at, nesting)
                polyline_list_.append(item_)
            self.polyline_list = polyline_list_
            return self, at

        def _write(self, out: bytearray) -> None:
            polyline_list_ = self.polyline_list
            if type(polyline_list_) is not list: raise rt.Reject
            out.append(len(polyline_list_))
            for item_ in polyline_list_:
                if type(item_) is not ReportDrawingDefinition.PolylineSeq: raise rt.Reject
                x_ = item_.x
                out.append(_T_4[type(x_)])
                x_._write(out)
                y_ = item_.y
                out.append(_T_4[type(y_)])
                y_._write(out)

    @dataclass(slots=True, repr=False)
    class PolygonSeq(rt.Struct):
        """PolygonSeq.

        x: X of the corner
        y: Y of the corner
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

    @dataclass(slots=True, repr=False)
    class PolygonList(rt.Struct):
        """Corners of a polygon.

        polygon_list: 0..255 items. Corners of a polygon
        """

        polygon_list: list[ReportDrawingDefinition.PolygonSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PolygonList", rt.Repeat(rt.Count("B", 0, 255), ReportDrawingDefinition.PolygonSeq.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            polygon_list_count_ = data[at]
            if polygon_list_count_ * 10 > size - (at + 1): raise rt.Reject
            at += 1
            polygon_list_ = []
            for _ in range(polygon_list_count_):
                item_ = rt.new(ReportDrawingDefinition.PolygonSeq)
                tag = data[at]
                at += 1
                item_.x, at = _U_3[tag]._read(data, at, nesting)
                tag = data[at]
                at += 1
                item_.y, at = _U_3[tag]._read(data, at, nesting)
                polygon_list_.append(item_)
            self.polygon_list = polygon_list_
            return self, at

        def _write(self, out: bytearray) -> None:
            polygon_list_ = self.polygon_list
            if type(polygon_list_) is not list: raise rt.Reject
            out.append(len(polygon_list_))
            for item_ in polygon_list_:
                if type(item_) is not ReportDrawingDefinition.PolygonSeq: raise rt.Reject
                x_ = item_.x
                out.append(_T_4[type(x_)])
                x_._write(out)
                y_ = item_.y
                out.append(_T_4[type(y_)])
                y_._write(out)

    @dataclass(slots=True, repr=False)
    class FilledPolygonSeq(rt.Struct):
        """FilledPolygonSeq.

        x: X of the corner
        y: Y of the corner
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

    @dataclass(slots=True, repr=False)
    class FilledPolygonList(rt.Struct):
        """Corners of a filled polygon.

        filled_polygon_list: 0..255 items. Corners of a filled polygon
        """

        filled_polygon_list: list[ReportDrawingDefinition.FilledPolygonSeq]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("FilledPolygonList", rt.Repeat(rt.Count("B", 0, 255), ReportDrawingDefinition.FilledPolygonSeq.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            size = len(data)
            self = rt.new(cls)
            filled_polygon_list_count_ = data[at]
            if filled_polygon_list_count_ * 10 > size - (at + 1): raise rt.Reject
            at += 1
            filled_polygon_list_ = []
            for _ in range(filled_polygon_list_count_):
                item_ = rt.new(ReportDrawingDefinition.FilledPolygonSeq)
                tag = data[at]
                at += 1
                item_.x, at = _U_3[tag]._read(data, at, nesting)
                tag = data[at]
                at += 1
                item_.y, at = _U_3[tag]._read(data, at, nesting)
                filled_polygon_list_.append(item_)
            self.filled_polygon_list = filled_polygon_list_
            return self, at

        def _write(self, out: bytearray) -> None:
            filled_polygon_list_ = self.filled_polygon_list
            if type(filled_polygon_list_) is not list: raise rt.Reject
            out.append(len(filled_polygon_list_))
            for item_ in filled_polygon_list_:
                if type(item_) is not ReportDrawingDefinition.FilledPolygonSeq: raise rt.Reject
                x_ = item_.x
                out.append(_T_4[type(x_)])
                x_._write(out)
                y_ = item_.y
                out.append(_T_4[type(y_)])
                y_._write(out)

    @dataclass(slots=True, repr=False)
    class ArcSeq(rt.Struct):
        """ArcSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        start_angle: Angle that the arc starts at
        arc_angle: Angle that the arc covers
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        start_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        arc_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("StartAngle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("ArcAngle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.start_angle, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.arc_angle, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)
            start_angle_ = self.start_angle
            out.append(_T_4[type(start_angle_)])
            start_angle_._write(out)
            arc_angle_ = self.arc_angle
            out.append(_T_4[type(arc_angle_)])
            arc_angle_._write(out)

    @dataclass(slots=True, repr=False)
    class FilledArcSec(rt.Struct):
        """FilledArcSec.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        start_angle: Angle that the arc starts at
        arc_angle: Angle that the arc covers
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        start_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        arc_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("StartAngle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("ArcAngle", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.start_angle, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.arc_angle, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)
            start_angle_ = self.start_angle
            out.append(_T_4[type(start_angle_)])
            start_angle_._write(out)
            arc_angle_ = self.arc_angle
            out.append(_T_4[type(arc_angle_)])
            arc_angle_._write(out)

    @dataclass(slots=True, repr=False)
    class Empty0(rt.Struct):
        """Empty0."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty1(rt.Struct):
        """Empty1."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty2(rt.Struct):
        """Empty2."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty3(rt.Struct):
        """Empty3."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty4(rt.Struct):
        """Empty4."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty5(rt.Struct):
        """Empty5."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty6(rt.Struct):
        """Empty6."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty7(rt.Struct):
        """Empty7."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty8(rt.Struct):
        """Empty8."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty9(rt.Struct):
        """Empty9."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty10(rt.Struct):
        """Empty10."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty11(rt.Struct):
        """Empty11."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty12(rt.Struct):
        """Empty12."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty13(rt.Struct):
        """Empty13."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty14(rt.Struct):
        """Empty14."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty15(rt.Struct):
        """Empty15."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty16(rt.Struct):
        """Empty16."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty17(rt.Struct):
        """Empty17."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty18(rt.Struct):
        """Empty18."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty19(rt.Struct):
        """Empty19."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty20(rt.Struct):
        """Empty20."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty21(rt.Struct):
        """Empty21."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty22(rt.Struct):
        """Empty22."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty23(rt.Struct):
        """Empty23."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty24(rt.Struct):
        """Empty24."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty25(rt.Struct):
        """Empty25."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty26(rt.Struct):
        """Empty26."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty27(rt.Struct):
        """Empty27."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty28(rt.Struct):
        """Empty28."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty29(rt.Struct):
        """Empty29."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty30(rt.Struct):
        """Empty30."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty31(rt.Struct):
        """Empty31."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty32(rt.Struct):
        """Empty32."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty33(rt.Struct):
        """Empty33."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty34(rt.Struct):
        """Empty34."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty35(rt.Struct):
        """Empty35."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty36(rt.Struct):
        """Empty36."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty37(rt.Struct):
        """Empty37."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty38(rt.Struct):
        """Empty38."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty39(rt.Struct):
        """Empty39."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty40(rt.Struct):
        """Empty40."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty41(rt.Struct):
        """Empty41."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty42(rt.Struct):
        """Empty42."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty43(rt.Struct):
        """Empty43."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty44(rt.Struct):
        """Empty44."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty45(rt.Struct):
        """Empty45."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty46(rt.Struct):
        """Empty46."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty47(rt.Struct):
        """Empty47."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty48(rt.Struct):
        """Empty48."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty49(rt.Struct):
        """Empty49."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty50(rt.Struct):
        """Empty50."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty51(rt.Struct):
        """Empty51."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty52(rt.Struct):
        """Empty52."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty53(rt.Struct):
        """Empty53."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty54(rt.Struct):
        """Empty54."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty55(rt.Struct):
        """Empty55."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty56(rt.Struct):
        """Empty56."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty57(rt.Struct):
        """Empty57."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty58(rt.Struct):
        """Empty58."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty59(rt.Struct):
        """Empty59."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty60(rt.Struct):
        """Empty60."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty61(rt.Struct):
        """Empty61."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty62(rt.Struct):
        """Empty62."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty63(rt.Struct):
        """Empty63."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty64(rt.Struct):
        """Empty64."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty65(rt.Struct):
        """Empty65."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty66(rt.Struct):
        """Empty66."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty67(rt.Struct):
        """Empty67."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty68(rt.Struct):
        """Empty68."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty69(rt.Struct):
        """Empty69."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty70(rt.Struct):
        """Empty70."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty71(rt.Struct):
        """Empty71."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty72(rt.Struct):
        """Empty72."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty73(rt.Struct):
        """Empty73."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty74(rt.Struct):
        """Empty74."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty75(rt.Struct):
        """Empty75."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty76(rt.Struct):
        """Empty76."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty77(rt.Struct):
        """Empty77."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty78(rt.Struct):
        """Empty78."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty79(rt.Struct):
        """Empty79."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty80(rt.Struct):
        """Empty80."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty81(rt.Struct):
        """Empty81."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty82(rt.Struct):
        """Empty82."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty83(rt.Struct):
        """Empty83."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty84(rt.Struct):
        """Empty84."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty85(rt.Struct):
        """Empty85."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty86(rt.Struct):
        """Empty86."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty87(rt.Struct):
        """Empty87."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty88(rt.Struct):
        """Empty88."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty89(rt.Struct):
        """Empty89."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty90(rt.Struct):
        """Empty90."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty91(rt.Struct):
        """Empty91."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty92(rt.Struct):
        """Empty92."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty93(rt.Struct):
        """Empty93."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty94(rt.Struct):
        """Empty94."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty95(rt.Struct):
        """Empty95."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty96(rt.Struct):
        """Empty96."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty97(rt.Struct):
        """Empty97."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty98(rt.Struct):
        """Empty98."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty99(rt.Struct):
        """Empty99."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty100(rt.Struct):
        """Empty100."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty101(rt.Struct):
        """Empty101."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty102(rt.Struct):
        """Empty102."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty103(rt.Struct):
        """Empty103."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty104(rt.Struct):
        """Empty104."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty105(rt.Struct):
        """Empty105."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty106(rt.Struct):
        """Empty106."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty107(rt.Struct):
        """Empty107."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty108(rt.Struct):
        """Empty108."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty109(rt.Struct):
        """Empty109."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty110(rt.Struct):
        """Empty110."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty111(rt.Struct):
        """Empty111."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty112(rt.Struct):
        """Empty112."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty113(rt.Struct):
        """Empty113."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty114(rt.Struct):
        """Empty114."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty115(rt.Struct):
        """Empty115."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty116(rt.Struct):
        """Empty116."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty117(rt.Struct):
        """Empty117."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty118(rt.Struct):
        """Empty118."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty119(rt.Struct):
        """Empty119."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty120(rt.Struct):
        """Empty120."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty121(rt.Struct):
        """Empty121."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty122(rt.Struct):
        """Empty122."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty123(rt.Struct):
        """Empty123."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty124(rt.Struct):
        """Empty124."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty125(rt.Struct):
        """Empty125."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty126(rt.Struct):
        """Empty126."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty127(rt.Struct):
        """Empty127."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty128(rt.Struct):
        """Empty128."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty129(rt.Struct):
        """Empty129."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty130(rt.Struct):
        """Empty130."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty131(rt.Struct):
        """Empty131."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty132(rt.Struct):
        """Empty132."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty133(rt.Struct):
        """Empty133."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty134(rt.Struct):
        """Empty134."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty135(rt.Struct):
        """Empty135."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty136(rt.Struct):
        """Empty136."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty137(rt.Struct):
        """Empty137."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty138(rt.Struct):
        """Empty138."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty139(rt.Struct):
        """Empty139."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty140(rt.Struct):
        """Empty140."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty141(rt.Struct):
        """Empty141."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty142(rt.Struct):
        """Empty142."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty143(rt.Struct):
        """Empty143."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty144(rt.Struct):
        """Empty144."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty145(rt.Struct):
        """Empty145."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty146(rt.Struct):
        """Empty146."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty147(rt.Struct):
        """Empty147."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty148(rt.Struct):
        """Empty148."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty149(rt.Struct):
        """Empty149."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty150(rt.Struct):
        """Empty150."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty151(rt.Struct):
        """Empty151."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty152(rt.Struct):
        """Empty152."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty153(rt.Struct):
        """Empty153."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty154(rt.Struct):
        """Empty154."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty155(rt.Struct):
        """Empty155."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty156(rt.Struct):
        """Empty156."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty157(rt.Struct):
        """Empty157."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty158(rt.Struct):
        """Empty158."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty159(rt.Struct):
        """Empty159."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty160(rt.Struct):
        """Empty160."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty161(rt.Struct):
        """Empty161."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty162(rt.Struct):
        """Empty162."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty163(rt.Struct):
        """Empty163."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty164(rt.Struct):
        """Empty164."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty165(rt.Struct):
        """Empty165."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty166(rt.Struct):
        """Empty166."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty167(rt.Struct):
        """Empty167."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty168(rt.Struct):
        """Empty168."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty169(rt.Struct):
        """Empty169."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty170(rt.Struct):
        """Empty170."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty171(rt.Struct):
        """Empty171."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty172(rt.Struct):
        """Empty172."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty173(rt.Struct):
        """Empty173."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty174(rt.Struct):
        """Empty174."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty175(rt.Struct):
        """Empty175."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty176(rt.Struct):
        """Empty176."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty177(rt.Struct):
        """Empty177."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty178(rt.Struct):
        """Empty178."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty179(rt.Struct):
        """Empty179."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty180(rt.Struct):
        """Empty180."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty181(rt.Struct):
        """Empty181."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty182(rt.Struct):
        """Empty182."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty183(rt.Struct):
        """Empty183."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty184(rt.Struct):
        """Empty184."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty185(rt.Struct):
        """Empty185."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty186(rt.Struct):
        """Empty186."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty187(rt.Struct):
        """Empty187."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty188(rt.Struct):
        """Empty188."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty189(rt.Struct):
        """Empty189."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty190(rt.Struct):
        """Empty190."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty191(rt.Struct):
        """Empty191."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty192(rt.Struct):
        """Empty192."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty193(rt.Struct):
        """Empty193."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty194(rt.Struct):
        """Empty194."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty195(rt.Struct):
        """Empty195."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty196(rt.Struct):
        """Empty196."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty197(rt.Struct):
        """Empty197."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty198(rt.Struct):
        """Empty198."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty199(rt.Struct):
        """Empty199."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty200(rt.Struct):
        """Empty200."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty201(rt.Struct):
        """Empty201."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty202(rt.Struct):
        """Empty202."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty203(rt.Struct):
        """Empty203."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty204(rt.Struct):
        """Empty204."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty205(rt.Struct):
        """Empty205."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty206(rt.Struct):
        """Empty206."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty207(rt.Struct):
        """Empty207."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty208(rt.Struct):
        """Empty208."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty209(rt.Struct):
        """Empty209."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty210(rt.Struct):
        """Empty210."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty211(rt.Struct):
        """Empty211."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty212(rt.Struct):
        """Empty212."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty213(rt.Struct):
        """Empty213."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty214(rt.Struct):
        """Empty214."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty215(rt.Struct):
        """Empty215."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty216(rt.Struct):
        """Empty216."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty217(rt.Struct):
        """Empty217."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty218(rt.Struct):
        """Empty218."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty219(rt.Struct):
        """Empty219."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty220(rt.Struct):
        """Empty220."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty221(rt.Struct):
        """Empty221."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty222(rt.Struct):
        """Empty222."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty223(rt.Struct):
        """Empty223."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty224(rt.Struct):
        """Empty224."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty225(rt.Struct):
        """Empty225."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty226(rt.Struct):
        """Empty226."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty227(rt.Struct):
        """Empty227."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty228(rt.Struct):
        """Empty228."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty229(rt.Struct):
        """Empty229."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty230(rt.Struct):
        """Empty230."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty231(rt.Struct):
        """Empty231."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty232(rt.Struct):
        """Empty232."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty233(rt.Struct):
        """Empty233."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty234(rt.Struct):
        """Empty234."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty235(rt.Struct):
        """Empty235."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty236(rt.Struct):
        """Empty236."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty237(rt.Struct):
        """Empty237."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty238(rt.Struct):
        """Empty238."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty239(rt.Struct):
        """Empty239."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty240(rt.Struct):
        """Empty240."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty241(rt.Struct):
        """Empty241."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty242(rt.Struct):
        """Empty242."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty243(rt.Struct):
        """Empty243."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty244(rt.Struct):
        """Empty244."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty245(rt.Struct):
        """Empty245."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty246(rt.Struct):
        """Empty246."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty247(rt.Struct):
        """Empty247."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty248(rt.Struct):
        """Empty248."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty249(rt.Struct):
        """Empty249."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty250(rt.Struct):
        """Empty250."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty251(rt.Struct):
        """Empty251."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty252(rt.Struct):
        """Empty252."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty253(rt.Struct):
        """Empty253."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty254(rt.Struct):
        """Empty254."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class Empty255(rt.Struct):
        """Empty255."""

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Composite(cls, ())

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            return self, at

        def _write(self, out: bytearray) -> None:
            return

    @dataclass(slots=True, repr=False)
    class PushVar(rt.Struct):
        """Keep the present position, angle and colours.

        push_var: Keep the present position, angle and colours
        """

        push_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PushVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.push_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            push_var_ = self.push_var
            out.append(_T_12[type(push_var_)])
            push_var_._write(out)

    @dataclass(slots=True, repr=False)
    class PopVar(rt.Struct):
        """Go back to what was kept last.

        pop_var: Go back to what was kept last
        """

        pop_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PopVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.pop_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            pop_var_ = self.pop_var
            out.append(_T_12[type(pop_var_)])
            pop_var_._write(out)

    @dataclass(slots=True, repr=False)
    class IfVar(rt.Struct):
        """Draw what follows when the number is not 0.

        if_var: Draw what follows when the number is not 0
        """

        if_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IfVar", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.if_var, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            if_var_ = self.if_var
            out.append(_T_4[type(if_var_)])
            if_var_._write(out)

    @dataclass(slots=True, repr=False)
    class ElseIfVar(rt.Struct):
        """Otherwise, draw what follows when the number is not 0.

        else_if_var: Otherwise, draw what follows when the number is not 0
        """

        else_if_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ElseIfVar", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.else_if_var, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            else_if_var_ = self.else_if_var
            out.append(_T_4[type(else_if_var_)])
            else_if_var_._write(out)

    @dataclass(slots=True, repr=False)
    class ElseVar(rt.Struct):
        """Otherwise draw what follows.

        else_var: Otherwise draw what follows
        """

        else_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ElseVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.else_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            else_var_ = self.else_var
            out.append(_T_12[type(else_var_)])
            else_var_._write(out)

    @dataclass(slots=True, repr=False)
    class EndIfVar(rt.Struct):
        """End of the last If.

        end_if_var: End of the last If
        """

        end_if_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("EndIfVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.end_if_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            end_if_var_ = self.end_if_var
            out.append(_T_12[type(end_if_var_)])
            end_if_var_._write(out)

    @dataclass(slots=True, repr=False)
    class SelectVar(rt.Struct):
        """Draw the case that has this number.

        select_var: Draw the case that has this number
        """

        select_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SelectVar", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.select_var, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            select_var_ = self.select_var
            out.append(_T_4[type(select_var_)])
            select_var_._write(out)

    @dataclass(slots=True, repr=False)
    class CaseVar(rt.Struct):
        """Draw what follows when this is the selected number.

        case_var: Draw what follows when this is the selected number
        """

        case_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("CaseVar", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.case_var, at = _U_3[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            case_var_ = self.case_var
            out.append(_T_4[type(case_var_)])
            case_var_._write(out)

    @dataclass(slots=True, repr=False)
    class DefaultVar(rt.Struct):
        """Draw what follows when no case had the selected number.

        default_var: Draw what follows when no case had the selected number
        """

        default_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("DefaultVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.default_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            default_var_ = self.default_var
            out.append(_T_12[type(default_var_)])
            default_var_._write(out)

    @dataclass(slots=True, repr=False)
    class EndSelectVar(rt.Struct):
        """End of the last Select.

        end_select_var: End of the last Select
        """

        end_select_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("EndSelectVar", rt.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255)),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.end_select_var, at = _U_11[tag]._read(data, at, nesting)
            return self, at

        def _write(self, out: bytearray) -> None:
            end_select_var_ = self.end_select_var
            out.append(_T_12[type(end_select_var_)])
            end_select_var_._write(out)

    class ImageType(IntEnum):
        """Values of ImageType."""

        PPM = 0
        JPEG = 1
        TIFF = 2
        NITF = 3
        BMP = 4

    @dataclass(slots=True, repr=False)
    class ImageTypeRec(rt.Struct):
        """ImageTypeRec.

        image_type: ImageType. Coding of the image
        """

        image_type: ReportDrawingDefinition.ImageType | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ImageType", rt.Number("b", rt.Values(ReportDrawingDefinition.ImageType))),
            )

    @dataclass(slots=True, repr=False)
    class ImageSeq(rt.Struct):
        """ImageSeq.

        x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        reference_to_data: Number of the data structure that holds the image
        """

        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        reference_to_data: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference
        image_type_rec: ReportDrawingDefinition.ImageTypeRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Y", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Width", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("Height", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("ReferenceToData", rt.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference)),
                ("ImageTypeRec", ReportDrawingDefinition.ImageTypeRec.layout()),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            tag = data[at]
            at += 1
            self.x, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.y, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.width, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.height, at = _U_3[tag]._read(data, at, nesting)
            tag = data[at]
            at += 1
            self.reference_to_data, at = _U_3[tag]._read(data, at, nesting)
            (image_type_,) = _S_b.unpack_from(data, at)
            self.image_type_rec = ReportDrawingDefinition.ImageTypeRec(_E_ReportDrawingDefinition_ImageType[image_type_])
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            x_ = self.x
            out.append(_T_4[type(x_)])
            x_._write(out)
            y_ = self.y
            out.append(_T_4[type(y_)])
            y_._write(out)
            width_ = self.width
            out.append(_T_4[type(width_)])
            width_._write(out)
            height_ = self.height
            out.append(_T_4[type(height_)])
            height_._write(out)
            reference_to_data_ = self.reference_to_data
            out.append(_T_4[type(reference_to_data_)])
            reference_to_data_._write(out)
            image_type_rec_ = self.image_type_rec
            if type(image_type_rec_) is not ReportDrawingDefinition.ImageTypeRec: raise rt.Reject
            image_type_ = image_type_rec_.image_type
            if image_type_ not in _E_ReportDrawingDefinition_ImageType: raise rt.Reject
            out += _S_b.pack(image_type_)

    reference_field_rec: ReportDrawingDefinition.ReferenceFieldRec
    graphics_command_list: list[ReportDrawingDefinition.PageSeq | ReportDrawingDefinition.BackgroundRec | ReportDrawingDefinition.PenRec | ReportDrawingDefinition.PenWidthRec | ReportDrawingDefinition.BrushRec | ReportDrawingDefinition.DigitalControlRec | ReportDrawingDefinition.DigitalControlGroupRec | ReportDrawingDefinition.LabelSeq | ReportDrawingDefinition.ValueSeq | ReportDrawingDefinition.RotateSeq | ReportDrawingDefinition.AntiRotateSeq | ReportDrawingDefinition.TranslateSeq | ReportDrawingDefinition.AntiTranslateSeq | ReportDrawingDefinition.RectangleSeq | ReportDrawingDefinition.FilledRectangleSeq | ReportDrawingDefinition.CircleSeq | ReportDrawingDefinition.FilledCircleSeq | ReportDrawingDefinition.EllipseSeq | ReportDrawingDefinition.FilledEllipseSeq | ReportDrawingDefinition.LineSeq | ReportDrawingDefinition.PolylineList | ReportDrawingDefinition.PolygonList | ReportDrawingDefinition.FilledPolygonList | ReportDrawingDefinition.ArcSeq | ReportDrawingDefinition.FilledArcSec | ReportDrawingDefinition.PushVar | ReportDrawingDefinition.PopVar | ReportDrawingDefinition.IfVar | ReportDrawingDefinition.ElseIfVar | ReportDrawingDefinition.ElseVar | ReportDrawingDefinition.EndIfVar | ReportDrawingDefinition.SelectVar | ReportDrawingDefinition.CaseVar | ReportDrawingDefinition.DefaultVar | ReportDrawingDefinition.EndSelectVar | ReportDrawingDefinition.ImageSeq]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReferenceFieldRec", ReportDrawingDefinition.ReferenceFieldRec.layout()),
            ("GraphicsCommandList", rt.Repeat(rt.Count("H", 0, 65535), rt.Union.of("B", page_seq=ReportDrawingDefinition.PageSeq, background_rec=ReportDrawingDefinition.BackgroundRec, pen_rec=ReportDrawingDefinition.PenRec, pen_width_rec=ReportDrawingDefinition.PenWidthRec, brush_rec=ReportDrawingDefinition.BrushRec, digital_control_rec=ReportDrawingDefinition.DigitalControlRec, digital_control_group_rec=ReportDrawingDefinition.DigitalControlGroupRec, label_seq=ReportDrawingDefinition.LabelSeq, value_seq=ReportDrawingDefinition.ValueSeq, rotate_seq=ReportDrawingDefinition.RotateSeq, anti_rotate_seq=ReportDrawingDefinition.AntiRotateSeq, translate_seq=ReportDrawingDefinition.TranslateSeq, anti_translate_seq=ReportDrawingDefinition.AntiTranslateSeq, rectangle_seq=ReportDrawingDefinition.RectangleSeq, filled_rectangle_seq=ReportDrawingDefinition.FilledRectangleSeq, circle_seq=ReportDrawingDefinition.CircleSeq, filled_circle_seq=ReportDrawingDefinition.FilledCircleSeq, ellipse_seq=ReportDrawingDefinition.EllipseSeq, filled_ellipse_seq=ReportDrawingDefinition.FilledEllipseSeq, line_seq=ReportDrawingDefinition.LineSeq, polyline_list=ReportDrawingDefinition.PolylineList, polygon_list=ReportDrawingDefinition.PolygonList, filled_polygon_list=ReportDrawingDefinition.FilledPolygonList, arc_seq=ReportDrawingDefinition.ArcSeq, filled_arc_sec=ReportDrawingDefinition.FilledArcSec, push_var=ReportDrawingDefinition.PushVar, pop_var=ReportDrawingDefinition.PopVar, if_var=ReportDrawingDefinition.IfVar, else_if_var=ReportDrawingDefinition.ElseIfVar, else_var=ReportDrawingDefinition.ElseVar, end_if_var=ReportDrawingDefinition.EndIfVar, select_var=ReportDrawingDefinition.SelectVar, case_var=ReportDrawingDefinition.CaseVar, default_var=ReportDrawingDefinition.DefaultVar, end_select_var=ReportDrawingDefinition.EndSelectVar, image_seq=ReportDrawingDefinition.ImageSeq))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x00 or data[1] != 0x47: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (drawing_definition_reference_,) = _S_H.unpack_from(data, 2)
        self.reference_field_rec = ReportDrawingDefinition.ReferenceFieldRec(drawing_definition_reference_)
        (graphics_command_list_count_,) = _S_H.unpack_from(data, 4)
        if graphics_command_list_count_ * 2 > size - 6: raise rt.Reject
        at = 6
        graphics_command_list_ = []
        for _ in range(graphics_command_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_14[tag]._read(data, at, nesting)
            graphics_command_list_.append(item_)
        self.graphics_command_list = graphics_command_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x00\x47")
        reference_field_rec_ = self.reference_field_rec
        if type(reference_field_rec_) is not ReportDrawingDefinition.ReferenceFieldRec: raise rt.Reject
        out += _S_H.pack(reference_field_rec_.drawing_definition_reference)
        graphics_command_list_ = self.graphics_command_list
        if type(graphics_command_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(graphics_command_list_))
        for item_ in graphics_command_list_:
            out.append(_T_15[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDataDefinition(rt.Message):
    """ReportDataDefinition (0x4701): Tells the types of the data that the picture uses.

    primitive_data_definition_list: 0..65535 items. The fields of the structure, in order
    """

    CODE = 0x4701
    NAME = "ReportDataDefinition"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class ReferenceRec(rt.Struct):
        """ReferenceRec.

        data_structure_reference: Number of the data structure
        """

        data_structure_reference: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("DataStructureReference", rt.Number("H")),
            )

    class PrimitiveDataDefinition(IntEnum):
        """Values of PrimitiveDataDefinition."""

        BYTE = 0
        SHORT_INTEGER = 1
        INTEGER = 2
        LONG_INTEGER = 3
        UNSIGNED_SHORT_INTEGER = 4
        UNSIGNED_INTEGER = 5
        UNSIGNED_LONG_INTEGER = 6
        FLOAT = 7
        LONG_FLOAT = 8
        CHARACTER = 9
        LIST_OF_BYTES = 10
        LIST_OF_SHORT_INTEGERS = 11
        LIST_OF_INTEGERS = 12
        LIST_OF_LONG_INTEGERS = 13
        LIST_OF_UNSIGNED_SHORT_INTEGERS = 14
        LIST_OF_UNSIGNED_INTEGERS = 15
        LIST_OF_UNSIGNED_LONG_INTEGERS = 16
        LIST_OF_FLOATS = 17
        LIST_OF_LONG_FLOATS = 18
        LIST_OF_CHARACTERS = 19

    @dataclass(slots=True, repr=False)
    class PrimitiveDataDefinitionRec(rt.Struct):
        """PrimitiveDataDefinitionRec.

        primitive_data_definition: PrimitiveDataDefinition. Type of one field
        """

        primitive_data_definition: ReportDataDefinition.PrimitiveDataDefinition | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("PrimitiveDataDefinition", rt.Number("B", rt.Values(ReportDataDefinition.PrimitiveDataDefinition))),
            )

    reference_rec: ReportDataDefinition.ReferenceRec
    primitive_data_definition_list: list[ReportDataDefinition.PrimitiveDataDefinitionRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReferenceRec", ReportDataDefinition.ReferenceRec.layout()),
            ("PrimitiveDataDefinitionList", rt.Repeat(rt.Count("H", 0, 65535), ReportDataDefinition.PrimitiveDataDefinitionRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x47: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (data_structure_reference_,) = _S_H.unpack_from(data, 2)
        self.reference_rec = ReportDataDefinition.ReferenceRec(data_structure_reference_)
        (primitive_data_definition_list_count_,) = _S_H.unpack_from(data, 4)
        primitive_data_definition_list_end_ = 6 + primitive_data_definition_list_count_ * 1
        self.primitive_data_definition_list = [ReportDataDefinition.PrimitiveDataDefinitionRec(_E_ReportDataDefinition_PrimitiveDataDefinition[primitive_data_definition_]) for primitive_data_definition_ in _L_B[primitive_data_definition_list_count_].unpack_from(data, 6)]
        if primitive_data_definition_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x47")
        reference_rec_ = self.reference_rec
        if type(reference_rec_) is not ReportDataDefinition.ReferenceRec: raise rt.Reject
        out += _S_H.pack(reference_rec_.data_structure_reference)
        primitive_data_definition_list_ = self.primitive_data_definition_list
        if type(primitive_data_definition_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(primitive_data_definition_list_))
        raw_: list[int | float] = []
        for item_ in primitive_data_definition_list_:
            if type(item_) is not ReportDataDefinition.PrimitiveDataDefinitionRec: raise rt.Reject
            primitive_data_definition_ = item_.primitive_data_definition
            if primitive_data_definition_ not in _E_ReportDataDefinition_PrimitiveDataDefinition: raise rt.Reject
            raw_.append(primitive_data_definition_)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportData(rt.Message):
    """ReportData (0x4702): Tells data that the picture uses.

    data_list: 0..65535 items. The fields of the structure, in order
    """

    CODE = 0x4702
    NAME = "ReportData"
    SERVICE = "urn:jaus:jss:HMI:Drawing"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class ReportDataRec(rt.Struct):
        """ReportDataRec.

        data_structure_reference: Number of the data structure
        """

        data_structure_reference: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("DataStructureReference", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class ByteRec(rt.Struct):
        """ByteRec.

        data: A byte
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("B")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            self.data = data[at]
            return self, at + 1

        def _write(self, out: bytearray) -> None:
            out.append(self.data)

    @dataclass(slots=True, repr=False)
    class ShortIntRec(rt.Struct):
        """ShortIntRec.

        data: A signed 16-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("h")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_h.unpack_from(data, at)
            return self, at + 2

        def _write(self, out: bytearray) -> None:
            out += _S_h.pack(self.data)

    @dataclass(slots=True, repr=False)
    class IntegerRec(rt.Struct):
        """IntegerRec.

        data: A signed 32-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("i")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_i.unpack_from(data, at)
            return self, at + 4

        def _write(self, out: bytearray) -> None:
            out += _S_i.pack(self.data)

    @dataclass(slots=True, repr=False)
    class LongIntRec(rt.Struct):
        """LongIntRec.

        data: A signed 64-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("q")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_q.unpack_from(data, at)
            return self, at + 8

        def _write(self, out: bytearray) -> None:
            out += _S_q.pack(self.data)

    @dataclass(slots=True, repr=False)
    class UShortIntRec(rt.Struct):
        """UShortIntRec.

        data: An unsigned 16-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("H")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_H.unpack_from(data, at)
            return self, at + 2

        def _write(self, out: bytearray) -> None:
            out += _S_H.pack(self.data)

    @dataclass(slots=True, repr=False)
    class UIntegerRec(rt.Struct):
        """UIntegerRec.

        data: An unsigned 32-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("I")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_I.unpack_from(data, at)
            return self, at + 4

        def _write(self, out: bytearray) -> None:
            out += _S_I.pack(self.data)

    @dataclass(slots=True, repr=False)
    class ULongIntRec(rt.Struct):
        """ULongIntRec.

        data: An unsigned 64-bit number
        """

        data: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("Q")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (self.data,) = _S_Q.unpack_from(data, at)
            return self, at + 8

        def _write(self, out: bytearray) -> None:
            out += _S_Q.pack(self.data)

    @dataclass(slots=True, repr=False)
    class FloatRec(rt.Struct):
        """FloatRec.

        data: A 32-bit real number
        """

        data: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("f")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (data_,) = _S_f.unpack_from(data, at)
            if data_ - data_ != 0.0: raise rt.Reject
            self.data = data_
            return self, at + 4

        def _write(self, out: bytearray) -> None:
            data_ = self.data
            if data_ - data_ != 0.0: raise rt.Reject
            out += _S_f.pack(data_)

    @dataclass(slots=True, repr=False)
    class LongFloatRec(rt.Struct):
        """LongFloatRec.

        data: A 64-bit real number
        """

        data: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("Data", rt.Number("d")),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            (data_,) = _S_d.unpack_from(data, at)
            if data_ - data_ != 0.0: raise rt.Reject
            self.data = data_
            return self, at + 8

        def _write(self, out: bytearray) -> None:
            data_ = self.data
            if data_ - data_ != 0.0: raise rt.Reject
            out += _S_d.pack(data_)

    @dataclass(slots=True, repr=False)
    class ByteList(rt.Struct):
        """Bytes.

        byte_list: 0..255 items. Bytes
        """

        byte_list: list[ReportData.ByteRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ByteList", rt.Repeat(rt.Count("B", 0, 255), ReportData.ByteRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            byte_list_count_ = data[at]
            byte_list_end_ = at + 1 + byte_list_count_ * 1
            self.byte_list = [ReportData.ByteRec(data_) for data_ in _L_B[byte_list_count_].unpack_from(data, at + 1)]
            return self, byte_list_end_

        def _write(self, out: bytearray) -> None:
            byte_list_ = self.byte_list
            if type(byte_list_) is not list: raise rt.Reject
            out.append(len(byte_list_))
            raw_: list[int | float] = []
            for item_ in byte_list_:
                if type(item_) is not ReportData.ByteRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_B[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class ShortIntList(rt.Struct):
        """Signed 16-bit numbers.

        short_int_list: 0..255 items. Signed 16-bit numbers
        """

        short_int_list: list[ReportData.ShortIntRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ShortIntList", rt.Repeat(rt.Count("B", 0, 255), ReportData.ShortIntRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            short_int_list_count_ = data[at]
            short_int_list_end_ = at + 1 + short_int_list_count_ * 2
            self.short_int_list = [ReportData.ShortIntRec(data_) for data_ in _L_h[short_int_list_count_].unpack_from(data, at + 1)]
            return self, short_int_list_end_

        def _write(self, out: bytearray) -> None:
            short_int_list_ = self.short_int_list
            if type(short_int_list_) is not list: raise rt.Reject
            out.append(len(short_int_list_))
            raw_: list[int | float] = []
            for item_ in short_int_list_:
                if type(item_) is not ReportData.ShortIntRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_h[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class IntegerList(rt.Struct):
        """Signed 32-bit numbers.

        integer_list: 0..255 items. Signed 32-bit numbers
        """

        integer_list: list[ReportData.IntegerRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("IntegerList", rt.Repeat(rt.Count("B", 0, 255), ReportData.IntegerRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            integer_list_count_ = data[at]
            integer_list_end_ = at + 1 + integer_list_count_ * 4
            self.integer_list = [ReportData.IntegerRec(data_) for data_ in _L_i[integer_list_count_].unpack_from(data, at + 1)]
            return self, integer_list_end_

        def _write(self, out: bytearray) -> None:
            integer_list_ = self.integer_list
            if type(integer_list_) is not list: raise rt.Reject
            out.append(len(integer_list_))
            raw_: list[int | float] = []
            for item_ in integer_list_:
                if type(item_) is not ReportData.IntegerRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_i[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class LongIntList(rt.Struct):
        """Signed 64-bit numbers.

        long_int_list: 0..255 items. Signed 64-bit numbers
        """

        long_int_list: list[ReportData.LongIntRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LongIntList", rt.Repeat(rt.Count("B", 0, 255), ReportData.LongIntRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            long_int_list_count_ = data[at]
            long_int_list_end_ = at + 1 + long_int_list_count_ * 8
            self.long_int_list = [ReportData.LongIntRec(data_) for data_ in _L_q[long_int_list_count_].unpack_from(data, at + 1)]
            return self, long_int_list_end_

        def _write(self, out: bytearray) -> None:
            long_int_list_ = self.long_int_list
            if type(long_int_list_) is not list: raise rt.Reject
            out.append(len(long_int_list_))
            raw_: list[int | float] = []
            for item_ in long_int_list_:
                if type(item_) is not ReportData.LongIntRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_q[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class UShortIntList(rt.Struct):
        """Unsigned 16-bit numbers.

        u_short_int_list: 0..255 items. Unsigned 16-bit numbers
        """

        u_short_int_list: list[ReportData.UShortIntRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UShortIntList", rt.Repeat(rt.Count("B", 0, 255), ReportData.UShortIntRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            u_short_int_list_count_ = data[at]
            u_short_int_list_end_ = at + 1 + u_short_int_list_count_ * 2
            self.u_short_int_list = [ReportData.UShortIntRec(data_) for data_ in _L_H[u_short_int_list_count_].unpack_from(data, at + 1)]
            return self, u_short_int_list_end_

        def _write(self, out: bytearray) -> None:
            u_short_int_list_ = self.u_short_int_list
            if type(u_short_int_list_) is not list: raise rt.Reject
            out.append(len(u_short_int_list_))
            raw_: list[int | float] = []
            for item_ in u_short_int_list_:
                if type(item_) is not ReportData.UShortIntRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_H[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class UIntegerList(rt.Struct):
        """Unsigned 32-bit numbers.

        u_integer_list: 0..255 items. Unsigned 32-bit numbers
        """

        u_integer_list: list[ReportData.UIntegerRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("UIntegerList", rt.Repeat(rt.Count("B", 0, 255), ReportData.UIntegerRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            u_integer_list_count_ = data[at]
            u_integer_list_end_ = at + 1 + u_integer_list_count_ * 4
            self.u_integer_list = [ReportData.UIntegerRec(data_) for data_ in _L_I[u_integer_list_count_].unpack_from(data, at + 1)]
            return self, u_integer_list_end_

        def _write(self, out: bytearray) -> None:
            u_integer_list_ = self.u_integer_list
            if type(u_integer_list_) is not list: raise rt.Reject
            out.append(len(u_integer_list_))
            raw_: list[int | float] = []
            for item_ in u_integer_list_:
                if type(item_) is not ReportData.UIntegerRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_I[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class ULongIntList(rt.Struct):
        """Unsigned 64-bit numbers.

        u_long_int_list: 0..255 items. Unsigned 64-bit numbers
        """

        u_long_int_list: list[ReportData.ULongIntRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ULongIntList", rt.Repeat(rt.Count("B", 0, 255), ReportData.ULongIntRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            u_long_int_list_count_ = data[at]
            u_long_int_list_end_ = at + 1 + u_long_int_list_count_ * 8
            self.u_long_int_list = [ReportData.ULongIntRec(data_) for data_ in _L_Q[u_long_int_list_count_].unpack_from(data, at + 1)]
            return self, u_long_int_list_end_

        def _write(self, out: bytearray) -> None:
            u_long_int_list_ = self.u_long_int_list
            if type(u_long_int_list_) is not list: raise rt.Reject
            out.append(len(u_long_int_list_))
            raw_: list[int | float] = []
            for item_ in u_long_int_list_:
                if type(item_) is not ReportData.ULongIntRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_Q[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class FloatList(rt.Struct):
        """32-bit real numbers.

        float_list: 0..255 items. 32-bit real numbers
        """

        float_list: list[ReportData.FloatRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("FloatList", rt.Repeat(rt.Count("B", 0, 255), ReportData.FloatRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            float_list_count_ = data[at]
            float_list_end_ = at + 1 + float_list_count_ * 4
            float_list_ = []
            for data_ in _L_f[float_list_count_].unpack_from(data, at + 1):
                if data_ - data_ != 0.0: raise rt.Reject
                float_list_.append(ReportData.FloatRec(data_))
            self.float_list = float_list_
            return self, float_list_end_

        def _write(self, out: bytearray) -> None:
            float_list_ = self.float_list
            if type(float_list_) is not list: raise rt.Reject
            out.append(len(float_list_))
            raw_: list[int | float] = []
            for item_ in float_list_:
                if type(item_) is not ReportData.FloatRec: raise rt.Reject
                data_ = item_.data
                if data_ - data_ != 0.0: raise rt.Reject
                raw_.append(data_)
            out += _L_f[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class LongFloatList(rt.Struct):
        """64-bit real numbers.

        long_float_list: 0..255 items. 64-bit real numbers
        """

        long_float_list: list[ReportData.LongFloatRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("LongFloatList", rt.Repeat(rt.Count("B", 0, 255), ReportData.LongFloatRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            long_float_list_count_ = data[at]
            long_float_list_end_ = at + 1 + long_float_list_count_ * 8
            long_float_list_ = []
            for data_ in _L_d[long_float_list_count_].unpack_from(data, at + 1):
                if data_ - data_ != 0.0: raise rt.Reject
                long_float_list_.append(ReportData.LongFloatRec(data_))
            self.long_float_list = long_float_list_
            return self, long_float_list_end_

        def _write(self, out: bytearray) -> None:
            long_float_list_ = self.long_float_list
            if type(long_float_list_) is not list: raise rt.Reject
            out.append(len(long_float_list_))
            raw_: list[int | float] = []
            for item_ in long_float_list_:
                if type(item_) is not ReportData.LongFloatRec: raise rt.Reject
                data_ = item_.data
                if data_ - data_ != 0.0: raise rt.Reject
                raw_.append(data_)
            out += _L_d[len(raw_)].pack(*raw_)

    @dataclass(slots=True, repr=False)
    class CharList(rt.Struct):
        """Characters.

        char_list: 0..255 items. Characters
        """

        char_list: list[ReportData.ByteRec]

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("CharList", rt.Repeat(rt.Count("B", 0, 255), ReportData.ByteRec.layout())),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            char_list_count_ = data[at]
            char_list_end_ = at + 1 + char_list_count_ * 1
            self.char_list = [ReportData.ByteRec(data_) for data_ in _L_B[char_list_count_].unpack_from(data, at + 1)]
            return self, char_list_end_

        def _write(self, out: bytearray) -> None:
            char_list_ = self.char_list
            if type(char_list_) is not list: raise rt.Reject
            out.append(len(char_list_))
            raw_: list[int | float] = []
            for item_ in char_list_:
                if type(item_) is not ReportData.ByteRec: raise rt.Reject
                raw_.append(item_.data)
            out += _L_B[len(raw_)].pack(*raw_)

    report_data_rec: ReportData.ReportDataRec
    data_list: list[ReportData.ByteRec | ReportData.ShortIntRec | ReportData.IntegerRec | ReportData.LongIntRec | ReportData.UShortIntRec | ReportData.UIntegerRec | ReportData.ULongIntRec | ReportData.FloatRec | ReportData.LongFloatRec | ReportData.ByteList | ReportData.ShortIntList | ReportData.IntegerList | ReportData.LongIntList | ReportData.UShortIntList | ReportData.UIntegerList | ReportData.ULongIntList | ReportData.FloatList | ReportData.LongFloatList | ReportData.CharList]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReportDataRec", ReportData.ReportDataRec.layout()),
            ("DataList", rt.Repeat(rt.Count("H", 0, 65535), rt.Union.of("B", byte_rec=ReportData.ByteRec, short_int_rec=ReportData.ShortIntRec, integer_rec=ReportData.IntegerRec, long_int_rec=ReportData.LongIntRec, u_short_int_rec=ReportData.UShortIntRec, u_integer_rec=ReportData.UIntegerRec, u_long_int_rec=ReportData.ULongIntRec, float_rec=ReportData.FloatRec, long_float_rec=ReportData.LongFloatRec, byte_list=ReportData.ByteList, short_int_list=ReportData.ShortIntList, integer_list=ReportData.IntegerList, long_int_list=ReportData.LongIntList, u_short_int_list=ReportData.UShortIntList, u_integer_list=ReportData.UIntegerList, u_long_int_list=ReportData.ULongIntList, float_list=ReportData.FloatList, long_float_list=ReportData.LongFloatList, char_list=ReportData.CharList))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x02 or data[1] != 0x47: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (data_structure_reference_,) = _S_H.unpack_from(data, 2)
        self.report_data_rec = ReportData.ReportDataRec(data_structure_reference_)
        (data_list_count_,) = _S_H.unpack_from(data, 4)
        if data_list_count_ * 2 > size - 6: raise rt.Reject
        at = 6
        data_list_ = []
        for _ in range(data_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_32[tag]._read(data, at, nesting)
            data_list_.append(item_)
        self.data_list = data_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x02\x47")
        report_data_rec_ = self.report_data_rec
        if type(report_data_rec_) is not ReportData.ReportDataRec: raise rt.Reject
        out += _S_H.pack(report_data_rec_.data_structure_reference)
        data_list_ = self.data_list
        if type(data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(data_list_))
        for item_ in data_list_:
            out.append(_T_33[type(item_)])
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_S_2H = rt.Packer("<2H")
_S_i = rt.Packer("<i")
_U_3: tuple[type[ReportDrawingDefinition.Literal] | type[ReportDrawingDefinition.Reference], ...] = (ReportDrawingDefinition.Literal, ReportDrawingDefinition.Reference)
_T_4: dict[type[rt.Struct], int] = {ReportDrawingDefinition.Literal: 0, ReportDrawingDefinition.Reference: 1}
_S_3b = rt.Packer("<3b")
_S_b = rt.Packer("<b")
_E_ReportDrawingDefinition_Group = rt.members(ReportDrawingDefinition.Group)
_S_H2b12s = rt.Packer("<H2b12s")
_S_b12s = rt.Packer("<b12s")
_E_ReportDrawingDefinition_Alignment = rt.members(ReportDrawingDefinition.Alignment)
_U_11: tuple[type[ReportDrawingDefinition.Empty0] | type[ReportDrawingDefinition.Empty1] | type[ReportDrawingDefinition.Empty2] | type[ReportDrawingDefinition.Empty3] | type[ReportDrawingDefinition.Empty4] | type[ReportDrawingDefinition.Empty5] | type[ReportDrawingDefinition.Empty6] | type[ReportDrawingDefinition.Empty7] | type[ReportDrawingDefinition.Empty8] | type[ReportDrawingDefinition.Empty9] | type[ReportDrawingDefinition.Empty10] | type[ReportDrawingDefinition.Empty11] | type[ReportDrawingDefinition.Empty12] | type[ReportDrawingDefinition.Empty13] | type[ReportDrawingDefinition.Empty14] | type[ReportDrawingDefinition.Empty15] | type[ReportDrawingDefinition.Empty16] | type[ReportDrawingDefinition.Empty17] | type[ReportDrawingDefinition.Empty18] | type[ReportDrawingDefinition.Empty19] | type[ReportDrawingDefinition.Empty20] | type[ReportDrawingDefinition.Empty21] | type[ReportDrawingDefinition.Empty22] | type[ReportDrawingDefinition.Empty23] | type[ReportDrawingDefinition.Empty24] | type[ReportDrawingDefinition.Empty25] | type[ReportDrawingDefinition.Empty26] | type[ReportDrawingDefinition.Empty27] | type[ReportDrawingDefinition.Empty28] | type[ReportDrawingDefinition.Empty29] | type[ReportDrawingDefinition.Empty30] | type[ReportDrawingDefinition.Empty31] | type[ReportDrawingDefinition.Empty32] | type[ReportDrawingDefinition.Empty33] | type[ReportDrawingDefinition.Empty34] | type[ReportDrawingDefinition.Empty35] | type[ReportDrawingDefinition.Empty36] | type[ReportDrawingDefinition.Empty37] | type[ReportDrawingDefinition.Empty38] | type[ReportDrawingDefinition.Empty39] | type[ReportDrawingDefinition.Empty40] | type[ReportDrawingDefinition.Empty41] | type[ReportDrawingDefinition.Empty42] | type[ReportDrawingDefinition.Empty43] | type[ReportDrawingDefinition.Empty44] | type[ReportDrawingDefinition.Empty45] | type[ReportDrawingDefinition.Empty46] | type[ReportDrawingDefinition.Empty47] | type[ReportDrawingDefinition.Empty48] | type[ReportDrawingDefinition.Empty49] | type[ReportDrawingDefinition.Empty50] | type[ReportDrawingDefinition.Empty51] | type[ReportDrawingDefinition.Empty52] | type[ReportDrawingDefinition.Empty53] | type[ReportDrawingDefinition.Empty54] | type[ReportDrawingDefinition.Empty55] | type[ReportDrawingDefinition.Empty56] | type[ReportDrawingDefinition.Empty57] | type[ReportDrawingDefinition.Empty58] | type[ReportDrawingDefinition.Empty59] | type[ReportDrawingDefinition.Empty60] | type[ReportDrawingDefinition.Empty61] | type[ReportDrawingDefinition.Empty62] | type[ReportDrawingDefinition.Empty63] | type[ReportDrawingDefinition.Empty64] | type[ReportDrawingDefinition.Empty65] | type[ReportDrawingDefinition.Empty66] | type[ReportDrawingDefinition.Empty67] | type[ReportDrawingDefinition.Empty68] | type[ReportDrawingDefinition.Empty69] | type[ReportDrawingDefinition.Empty70] | type[ReportDrawingDefinition.Empty71] | type[ReportDrawingDefinition.Empty72] | type[ReportDrawingDefinition.Empty73] | type[ReportDrawingDefinition.Empty74] | type[ReportDrawingDefinition.Empty75] | type[ReportDrawingDefinition.Empty76] | type[ReportDrawingDefinition.Empty77] | type[ReportDrawingDefinition.Empty78] | type[ReportDrawingDefinition.Empty79] | type[ReportDrawingDefinition.Empty80] | type[ReportDrawingDefinition.Empty81] | type[ReportDrawingDefinition.Empty82] | type[ReportDrawingDefinition.Empty83] | type[ReportDrawingDefinition.Empty84] | type[ReportDrawingDefinition.Empty85] | type[ReportDrawingDefinition.Empty86] | type[ReportDrawingDefinition.Empty87] | type[ReportDrawingDefinition.Empty88] | type[ReportDrawingDefinition.Empty89] | type[ReportDrawingDefinition.Empty90] | type[ReportDrawingDefinition.Empty91] | type[ReportDrawingDefinition.Empty92] | type[ReportDrawingDefinition.Empty93] | type[ReportDrawingDefinition.Empty94] | type[ReportDrawingDefinition.Empty95] | type[ReportDrawingDefinition.Empty96] | type[ReportDrawingDefinition.Empty97] | type[ReportDrawingDefinition.Empty98] | type[ReportDrawingDefinition.Empty99] | type[ReportDrawingDefinition.Empty100] | type[ReportDrawingDefinition.Empty101] | type[ReportDrawingDefinition.Empty102] | type[ReportDrawingDefinition.Empty103] | type[ReportDrawingDefinition.Empty104] | type[ReportDrawingDefinition.Empty105] | type[ReportDrawingDefinition.Empty106] | type[ReportDrawingDefinition.Empty107] | type[ReportDrawingDefinition.Empty108] | type[ReportDrawingDefinition.Empty109] | type[ReportDrawingDefinition.Empty110] | type[ReportDrawingDefinition.Empty111] | type[ReportDrawingDefinition.Empty112] | type[ReportDrawingDefinition.Empty113] | type[ReportDrawingDefinition.Empty114] | type[ReportDrawingDefinition.Empty115] | type[ReportDrawingDefinition.Empty116] | type[ReportDrawingDefinition.Empty117] | type[ReportDrawingDefinition.Empty118] | type[ReportDrawingDefinition.Empty119] | type[ReportDrawingDefinition.Empty120] | type[ReportDrawingDefinition.Empty121] | type[ReportDrawingDefinition.Empty122] | type[ReportDrawingDefinition.Empty123] | type[ReportDrawingDefinition.Empty124] | type[ReportDrawingDefinition.Empty125] | type[ReportDrawingDefinition.Empty126] | type[ReportDrawingDefinition.Empty127] | type[ReportDrawingDefinition.Empty128] | type[ReportDrawingDefinition.Empty129] | type[ReportDrawingDefinition.Empty130] | type[ReportDrawingDefinition.Empty131] | type[ReportDrawingDefinition.Empty132] | type[ReportDrawingDefinition.Empty133] | type[ReportDrawingDefinition.Empty134] | type[ReportDrawingDefinition.Empty135] | type[ReportDrawingDefinition.Empty136] | type[ReportDrawingDefinition.Empty137] | type[ReportDrawingDefinition.Empty138] | type[ReportDrawingDefinition.Empty139] | type[ReportDrawingDefinition.Empty140] | type[ReportDrawingDefinition.Empty141] | type[ReportDrawingDefinition.Empty142] | type[ReportDrawingDefinition.Empty143] | type[ReportDrawingDefinition.Empty144] | type[ReportDrawingDefinition.Empty145] | type[ReportDrawingDefinition.Empty146] | type[ReportDrawingDefinition.Empty147] | type[ReportDrawingDefinition.Empty148] | type[ReportDrawingDefinition.Empty149] | type[ReportDrawingDefinition.Empty150] | type[ReportDrawingDefinition.Empty151] | type[ReportDrawingDefinition.Empty152] | type[ReportDrawingDefinition.Empty153] | type[ReportDrawingDefinition.Empty154] | type[ReportDrawingDefinition.Empty155] | type[ReportDrawingDefinition.Empty156] | type[ReportDrawingDefinition.Empty157] | type[ReportDrawingDefinition.Empty158] | type[ReportDrawingDefinition.Empty159] | type[ReportDrawingDefinition.Empty160] | type[ReportDrawingDefinition.Empty161] | type[ReportDrawingDefinition.Empty162] | type[ReportDrawingDefinition.Empty163] | type[ReportDrawingDefinition.Empty164] | type[ReportDrawingDefinition.Empty165] | type[ReportDrawingDefinition.Empty166] | type[ReportDrawingDefinition.Empty167] | type[ReportDrawingDefinition.Empty168] | type[ReportDrawingDefinition.Empty169] | type[ReportDrawingDefinition.Empty170] | type[ReportDrawingDefinition.Empty171] | type[ReportDrawingDefinition.Empty172] | type[ReportDrawingDefinition.Empty173] | type[ReportDrawingDefinition.Empty174] | type[ReportDrawingDefinition.Empty175] | type[ReportDrawingDefinition.Empty176] | type[ReportDrawingDefinition.Empty177] | type[ReportDrawingDefinition.Empty178] | type[ReportDrawingDefinition.Empty179] | type[ReportDrawingDefinition.Empty180] | type[ReportDrawingDefinition.Empty181] | type[ReportDrawingDefinition.Empty182] | type[ReportDrawingDefinition.Empty183] | type[ReportDrawingDefinition.Empty184] | type[ReportDrawingDefinition.Empty185] | type[ReportDrawingDefinition.Empty186] | type[ReportDrawingDefinition.Empty187] | type[ReportDrawingDefinition.Empty188] | type[ReportDrawingDefinition.Empty189] | type[ReportDrawingDefinition.Empty190] | type[ReportDrawingDefinition.Empty191] | type[ReportDrawingDefinition.Empty192] | type[ReportDrawingDefinition.Empty193] | type[ReportDrawingDefinition.Empty194] | type[ReportDrawingDefinition.Empty195] | type[ReportDrawingDefinition.Empty196] | type[ReportDrawingDefinition.Empty197] | type[ReportDrawingDefinition.Empty198] | type[ReportDrawingDefinition.Empty199] | type[ReportDrawingDefinition.Empty200] | type[ReportDrawingDefinition.Empty201] | type[ReportDrawingDefinition.Empty202] | type[ReportDrawingDefinition.Empty203] | type[ReportDrawingDefinition.Empty204] | type[ReportDrawingDefinition.Empty205] | type[ReportDrawingDefinition.Empty206] | type[ReportDrawingDefinition.Empty207] | type[ReportDrawingDefinition.Empty208] | type[ReportDrawingDefinition.Empty209] | type[ReportDrawingDefinition.Empty210] | type[ReportDrawingDefinition.Empty211] | type[ReportDrawingDefinition.Empty212] | type[ReportDrawingDefinition.Empty213] | type[ReportDrawingDefinition.Empty214] | type[ReportDrawingDefinition.Empty215] | type[ReportDrawingDefinition.Empty216] | type[ReportDrawingDefinition.Empty217] | type[ReportDrawingDefinition.Empty218] | type[ReportDrawingDefinition.Empty219] | type[ReportDrawingDefinition.Empty220] | type[ReportDrawingDefinition.Empty221] | type[ReportDrawingDefinition.Empty222] | type[ReportDrawingDefinition.Empty223] | type[ReportDrawingDefinition.Empty224] | type[ReportDrawingDefinition.Empty225] | type[ReportDrawingDefinition.Empty226] | type[ReportDrawingDefinition.Empty227] | type[ReportDrawingDefinition.Empty228] | type[ReportDrawingDefinition.Empty229] | type[ReportDrawingDefinition.Empty230] | type[ReportDrawingDefinition.Empty231] | type[ReportDrawingDefinition.Empty232] | type[ReportDrawingDefinition.Empty233] | type[ReportDrawingDefinition.Empty234] | type[ReportDrawingDefinition.Empty235] | type[ReportDrawingDefinition.Empty236] | type[ReportDrawingDefinition.Empty237] | type[ReportDrawingDefinition.Empty238] | type[ReportDrawingDefinition.Empty239] | type[ReportDrawingDefinition.Empty240] | type[ReportDrawingDefinition.Empty241] | type[ReportDrawingDefinition.Empty242] | type[ReportDrawingDefinition.Empty243] | type[ReportDrawingDefinition.Empty244] | type[ReportDrawingDefinition.Empty245] | type[ReportDrawingDefinition.Empty246] | type[ReportDrawingDefinition.Empty247] | type[ReportDrawingDefinition.Empty248] | type[ReportDrawingDefinition.Empty249] | type[ReportDrawingDefinition.Empty250] | type[ReportDrawingDefinition.Empty251] | type[ReportDrawingDefinition.Empty252] | type[ReportDrawingDefinition.Empty253] | type[ReportDrawingDefinition.Empty254] | type[ReportDrawingDefinition.Empty255], ...] = (ReportDrawingDefinition.Empty0, ReportDrawingDefinition.Empty1, ReportDrawingDefinition.Empty2, ReportDrawingDefinition.Empty3, ReportDrawingDefinition.Empty4, ReportDrawingDefinition.Empty5, ReportDrawingDefinition.Empty6, ReportDrawingDefinition.Empty7, ReportDrawingDefinition.Empty8, ReportDrawingDefinition.Empty9, ReportDrawingDefinition.Empty10, ReportDrawingDefinition.Empty11, ReportDrawingDefinition.Empty12, ReportDrawingDefinition.Empty13, ReportDrawingDefinition.Empty14, ReportDrawingDefinition.Empty15, ReportDrawingDefinition.Empty16, ReportDrawingDefinition.Empty17, ReportDrawingDefinition.Empty18, ReportDrawingDefinition.Empty19, ReportDrawingDefinition.Empty20, ReportDrawingDefinition.Empty21, ReportDrawingDefinition.Empty22, ReportDrawingDefinition.Empty23, ReportDrawingDefinition.Empty24, ReportDrawingDefinition.Empty25, ReportDrawingDefinition.Empty26, ReportDrawingDefinition.Empty27, ReportDrawingDefinition.Empty28, ReportDrawingDefinition.Empty29, ReportDrawingDefinition.Empty30, ReportDrawingDefinition.Empty31, ReportDrawingDefinition.Empty32, ReportDrawingDefinition.Empty33, ReportDrawingDefinition.Empty34, ReportDrawingDefinition.Empty35, ReportDrawingDefinition.Empty36, ReportDrawingDefinition.Empty37, ReportDrawingDefinition.Empty38, ReportDrawingDefinition.Empty39, ReportDrawingDefinition.Empty40, ReportDrawingDefinition.Empty41, ReportDrawingDefinition.Empty42, ReportDrawingDefinition.Empty43, ReportDrawingDefinition.Empty44, ReportDrawingDefinition.Empty45, ReportDrawingDefinition.Empty46, ReportDrawingDefinition.Empty47, ReportDrawingDefinition.Empty48, ReportDrawingDefinition.Empty49, ReportDrawingDefinition.Empty50, ReportDrawingDefinition.Empty51, ReportDrawingDefinition.Empty52, ReportDrawingDefinition.Empty53, ReportDrawingDefinition.Empty54, ReportDrawingDefinition.Empty55, ReportDrawingDefinition.Empty56, ReportDrawingDefinition.Empty57, ReportDrawingDefinition.Empty58, ReportDrawingDefinition.Empty59, ReportDrawingDefinition.Empty60, ReportDrawingDefinition.Empty61, ReportDrawingDefinition.Empty62, ReportDrawingDefinition.Empty63, ReportDrawingDefinition.Empty64, ReportDrawingDefinition.Empty65, ReportDrawingDefinition.Empty66, ReportDrawingDefinition.Empty67, ReportDrawingDefinition.Empty68, ReportDrawingDefinition.Empty69, ReportDrawingDefinition.Empty70, ReportDrawingDefinition.Empty71, ReportDrawingDefinition.Empty72, ReportDrawingDefinition.Empty73, ReportDrawingDefinition.Empty74, ReportDrawingDefinition.Empty75, ReportDrawingDefinition.Empty76, ReportDrawingDefinition.Empty77, ReportDrawingDefinition.Empty78, ReportDrawingDefinition.Empty79, ReportDrawingDefinition.Empty80, ReportDrawingDefinition.Empty81, ReportDrawingDefinition.Empty82, ReportDrawingDefinition.Empty83, ReportDrawingDefinition.Empty84, ReportDrawingDefinition.Empty85, ReportDrawingDefinition.Empty86, ReportDrawingDefinition.Empty87, ReportDrawingDefinition.Empty88, ReportDrawingDefinition.Empty89, ReportDrawingDefinition.Empty90, ReportDrawingDefinition.Empty91, ReportDrawingDefinition.Empty92, ReportDrawingDefinition.Empty93, ReportDrawingDefinition.Empty94, ReportDrawingDefinition.Empty95, ReportDrawingDefinition.Empty96, ReportDrawingDefinition.Empty97, ReportDrawingDefinition.Empty98, ReportDrawingDefinition.Empty99, ReportDrawingDefinition.Empty100, ReportDrawingDefinition.Empty101, ReportDrawingDefinition.Empty102, ReportDrawingDefinition.Empty103, ReportDrawingDefinition.Empty104, ReportDrawingDefinition.Empty105, ReportDrawingDefinition.Empty106, ReportDrawingDefinition.Empty107, ReportDrawingDefinition.Empty108, ReportDrawingDefinition.Empty109, ReportDrawingDefinition.Empty110, ReportDrawingDefinition.Empty111, ReportDrawingDefinition.Empty112, ReportDrawingDefinition.Empty113, ReportDrawingDefinition.Empty114, ReportDrawingDefinition.Empty115, ReportDrawingDefinition.Empty116, ReportDrawingDefinition.Empty117, ReportDrawingDefinition.Empty118, ReportDrawingDefinition.Empty119, ReportDrawingDefinition.Empty120, ReportDrawingDefinition.Empty121, ReportDrawingDefinition.Empty122, ReportDrawingDefinition.Empty123, ReportDrawingDefinition.Empty124, ReportDrawingDefinition.Empty125, ReportDrawingDefinition.Empty126, ReportDrawingDefinition.Empty127, ReportDrawingDefinition.Empty128, ReportDrawingDefinition.Empty129, ReportDrawingDefinition.Empty130, ReportDrawingDefinition.Empty131, ReportDrawingDefinition.Empty132, ReportDrawingDefinition.Empty133, ReportDrawingDefinition.Empty134, ReportDrawingDefinition.Empty135, ReportDrawingDefinition.Empty136, ReportDrawingDefinition.Empty137, ReportDrawingDefinition.Empty138, ReportDrawingDefinition.Empty139, ReportDrawingDefinition.Empty140, ReportDrawingDefinition.Empty141, ReportDrawingDefinition.Empty142, ReportDrawingDefinition.Empty143, ReportDrawingDefinition.Empty144, ReportDrawingDefinition.Empty145, ReportDrawingDefinition.Empty146, ReportDrawingDefinition.Empty147, ReportDrawingDefinition.Empty148, ReportDrawingDefinition.Empty149, ReportDrawingDefinition.Empty150, ReportDrawingDefinition.Empty151, ReportDrawingDefinition.Empty152, ReportDrawingDefinition.Empty153, ReportDrawingDefinition.Empty154, ReportDrawingDefinition.Empty155, ReportDrawingDefinition.Empty156, ReportDrawingDefinition.Empty157, ReportDrawingDefinition.Empty158, ReportDrawingDefinition.Empty159, ReportDrawingDefinition.Empty160, ReportDrawingDefinition.Empty161, ReportDrawingDefinition.Empty162, ReportDrawingDefinition.Empty163, ReportDrawingDefinition.Empty164, ReportDrawingDefinition.Empty165, ReportDrawingDefinition.Empty166, ReportDrawingDefinition.Empty167, ReportDrawingDefinition.Empty168, ReportDrawingDefinition.Empty169, ReportDrawingDefinition.Empty170, ReportDrawingDefinition.Empty171, ReportDrawingDefinition.Empty172, ReportDrawingDefinition.Empty173, ReportDrawingDefinition.Empty174, ReportDrawingDefinition.Empty175, ReportDrawingDefinition.Empty176, ReportDrawingDefinition.Empty177, ReportDrawingDefinition.Empty178, ReportDrawingDefinition.Empty179, ReportDrawingDefinition.Empty180, ReportDrawingDefinition.Empty181, ReportDrawingDefinition.Empty182, ReportDrawingDefinition.Empty183, ReportDrawingDefinition.Empty184, ReportDrawingDefinition.Empty185, ReportDrawingDefinition.Empty186, ReportDrawingDefinition.Empty187, ReportDrawingDefinition.Empty188, ReportDrawingDefinition.Empty189, ReportDrawingDefinition.Empty190, ReportDrawingDefinition.Empty191, ReportDrawingDefinition.Empty192, ReportDrawingDefinition.Empty193, ReportDrawingDefinition.Empty194, ReportDrawingDefinition.Empty195, ReportDrawingDefinition.Empty196, ReportDrawingDefinition.Empty197, ReportDrawingDefinition.Empty198, ReportDrawingDefinition.Empty199, ReportDrawingDefinition.Empty200, ReportDrawingDefinition.Empty201, ReportDrawingDefinition.Empty202, ReportDrawingDefinition.Empty203, ReportDrawingDefinition.Empty204, ReportDrawingDefinition.Empty205, ReportDrawingDefinition.Empty206, ReportDrawingDefinition.Empty207, ReportDrawingDefinition.Empty208, ReportDrawingDefinition.Empty209, ReportDrawingDefinition.Empty210, ReportDrawingDefinition.Empty211, ReportDrawingDefinition.Empty212, ReportDrawingDefinition.Empty213, ReportDrawingDefinition.Empty214, ReportDrawingDefinition.Empty215, ReportDrawingDefinition.Empty216, ReportDrawingDefinition.Empty217, ReportDrawingDefinition.Empty218, ReportDrawingDefinition.Empty219, ReportDrawingDefinition.Empty220, ReportDrawingDefinition.Empty221, ReportDrawingDefinition.Empty222, ReportDrawingDefinition.Empty223, ReportDrawingDefinition.Empty224, ReportDrawingDefinition.Empty225, ReportDrawingDefinition.Empty226, ReportDrawingDefinition.Empty227, ReportDrawingDefinition.Empty228, ReportDrawingDefinition.Empty229, ReportDrawingDefinition.Empty230, ReportDrawingDefinition.Empty231, ReportDrawingDefinition.Empty232, ReportDrawingDefinition.Empty233, ReportDrawingDefinition.Empty234, ReportDrawingDefinition.Empty235, ReportDrawingDefinition.Empty236, ReportDrawingDefinition.Empty237, ReportDrawingDefinition.Empty238, ReportDrawingDefinition.Empty239, ReportDrawingDefinition.Empty240, ReportDrawingDefinition.Empty241, ReportDrawingDefinition.Empty242, ReportDrawingDefinition.Empty243, ReportDrawingDefinition.Empty244, ReportDrawingDefinition.Empty245, ReportDrawingDefinition.Empty246, ReportDrawingDefinition.Empty247, ReportDrawingDefinition.Empty248, ReportDrawingDefinition.Empty249, ReportDrawingDefinition.Empty250, ReportDrawingDefinition.Empty251, ReportDrawingDefinition.Empty252, ReportDrawingDefinition.Empty253, ReportDrawingDefinition.Empty254, ReportDrawingDefinition.Empty255)
_T_12: dict[type[rt.Struct], int] = {ReportDrawingDefinition.Empty0: 0, ReportDrawingDefinition.Empty1: 1, ReportDrawingDefinition.Empty2: 2, ReportDrawingDefinition.Empty3: 3, ReportDrawingDefinition.Empty4: 4, ReportDrawingDefinition.Empty5: 5, ReportDrawingDefinition.Empty6: 6, ReportDrawingDefinition.Empty7: 7, ReportDrawingDefinition.Empty8: 8, ReportDrawingDefinition.Empty9: 9, ReportDrawingDefinition.Empty10: 10, ReportDrawingDefinition.Empty11: 11, ReportDrawingDefinition.Empty12: 12, ReportDrawingDefinition.Empty13: 13, ReportDrawingDefinition.Empty14: 14, ReportDrawingDefinition.Empty15: 15, ReportDrawingDefinition.Empty16: 16, ReportDrawingDefinition.Empty17: 17, ReportDrawingDefinition.Empty18: 18, ReportDrawingDefinition.Empty19: 19, ReportDrawingDefinition.Empty20: 20, ReportDrawingDefinition.Empty21: 21, ReportDrawingDefinition.Empty22: 22, ReportDrawingDefinition.Empty23: 23, ReportDrawingDefinition.Empty24: 24, ReportDrawingDefinition.Empty25: 25, ReportDrawingDefinition.Empty26: 26, ReportDrawingDefinition.Empty27: 27, ReportDrawingDefinition.Empty28: 28, ReportDrawingDefinition.Empty29: 29, ReportDrawingDefinition.Empty30: 30, ReportDrawingDefinition.Empty31: 31, ReportDrawingDefinition.Empty32: 32, ReportDrawingDefinition.Empty33: 33, ReportDrawingDefinition.Empty34: 34, ReportDrawingDefinition.Empty35: 35, ReportDrawingDefinition.Empty36: 36, ReportDrawingDefinition.Empty37: 37, ReportDrawingDefinition.Empty38: 38, ReportDrawingDefinition.Empty39: 39, ReportDrawingDefinition.Empty40: 40, ReportDrawingDefinition.Empty41: 41, ReportDrawingDefinition.Empty42: 42, ReportDrawingDefinition.Empty43: 43, ReportDrawingDefinition.Empty44: 44, ReportDrawingDefinition.Empty45: 45, ReportDrawingDefinition.Empty46: 46, ReportDrawingDefinition.Empty47: 47, ReportDrawingDefinition.Empty48: 48, ReportDrawingDefinition.Empty49: 49, ReportDrawingDefinition.Empty50: 50, ReportDrawingDefinition.Empty51: 51, ReportDrawingDefinition.Empty52: 52, ReportDrawingDefinition.Empty53: 53, ReportDrawingDefinition.Empty54: 54, ReportDrawingDefinition.Empty55: 55, ReportDrawingDefinition.Empty56: 56, ReportDrawingDefinition.Empty57: 57, ReportDrawingDefinition.Empty58: 58, ReportDrawingDefinition.Empty59: 59, ReportDrawingDefinition.Empty60: 60, ReportDrawingDefinition.Empty61: 61, ReportDrawingDefinition.Empty62: 62, ReportDrawingDefinition.Empty63: 63, ReportDrawingDefinition.Empty64: 64, ReportDrawingDefinition.Empty65: 65, ReportDrawingDefinition.Empty66: 66, ReportDrawingDefinition.Empty67: 67, ReportDrawingDefinition.Empty68: 68, ReportDrawingDefinition.Empty69: 69, ReportDrawingDefinition.Empty70: 70, ReportDrawingDefinition.Empty71: 71, ReportDrawingDefinition.Empty72: 72, ReportDrawingDefinition.Empty73: 73, ReportDrawingDefinition.Empty74: 74, ReportDrawingDefinition.Empty75: 75, ReportDrawingDefinition.Empty76: 76, ReportDrawingDefinition.Empty77: 77, ReportDrawingDefinition.Empty78: 78, ReportDrawingDefinition.Empty79: 79, ReportDrawingDefinition.Empty80: 80, ReportDrawingDefinition.Empty81: 81, ReportDrawingDefinition.Empty82: 82, ReportDrawingDefinition.Empty83: 83, ReportDrawingDefinition.Empty84: 84, ReportDrawingDefinition.Empty85: 85, ReportDrawingDefinition.Empty86: 86, ReportDrawingDefinition.Empty87: 87, ReportDrawingDefinition.Empty88: 88, ReportDrawingDefinition.Empty89: 89, ReportDrawingDefinition.Empty90: 90, ReportDrawingDefinition.Empty91: 91, ReportDrawingDefinition.Empty92: 92, ReportDrawingDefinition.Empty93: 93, ReportDrawingDefinition.Empty94: 94, ReportDrawingDefinition.Empty95: 95, ReportDrawingDefinition.Empty96: 96, ReportDrawingDefinition.Empty97: 97, ReportDrawingDefinition.Empty98: 98, ReportDrawingDefinition.Empty99: 99, ReportDrawingDefinition.Empty100: 100, ReportDrawingDefinition.Empty101: 101, ReportDrawingDefinition.Empty102: 102, ReportDrawingDefinition.Empty103: 103, ReportDrawingDefinition.Empty104: 104, ReportDrawingDefinition.Empty105: 105, ReportDrawingDefinition.Empty106: 106, ReportDrawingDefinition.Empty107: 107, ReportDrawingDefinition.Empty108: 108, ReportDrawingDefinition.Empty109: 109, ReportDrawingDefinition.Empty110: 110, ReportDrawingDefinition.Empty111: 111, ReportDrawingDefinition.Empty112: 112, ReportDrawingDefinition.Empty113: 113, ReportDrawingDefinition.Empty114: 114, ReportDrawingDefinition.Empty115: 115, ReportDrawingDefinition.Empty116: 116, ReportDrawingDefinition.Empty117: 117, ReportDrawingDefinition.Empty118: 118, ReportDrawingDefinition.Empty119: 119, ReportDrawingDefinition.Empty120: 120, ReportDrawingDefinition.Empty121: 121, ReportDrawingDefinition.Empty122: 122, ReportDrawingDefinition.Empty123: 123, ReportDrawingDefinition.Empty124: 124, ReportDrawingDefinition.Empty125: 125, ReportDrawingDefinition.Empty126: 126, ReportDrawingDefinition.Empty127: 127, ReportDrawingDefinition.Empty128: 128, ReportDrawingDefinition.Empty129: 129, ReportDrawingDefinition.Empty130: 130, ReportDrawingDefinition.Empty131: 131, ReportDrawingDefinition.Empty132: 132, ReportDrawingDefinition.Empty133: 133, ReportDrawingDefinition.Empty134: 134, ReportDrawingDefinition.Empty135: 135, ReportDrawingDefinition.Empty136: 136, ReportDrawingDefinition.Empty137: 137, ReportDrawingDefinition.Empty138: 138, ReportDrawingDefinition.Empty139: 139, ReportDrawingDefinition.Empty140: 140, ReportDrawingDefinition.Empty141: 141, ReportDrawingDefinition.Empty142: 142, ReportDrawingDefinition.Empty143: 143, ReportDrawingDefinition.Empty144: 144, ReportDrawingDefinition.Empty145: 145, ReportDrawingDefinition.Empty146: 146, ReportDrawingDefinition.Empty147: 147, ReportDrawingDefinition.Empty148: 148, ReportDrawingDefinition.Empty149: 149, ReportDrawingDefinition.Empty150: 150, ReportDrawingDefinition.Empty151: 151, ReportDrawingDefinition.Empty152: 152, ReportDrawingDefinition.Empty153: 153, ReportDrawingDefinition.Empty154: 154, ReportDrawingDefinition.Empty155: 155, ReportDrawingDefinition.Empty156: 156, ReportDrawingDefinition.Empty157: 157, ReportDrawingDefinition.Empty158: 158, ReportDrawingDefinition.Empty159: 159, ReportDrawingDefinition.Empty160: 160, ReportDrawingDefinition.Empty161: 161, ReportDrawingDefinition.Empty162: 162, ReportDrawingDefinition.Empty163: 163, ReportDrawingDefinition.Empty164: 164, ReportDrawingDefinition.Empty165: 165, ReportDrawingDefinition.Empty166: 166, ReportDrawingDefinition.Empty167: 167, ReportDrawingDefinition.Empty168: 168, ReportDrawingDefinition.Empty169: 169, ReportDrawingDefinition.Empty170: 170, ReportDrawingDefinition.Empty171: 171, ReportDrawingDefinition.Empty172: 172, ReportDrawingDefinition.Empty173: 173, ReportDrawingDefinition.Empty174: 174, ReportDrawingDefinition.Empty175: 175, ReportDrawingDefinition.Empty176: 176, ReportDrawingDefinition.Empty177: 177, ReportDrawingDefinition.Empty178: 178, ReportDrawingDefinition.Empty179: 179, ReportDrawingDefinition.Empty180: 180, ReportDrawingDefinition.Empty181: 181, ReportDrawingDefinition.Empty182: 182, ReportDrawingDefinition.Empty183: 183, ReportDrawingDefinition.Empty184: 184, ReportDrawingDefinition.Empty185: 185, ReportDrawingDefinition.Empty186: 186, ReportDrawingDefinition.Empty187: 187, ReportDrawingDefinition.Empty188: 188, ReportDrawingDefinition.Empty189: 189, ReportDrawingDefinition.Empty190: 190, ReportDrawingDefinition.Empty191: 191, ReportDrawingDefinition.Empty192: 192, ReportDrawingDefinition.Empty193: 193, ReportDrawingDefinition.Empty194: 194, ReportDrawingDefinition.Empty195: 195, ReportDrawingDefinition.Empty196: 196, ReportDrawingDefinition.Empty197: 197, ReportDrawingDefinition.Empty198: 198, ReportDrawingDefinition.Empty199: 199, ReportDrawingDefinition.Empty200: 200, ReportDrawingDefinition.Empty201: 201, ReportDrawingDefinition.Empty202: 202, ReportDrawingDefinition.Empty203: 203, ReportDrawingDefinition.Empty204: 204, ReportDrawingDefinition.Empty205: 205, ReportDrawingDefinition.Empty206: 206, ReportDrawingDefinition.Empty207: 207, ReportDrawingDefinition.Empty208: 208, ReportDrawingDefinition.Empty209: 209, ReportDrawingDefinition.Empty210: 210, ReportDrawingDefinition.Empty211: 211, ReportDrawingDefinition.Empty212: 212, ReportDrawingDefinition.Empty213: 213, ReportDrawingDefinition.Empty214: 214, ReportDrawingDefinition.Empty215: 215, ReportDrawingDefinition.Empty216: 216, ReportDrawingDefinition.Empty217: 217, ReportDrawingDefinition.Empty218: 218, ReportDrawingDefinition.Empty219: 219, ReportDrawingDefinition.Empty220: 220, ReportDrawingDefinition.Empty221: 221, ReportDrawingDefinition.Empty222: 222, ReportDrawingDefinition.Empty223: 223, ReportDrawingDefinition.Empty224: 224, ReportDrawingDefinition.Empty225: 225, ReportDrawingDefinition.Empty226: 226, ReportDrawingDefinition.Empty227: 227, ReportDrawingDefinition.Empty228: 228, ReportDrawingDefinition.Empty229: 229, ReportDrawingDefinition.Empty230: 230, ReportDrawingDefinition.Empty231: 231, ReportDrawingDefinition.Empty232: 232, ReportDrawingDefinition.Empty233: 233, ReportDrawingDefinition.Empty234: 234, ReportDrawingDefinition.Empty235: 235, ReportDrawingDefinition.Empty236: 236, ReportDrawingDefinition.Empty237: 237, ReportDrawingDefinition.Empty238: 238, ReportDrawingDefinition.Empty239: 239, ReportDrawingDefinition.Empty240: 240, ReportDrawingDefinition.Empty241: 241, ReportDrawingDefinition.Empty242: 242, ReportDrawingDefinition.Empty243: 243, ReportDrawingDefinition.Empty244: 244, ReportDrawingDefinition.Empty245: 245, ReportDrawingDefinition.Empty246: 246, ReportDrawingDefinition.Empty247: 247, ReportDrawingDefinition.Empty248: 248, ReportDrawingDefinition.Empty249: 249, ReportDrawingDefinition.Empty250: 250, ReportDrawingDefinition.Empty251: 251, ReportDrawingDefinition.Empty252: 252, ReportDrawingDefinition.Empty253: 253, ReportDrawingDefinition.Empty254: 254, ReportDrawingDefinition.Empty255: 255}
_E_ReportDrawingDefinition_ImageType = rt.members(ReportDrawingDefinition.ImageType)
_U_14: tuple[type[ReportDrawingDefinition.PageSeq] | type[ReportDrawingDefinition.BackgroundRec] | type[ReportDrawingDefinition.PenRec] | type[ReportDrawingDefinition.PenWidthRec] | type[ReportDrawingDefinition.BrushRec] | type[ReportDrawingDefinition.DigitalControlRec] | type[ReportDrawingDefinition.DigitalControlGroupRec] | type[ReportDrawingDefinition.LabelSeq] | type[ReportDrawingDefinition.ValueSeq] | type[ReportDrawingDefinition.RotateSeq] | type[ReportDrawingDefinition.AntiRotateSeq] | type[ReportDrawingDefinition.TranslateSeq] | type[ReportDrawingDefinition.AntiTranslateSeq] | type[ReportDrawingDefinition.RectangleSeq] | type[ReportDrawingDefinition.FilledRectangleSeq] | type[ReportDrawingDefinition.CircleSeq] | type[ReportDrawingDefinition.FilledCircleSeq] | type[ReportDrawingDefinition.EllipseSeq] | type[ReportDrawingDefinition.FilledEllipseSeq] | type[ReportDrawingDefinition.LineSeq] | type[ReportDrawingDefinition.PolylineList] | type[ReportDrawingDefinition.PolygonList] | type[ReportDrawingDefinition.FilledPolygonList] | type[ReportDrawingDefinition.ArcSeq] | type[ReportDrawingDefinition.FilledArcSec] | type[ReportDrawingDefinition.PushVar] | type[ReportDrawingDefinition.PopVar] | type[ReportDrawingDefinition.IfVar] | type[ReportDrawingDefinition.ElseIfVar] | type[ReportDrawingDefinition.ElseVar] | type[ReportDrawingDefinition.EndIfVar] | type[ReportDrawingDefinition.SelectVar] | type[ReportDrawingDefinition.CaseVar] | type[ReportDrawingDefinition.DefaultVar] | type[ReportDrawingDefinition.EndSelectVar] | type[ReportDrawingDefinition.ImageSeq], ...] = (ReportDrawingDefinition.PageSeq, ReportDrawingDefinition.BackgroundRec, ReportDrawingDefinition.PenRec, ReportDrawingDefinition.PenWidthRec, ReportDrawingDefinition.BrushRec, ReportDrawingDefinition.DigitalControlRec, ReportDrawingDefinition.DigitalControlGroupRec, ReportDrawingDefinition.LabelSeq, ReportDrawingDefinition.ValueSeq, ReportDrawingDefinition.RotateSeq, ReportDrawingDefinition.AntiRotateSeq, ReportDrawingDefinition.TranslateSeq, ReportDrawingDefinition.AntiTranslateSeq, ReportDrawingDefinition.RectangleSeq, ReportDrawingDefinition.FilledRectangleSeq, ReportDrawingDefinition.CircleSeq, ReportDrawingDefinition.FilledCircleSeq, ReportDrawingDefinition.EllipseSeq, ReportDrawingDefinition.FilledEllipseSeq, ReportDrawingDefinition.LineSeq, ReportDrawingDefinition.PolylineList, ReportDrawingDefinition.PolygonList, ReportDrawingDefinition.FilledPolygonList, ReportDrawingDefinition.ArcSeq, ReportDrawingDefinition.FilledArcSec, ReportDrawingDefinition.PushVar, ReportDrawingDefinition.PopVar, ReportDrawingDefinition.IfVar, ReportDrawingDefinition.ElseIfVar, ReportDrawingDefinition.ElseVar, ReportDrawingDefinition.EndIfVar, ReportDrawingDefinition.SelectVar, ReportDrawingDefinition.CaseVar, ReportDrawingDefinition.DefaultVar, ReportDrawingDefinition.EndSelectVar, ReportDrawingDefinition.ImageSeq)
_T_15: dict[type[rt.Struct], int] = {ReportDrawingDefinition.PageSeq: 0, ReportDrawingDefinition.BackgroundRec: 1, ReportDrawingDefinition.PenRec: 2, ReportDrawingDefinition.PenWidthRec: 3, ReportDrawingDefinition.BrushRec: 4, ReportDrawingDefinition.DigitalControlRec: 5, ReportDrawingDefinition.DigitalControlGroupRec: 6, ReportDrawingDefinition.LabelSeq: 7, ReportDrawingDefinition.ValueSeq: 8, ReportDrawingDefinition.RotateSeq: 9, ReportDrawingDefinition.AntiRotateSeq: 10, ReportDrawingDefinition.TranslateSeq: 11, ReportDrawingDefinition.AntiTranslateSeq: 12, ReportDrawingDefinition.RectangleSeq: 13, ReportDrawingDefinition.FilledRectangleSeq: 14, ReportDrawingDefinition.CircleSeq: 15, ReportDrawingDefinition.FilledCircleSeq: 16, ReportDrawingDefinition.EllipseSeq: 17, ReportDrawingDefinition.FilledEllipseSeq: 18, ReportDrawingDefinition.LineSeq: 19, ReportDrawingDefinition.PolylineList: 20, ReportDrawingDefinition.PolygonList: 21, ReportDrawingDefinition.FilledPolygonList: 22, ReportDrawingDefinition.ArcSeq: 23, ReportDrawingDefinition.FilledArcSec: 24, ReportDrawingDefinition.PushVar: 25, ReportDrawingDefinition.PopVar: 26, ReportDrawingDefinition.IfVar: 27, ReportDrawingDefinition.ElseIfVar: 28, ReportDrawingDefinition.ElseVar: 29, ReportDrawingDefinition.EndIfVar: 30, ReportDrawingDefinition.SelectVar: 31, ReportDrawingDefinition.CaseVar: 32, ReportDrawingDefinition.DefaultVar: 33, ReportDrawingDefinition.EndSelectVar: 34, ReportDrawingDefinition.ImageSeq: 35}
_E_ReportDataDefinition_PrimitiveDataDefinition = rt.members(ReportDataDefinition.PrimitiveDataDefinition)
_L_B = rt.Rows("B")
_S_h = rt.Packer("<h")
_S_q = rt.Packer("<q")
_S_I = rt.Packer("<I")
_S_Q = rt.Packer("<Q")
_S_f = rt.Packer("<f")
_S_d = rt.Packer("<d")
_L_h = rt.Rows("h")
_L_i = rt.Rows("i")
_L_q = rt.Rows("q")
_L_H = rt.Rows("H")
_L_I = rt.Rows("I")
_L_Q = rt.Rows("Q")
_L_f = rt.Rows("f")
_L_d = rt.Rows("d")
_U_32: tuple[type[ReportData.ByteRec] | type[ReportData.ShortIntRec] | type[ReportData.IntegerRec] | type[ReportData.LongIntRec] | type[ReportData.UShortIntRec] | type[ReportData.UIntegerRec] | type[ReportData.ULongIntRec] | type[ReportData.FloatRec] | type[ReportData.LongFloatRec] | type[ReportData.ByteList] | type[ReportData.ShortIntList] | type[ReportData.IntegerList] | type[ReportData.LongIntList] | type[ReportData.UShortIntList] | type[ReportData.UIntegerList] | type[ReportData.ULongIntList] | type[ReportData.FloatList] | type[ReportData.LongFloatList] | type[ReportData.CharList], ...] = (ReportData.ByteRec, ReportData.ShortIntRec, ReportData.IntegerRec, ReportData.LongIntRec, ReportData.UShortIntRec, ReportData.UIntegerRec, ReportData.ULongIntRec, ReportData.FloatRec, ReportData.LongFloatRec, ReportData.ByteList, ReportData.ShortIntList, ReportData.IntegerList, ReportData.LongIntList, ReportData.UShortIntList, ReportData.UIntegerList, ReportData.ULongIntList, ReportData.FloatList, ReportData.LongFloatList, ReportData.CharList)
_T_33: dict[type[rt.Struct], int] = {ReportData.ByteRec: 0, ReportData.ShortIntRec: 1, ReportData.IntegerRec: 2, ReportData.LongIntRec: 3, ReportData.UShortIntRec: 4, ReportData.UIntegerRec: 5, ReportData.ULongIntRec: 6, ReportData.FloatRec: 7, ReportData.LongFloatRec: 8, ReportData.ByteList: 9, ReportData.ShortIntList: 10, ReportData.IntegerList: 11, ReportData.LongIntList: 12, ReportData.UShortIntList: 13, ReportData.UIntegerList: 14, ReportData.ULongIntList: 15, ReportData.FloatList: 16, ReportData.LongFloatList: 17, ReportData.CharList: 18}
QueryDrawingDefinition.REPORT = ReportDrawingDefinition
QueryDataDefinition.REPORT = ReportDataDefinition
QueryData.REPORT = ReportData
