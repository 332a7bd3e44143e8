"""urn:jaus:jss:HMI:Drawing 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:HMI:Drawing", "1.0")


@jd.message(_SERVICE, 0x4700)
class ReportDrawingDefinition(jd.Message):
    """ReportDrawingDefinition (0x4700): Tells the commands that draw the picture.

    graphics_command_list: 0..65535 items. The commands, in order
    """

    @jd.record()
    class ReferenceFieldRec(jd.Struct):
        """drawing_definition_reference: Number of another drawing to be drawn here"""
        drawing_definition_reference: int = jd.field("DrawingDefinitionReference", jd.Number("H"))

    @jd.record()
    class Literal(jd.Struct):
        """A number in the command itself.

        value: The number
        """
        value: int = jd.field("Value", jd.Number("i"))

    @jd.record()
    class Reference(jd.Struct):
        """A number in the data of the picture.

        structure: Number of the data structure
        field: Number of the field in it
        """
        structure: int = jd.field("Structure", jd.Number("H"))
        field: int = jd.field("Field", jd.Number("H"))

    @jd.record()
    class PageSeq(jd.Struct):
        """minimum_x: X of the left edge
        minimum_y: Y of the lower edge
        maximum_x: X of the right edge
        maximum_y: Y of the upper edge
        """
        minimum_x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("MinimumX", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        minimum_y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("MinimumY", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        maximum_x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("MaximumX", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        maximum_y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("MaximumY", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class BackgroundRec(jd.Struct):
        """red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """
        red_color: int = jd.field("RedColor", jd.Number("b"))
        green_color: int = jd.field("GreenColor", jd.Number("b"))
        blue_color: int = jd.field("BlueColor", jd.Number("b"))

    @jd.record()
    class PenRec(jd.Struct):
        """red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """
        red_color: int = jd.field("RedColor", jd.Number("b"))
        green_color: int = jd.field("GreenColor", jd.Number("b"))
        blue_color: int = jd.field("BlueColor", jd.Number("b"))

    @jd.record()
    class PenWidthRec(jd.Struct):
        """width: Width of lines"""
        width: int = jd.field("Width", jd.Number("b"))

    @jd.record()
    class BrushRec(jd.Struct):
        """red_color: Amount of red
        green_color: Amount of green
        blue_color: Amount of blue
        """
        red_color: int = jd.field("RedColor", jd.Number("b"))
        green_color: int = jd.field("GreenColor", jd.Number("b"))
        blue_color: int = jd.field("BlueColor", jd.Number("b"))

    class Group(IntEnum):
        TOP = 0
        LEFT = 1
        RIGHT = 2
        BOTTOM = 3

    @jd.record()
    class DigitalControlRec(jd.Struct):
        """reference: Number of the control
        group: Group. Edge of the display that the control is at
        digital_control_rec: 0..4. Place in its group
        label: up to 12 characters. Text on the control
        """
        reference: int = jd.field("Reference", jd.Number("H"))
        group: ReportDrawingDefinition.Group | int = jd.field("Group", lambda: jd.Number("b", jd.Values(ReportDrawingDefinition.Group)))
        digital_control_rec: int = jd.field("DigitalControlRec", jd.Number("b", jd.Values(None, ((0, 4),))))
        label: str = jd.field("Label", jd.Text(12))

    @jd.record()
    class DigitalControlGroupRec(jd.Struct):
        """group: Group. Edge of the display that the group is at
        label: up to 12 characters. Text on the group
        """
        group: ReportDrawingDefinition.Group | int = jd.field("Group", lambda: jd.Number("b", jd.Values(ReportDrawingDefinition.Group)))
        label: str = jd.field("Label", jd.Text(12))

    class Alignment(IntEnum):
        TOP_LEFT = 0
        MIDDLE_LEFT = 1
        BOTTOM_LEFT = 2
        MIDDLE_CENTER = 3
        MIDDLE_RIGHT = 4
        BOTTOM_CENTER = 5
        BOTTOM_RIGHT = 6
        TOP_CENTER = 7
        TOP_RIGHT = 8

    @jd.record()
    class AlignmentRec(jd.Struct):
        """Alignment of text.

        alignment: Alignment. Which point of the text is at the position
        """
        alignment: ReportDrawingDefinition.Alignment | int = jd.field("Alignment", lambda: jd.Number("b", jd.Values(ReportDrawingDefinition.Alignment)))

    @jd.record()
    class TextRec(jd.Struct):
        """text: up to 255 characters. Text to draw"""
        text: str = jd.field("Text", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record()
    class LabelSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        alignment_rec: Alignment of text
        font_size: Size of the text
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        alignment_rec: ReportDrawingDefinition.AlignmentRec = jd.field("AlignmentRec", lambda: ReportDrawingDefinition.AlignmentRec.layout())
        font_size: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("FontSize", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        text_rec: ReportDrawingDefinition.TextRec = jd.field("TextRec", lambda: ReportDrawingDefinition.TextRec.layout())

    @jd.record()
    class ValueSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        alignment_rec: Alignment of text
        font_size: Size of the text
        data_reference: The number to show
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        alignment_rec: ReportDrawingDefinition.AlignmentRec = jd.field("AlignmentRec", lambda: ReportDrawingDefinition.AlignmentRec.layout())
        font_size: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("FontSize", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        data_reference: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("DataReference", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class RotateSeq(jd.Struct):
        """angle: Angle to turn by"""
        angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Angle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class AntiRotateSeq(jd.Struct):
        """angle: Angle to turn back by"""
        angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Angle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class TranslateSeq(jd.Struct):
        """tx: Distance to move along X
        ty: Distance to move along Y
        """
        tx: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("TX", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        ty: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("TY", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class AntiTranslateSeq(jd.Struct):
        """tx: Distance to move back along X
        ty: Distance to move back along Y
        """
        tx: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("TX", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        ty: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("TY", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class RectangleSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class FilledRectangleSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class CircleSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        radius: Radius of the circle
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        radius: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Radius", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class FilledCircleSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        radius: Radius of the circle
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        radius: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Radius", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class EllipseSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class FilledEllipseSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class LineSeq(jd.Struct):
        """x1: X of the start
        y1: Y of the start
        x2: X of the end
        y2: Y of the end
        """
        x1: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X1", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y1: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y1", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        x2: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X2", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y2: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y2", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class PolylineSeq(jd.Struct):
        """x: X of the corner
        y: Y of the corner
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class PolylineList(jd.Struct):
        """Corners of a line.

        polyline_list: 0..255 items. Corners of a line
        """
        polyline_list: list[ReportDrawingDefinition.PolylineSeq] = jd.field("PolylineList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDrawingDefinition.PolylineSeq.layout()))

    @jd.record()
    class PolygonSeq(jd.Struct):
        """x: X of the corner
        y: Y of the corner
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class PolygonList(jd.Struct):
        """Corners of a polygon.

        polygon_list: 0..255 items. Corners of a polygon
        """
        polygon_list: list[ReportDrawingDefinition.PolygonSeq] = jd.field("PolygonList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDrawingDefinition.PolygonSeq.layout()))

    @jd.record()
    class FilledPolygonSeq(jd.Struct):
        """x: X of the corner
        y: Y of the corner
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class FilledPolygonList(jd.Struct):
        """Corners of a filled polygon.

        filled_polygon_list: 0..255 items. Corners of a filled polygon
        """
        filled_polygon_list: list[ReportDrawingDefinition.FilledPolygonSeq] = jd.field("FilledPolygonList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDrawingDefinition.FilledPolygonSeq.layout()))

    @jd.record()
    class ArcSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        start_angle: Angle that the arc starts at
        arc_angle: Angle that the arc covers
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        start_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("StartAngle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        arc_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("ArcAngle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class FilledArcSec(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        start_angle: Angle that the arc starts at
        arc_angle: Angle that the arc covers
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        start_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("StartAngle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        arc_angle: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("ArcAngle", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class Empty0(jd.Struct):
        """Empty0."""

    @jd.record()
    class Empty1(jd.Struct):
        """Empty1."""

    @jd.record()
    class Empty2(jd.Struct):
        """Empty2."""

    @jd.record()
    class Empty3(jd.Struct):
        """Empty3."""

    @jd.record()
    class Empty4(jd.Struct):
        """Empty4."""

    @jd.record()
    class Empty5(jd.Struct):
        """Empty5."""

    @jd.record()
    class Empty6(jd.Struct):
        """Empty6."""

    @jd.record()
    class Empty7(jd.Struct):
        """Empty7."""

    @jd.record()
    class Empty8(jd.Struct):
        """Empty8."""

    @jd.record()
    class Empty9(jd.Struct):
        """Empty9."""

    @jd.record()
    class Empty10(jd.Struct):
        """Empty10."""

    @jd.record()
    class Empty11(jd.Struct):
        """Empty11."""

    @jd.record()
    class Empty12(jd.Struct):
        """Empty12."""

    @jd.record()
    class Empty13(jd.Struct):
        """Empty13."""

    @jd.record()
    class Empty14(jd.Struct):
        """Empty14."""

    @jd.record()
    class Empty15(jd.Struct):
        """Empty15."""

    @jd.record()
    class Empty16(jd.Struct):
        """Empty16."""

    @jd.record()
    class Empty17(jd.Struct):
        """Empty17."""

    @jd.record()
    class Empty18(jd.Struct):
        """Empty18."""

    @jd.record()
    class Empty19(jd.Struct):
        """Empty19."""

    @jd.record()
    class Empty20(jd.Struct):
        """Empty20."""

    @jd.record()
    class Empty21(jd.Struct):
        """Empty21."""

    @jd.record()
    class Empty22(jd.Struct):
        """Empty22."""

    @jd.record()
    class Empty23(jd.Struct):
        """Empty23."""

    @jd.record()
    class Empty24(jd.Struct):
        """Empty24."""

    @jd.record()
    class Empty25(jd.Struct):
        """Empty25."""

    @jd.record()
    class Empty26(jd.Struct):
        """Empty26."""

    @jd.record()
    class Empty27(jd.Struct):
        """Empty27."""

    @jd.record()
    class Empty28(jd.Struct):
        """Empty28."""

    @jd.record()
    class Empty29(jd.Struct):
        """Empty29."""

    @jd.record()
    class Empty30(jd.Struct):
        """Empty30."""

    @jd.record()
    class Empty31(jd.Struct):
        """Empty31."""

    @jd.record()
    class Empty32(jd.Struct):
        """Empty32."""

    @jd.record()
    class Empty33(jd.Struct):
        """Empty33."""

    @jd.record()
    class Empty34(jd.Struct):
        """Empty34."""

    @jd.record()
    class Empty35(jd.Struct):
        """Empty35."""

    @jd.record()
    class Empty36(jd.Struct):
        """Empty36."""

    @jd.record()
    class Empty37(jd.Struct):
        """Empty37."""

    @jd.record()
    class Empty38(jd.Struct):
        """Empty38."""

    @jd.record()
    class Empty39(jd.Struct):
        """Empty39."""

    @jd.record()
    class Empty40(jd.Struct):
        """Empty40."""

    @jd.record()
    class Empty41(jd.Struct):
        """Empty41."""

    @jd.record()
    class Empty42(jd.Struct):
        """Empty42."""

    @jd.record()
    class Empty43(jd.Struct):
        """Empty43."""

    @jd.record()
    class Empty44(jd.Struct):
        """Empty44."""

    @jd.record()
    class Empty45(jd.Struct):
        """Empty45."""

    @jd.record()
    class Empty46(jd.Struct):
        """Empty46."""

    @jd.record()
    class Empty47(jd.Struct):
        """Empty47."""

    @jd.record()
    class Empty48(jd.Struct):
        """Empty48."""

    @jd.record()
    class Empty49(jd.Struct):
        """Empty49."""

    @jd.record()
    class Empty50(jd.Struct):
        """Empty50."""

    @jd.record()
    class Empty51(jd.Struct):
        """Empty51."""

    @jd.record()
    class Empty52(jd.Struct):
        """Empty52."""

    @jd.record()
    class Empty53(jd.Struct):
        """Empty53."""

    @jd.record()
    class Empty54(jd.Struct):
        """Empty54."""

    @jd.record()
    class Empty55(jd.Struct):
        """Empty55."""

    @jd.record()
    class Empty56(jd.Struct):
        """Empty56."""

    @jd.record()
    class Empty57(jd.Struct):
        """Empty57."""

    @jd.record()
    class Empty58(jd.Struct):
        """Empty58."""

    @jd.record()
    class Empty59(jd.Struct):
        """Empty59."""

    @jd.record()
    class Empty60(jd.Struct):
        """Empty60."""

    @jd.record()
    class Empty61(jd.Struct):
        """Empty61."""

    @jd.record()
    class Empty62(jd.Struct):
        """Empty62."""

    @jd.record()
    class Empty63(jd.Struct):
        """Empty63."""

    @jd.record()
    class Empty64(jd.Struct):
        """Empty64."""

    @jd.record()
    class Empty65(jd.Struct):
        """Empty65."""

    @jd.record()
    class Empty66(jd.Struct):
        """Empty66."""

    @jd.record()
    class Empty67(jd.Struct):
        """Empty67."""

    @jd.record()
    class Empty68(jd.Struct):
        """Empty68."""

    @jd.record()
    class Empty69(jd.Struct):
        """Empty69."""

    @jd.record()
    class Empty70(jd.Struct):
        """Empty70."""

    @jd.record()
    class Empty71(jd.Struct):
        """Empty71."""

    @jd.record()
    class Empty72(jd.Struct):
        """Empty72."""

    @jd.record()
    class Empty73(jd.Struct):
        """Empty73."""

    @jd.record()
    class Empty74(jd.Struct):
        """Empty74."""

    @jd.record()
    class Empty75(jd.Struct):
        """Empty75."""

    @jd.record()
    class Empty76(jd.Struct):
        """Empty76."""

    @jd.record()
    class Empty77(jd.Struct):
        """Empty77."""

    @jd.record()
    class Empty78(jd.Struct):
        """Empty78."""

    @jd.record()
    class Empty79(jd.Struct):
        """Empty79."""

    @jd.record()
    class Empty80(jd.Struct):
        """Empty80."""

    @jd.record()
    class Empty81(jd.Struct):
        """Empty81."""

    @jd.record()
    class Empty82(jd.Struct):
        """Empty82."""

    @jd.record()
    class Empty83(jd.Struct):
        """Empty83."""

    @jd.record()
    class Empty84(jd.Struct):
        """Empty84."""

    @jd.record()
    class Empty85(jd.Struct):
        """Empty85."""

    @jd.record()
    class Empty86(jd.Struct):
        """Empty86."""

    @jd.record()
    class Empty87(jd.Struct):
        """Empty87."""

    @jd.record()
    class Empty88(jd.Struct):
        """Empty88."""

    @jd.record()
    class Empty89(jd.Struct):
        """Empty89."""

    @jd.record()
    class Empty90(jd.Struct):
        """Empty90."""

    @jd.record()
    class Empty91(jd.Struct):
        """Empty91."""

    @jd.record()
    class Empty92(jd.Struct):
        """Empty92."""

    @jd.record()
    class Empty93(jd.Struct):
        """Empty93."""

    @jd.record()
    class Empty94(jd.Struct):
        """Empty94."""

    @jd.record()
    class Empty95(jd.Struct):
        """Empty95."""

    @jd.record()
    class Empty96(jd.Struct):
        """Empty96."""

    @jd.record()
    class Empty97(jd.Struct):
        """Empty97."""

    @jd.record()
    class Empty98(jd.Struct):
        """Empty98."""

    @jd.record()
    class Empty99(jd.Struct):
        """Empty99."""

    @jd.record()
    class Empty100(jd.Struct):
        """Empty100."""

    @jd.record()
    class Empty101(jd.Struct):
        """Empty101."""

    @jd.record()
    class Empty102(jd.Struct):
        """Empty102."""

    @jd.record()
    class Empty103(jd.Struct):
        """Empty103."""

    @jd.record()
    class Empty104(jd.Struct):
        """Empty104."""

    @jd.record()
    class Empty105(jd.Struct):
        """Empty105."""

    @jd.record()
    class Empty106(jd.Struct):
        """Empty106."""

    @jd.record()
    class Empty107(jd.Struct):
        """Empty107."""

    @jd.record()
    class Empty108(jd.Struct):
        """Empty108."""

    @jd.record()
    class Empty109(jd.Struct):
        """Empty109."""

    @jd.record()
    class Empty110(jd.Struct):
        """Empty110."""

    @jd.record()
    class Empty111(jd.Struct):
        """Empty111."""

    @jd.record()
    class Empty112(jd.Struct):
        """Empty112."""

    @jd.record()
    class Empty113(jd.Struct):
        """Empty113."""

    @jd.record()
    class Empty114(jd.Struct):
        """Empty114."""

    @jd.record()
    class Empty115(jd.Struct):
        """Empty115."""

    @jd.record()
    class Empty116(jd.Struct):
        """Empty116."""

    @jd.record()
    class Empty117(jd.Struct):
        """Empty117."""

    @jd.record()
    class Empty118(jd.Struct):
        """Empty118."""

    @jd.record()
    class Empty119(jd.Struct):
        """Empty119."""

    @jd.record()
    class Empty120(jd.Struct):
        """Empty120."""

    @jd.record()
    class Empty121(jd.Struct):
        """Empty121."""

    @jd.record()
    class Empty122(jd.Struct):
        """Empty122."""

    @jd.record()
    class Empty123(jd.Struct):
        """Empty123."""

    @jd.record()
    class Empty124(jd.Struct):
        """Empty124."""

    @jd.record()
    class Empty125(jd.Struct):
        """Empty125."""

    @jd.record()
    class Empty126(jd.Struct):
        """Empty126."""

    @jd.record()
    class Empty127(jd.Struct):
        """Empty127."""

    @jd.record()
    class Empty128(jd.Struct):
        """Empty128."""

    @jd.record()
    class Empty129(jd.Struct):
        """Empty129."""

    @jd.record()
    class Empty130(jd.Struct):
        """Empty130."""

    @jd.record()
    class Empty131(jd.Struct):
        """Empty131."""

    @jd.record()
    class Empty132(jd.Struct):
        """Empty132."""

    @jd.record()
    class Empty133(jd.Struct):
        """Empty133."""

    @jd.record()
    class Empty134(jd.Struct):
        """Empty134."""

    @jd.record()
    class Empty135(jd.Struct):
        """Empty135."""

    @jd.record()
    class Empty136(jd.Struct):
        """Empty136."""

    @jd.record()
    class Empty137(jd.Struct):
        """Empty137."""

    @jd.record()
    class Empty138(jd.Struct):
        """Empty138."""

    @jd.record()
    class Empty139(jd.Struct):
        """Empty139."""

    @jd.record()
    class Empty140(jd.Struct):
        """Empty140."""

    @jd.record()
    class Empty141(jd.Struct):
        """Empty141."""

    @jd.record()
    class Empty142(jd.Struct):
        """Empty142."""

    @jd.record()
    class Empty143(jd.Struct):
        """Empty143."""

    @jd.record()
    class Empty144(jd.Struct):
        """Empty144."""

    @jd.record()
    class Empty145(jd.Struct):
        """Empty145."""

    @jd.record()
    class Empty146(jd.Struct):
        """Empty146."""

    @jd.record()
    class Empty147(jd.Struct):
        """Empty147."""

    @jd.record()
    class Empty148(jd.Struct):
        """Empty148."""

    @jd.record()
    class Empty149(jd.Struct):
        """Empty149."""

    @jd.record()
    class Empty150(jd.Struct):
        """Empty150."""

    @jd.record()
    class Empty151(jd.Struct):
        """Empty151."""

    @jd.record()
    class Empty152(jd.Struct):
        """Empty152."""

    @jd.record()
    class Empty153(jd.Struct):
        """Empty153."""

    @jd.record()
    class Empty154(jd.Struct):
        """Empty154."""

    @jd.record()
    class Empty155(jd.Struct):
        """Empty155."""

    @jd.record()
    class Empty156(jd.Struct):
        """Empty156."""

    @jd.record()
    class Empty157(jd.Struct):
        """Empty157."""

    @jd.record()
    class Empty158(jd.Struct):
        """Empty158."""

    @jd.record()
    class Empty159(jd.Struct):
        """Empty159."""

    @jd.record()
    class Empty160(jd.Struct):
        """Empty160."""

    @jd.record()
    class Empty161(jd.Struct):
        """Empty161."""

    @jd.record()
    class Empty162(jd.Struct):
        """Empty162."""

    @jd.record()
    class Empty163(jd.Struct):
        """Empty163."""

    @jd.record()
    class Empty164(jd.Struct):
        """Empty164."""

    @jd.record()
    class Empty165(jd.Struct):
        """Empty165."""

    @jd.record()
    class Empty166(jd.Struct):
        """Empty166."""

    @jd.record()
    class Empty167(jd.Struct):
        """Empty167."""

    @jd.record()
    class Empty168(jd.Struct):
        """Empty168."""

    @jd.record()
    class Empty169(jd.Struct):
        """Empty169."""

    @jd.record()
    class Empty170(jd.Struct):
        """Empty170."""

    @jd.record()
    class Empty171(jd.Struct):
        """Empty171."""

    @jd.record()
    class Empty172(jd.Struct):
        """Empty172."""

    @jd.record()
    class Empty173(jd.Struct):
        """Empty173."""

    @jd.record()
    class Empty174(jd.Struct):
        """Empty174."""

    @jd.record()
    class Empty175(jd.Struct):
        """Empty175."""

    @jd.record()
    class Empty176(jd.Struct):
        """Empty176."""

    @jd.record()
    class Empty177(jd.Struct):
        """Empty177."""

    @jd.record()
    class Empty178(jd.Struct):
        """Empty178."""

    @jd.record()
    class Empty179(jd.Struct):
        """Empty179."""

    @jd.record()
    class Empty180(jd.Struct):
        """Empty180."""

    @jd.record()
    class Empty181(jd.Struct):
        """Empty181."""

    @jd.record()
    class Empty182(jd.Struct):
        """Empty182."""

    @jd.record()
    class Empty183(jd.Struct):
        """Empty183."""

    @jd.record()
    class Empty184(jd.Struct):
        """Empty184."""

    @jd.record()
    class Empty185(jd.Struct):
        """Empty185."""

    @jd.record()
    class Empty186(jd.Struct):
        """Empty186."""

    @jd.record()
    class Empty187(jd.Struct):
        """Empty187."""

    @jd.record()
    class Empty188(jd.Struct):
        """Empty188."""

    @jd.record()
    class Empty189(jd.Struct):
        """Empty189."""

    @jd.record()
    class Empty190(jd.Struct):
        """Empty190."""

    @jd.record()
    class Empty191(jd.Struct):
        """Empty191."""

    @jd.record()
    class Empty192(jd.Struct):
        """Empty192."""

    @jd.record()
    class Empty193(jd.Struct):
        """Empty193."""

    @jd.record()
    class Empty194(jd.Struct):
        """Empty194."""

    @jd.record()
    class Empty195(jd.Struct):
        """Empty195."""

    @jd.record()
    class Empty196(jd.Struct):
        """Empty196."""

    @jd.record()
    class Empty197(jd.Struct):
        """Empty197."""

    @jd.record()
    class Empty198(jd.Struct):
        """Empty198."""

    @jd.record()
    class Empty199(jd.Struct):
        """Empty199."""

    @jd.record()
    class Empty200(jd.Struct):
        """Empty200."""

    @jd.record()
    class Empty201(jd.Struct):
        """Empty201."""

    @jd.record()
    class Empty202(jd.Struct):
        """Empty202."""

    @jd.record()
    class Empty203(jd.Struct):
        """Empty203."""

    @jd.record()
    class Empty204(jd.Struct):
        """Empty204."""

    @jd.record()
    class Empty205(jd.Struct):
        """Empty205."""

    @jd.record()
    class Empty206(jd.Struct):
        """Empty206."""

    @jd.record()
    class Empty207(jd.Struct):
        """Empty207."""

    @jd.record()
    class Empty208(jd.Struct):
        """Empty208."""

    @jd.record()
    class Empty209(jd.Struct):
        """Empty209."""

    @jd.record()
    class Empty210(jd.Struct):
        """Empty210."""

    @jd.record()
    class Empty211(jd.Struct):
        """Empty211."""

    @jd.record()
    class Empty212(jd.Struct):
        """Empty212."""

    @jd.record()
    class Empty213(jd.Struct):
        """Empty213."""

    @jd.record()
    class Empty214(jd.Struct):
        """Empty214."""

    @jd.record()
    class Empty215(jd.Struct):
        """Empty215."""

    @jd.record()
    class Empty216(jd.Struct):
        """Empty216."""

    @jd.record()
    class Empty217(jd.Struct):
        """Empty217."""

    @jd.record()
    class Empty218(jd.Struct):
        """Empty218."""

    @jd.record()
    class Empty219(jd.Struct):
        """Empty219."""

    @jd.record()
    class Empty220(jd.Struct):
        """Empty220."""

    @jd.record()
    class Empty221(jd.Struct):
        """Empty221."""

    @jd.record()
    class Empty222(jd.Struct):
        """Empty222."""

    @jd.record()
    class Empty223(jd.Struct):
        """Empty223."""

    @jd.record()
    class Empty224(jd.Struct):
        """Empty224."""

    @jd.record()
    class Empty225(jd.Struct):
        """Empty225."""

    @jd.record()
    class Empty226(jd.Struct):
        """Empty226."""

    @jd.record()
    class Empty227(jd.Struct):
        """Empty227."""

    @jd.record()
    class Empty228(jd.Struct):
        """Empty228."""

    @jd.record()
    class Empty229(jd.Struct):
        """Empty229."""

    @jd.record()
    class Empty230(jd.Struct):
        """Empty230."""

    @jd.record()
    class Empty231(jd.Struct):
        """Empty231."""

    @jd.record()
    class Empty232(jd.Struct):
        """Empty232."""

    @jd.record()
    class Empty233(jd.Struct):
        """Empty233."""

    @jd.record()
    class Empty234(jd.Struct):
        """Empty234."""

    @jd.record()
    class Empty235(jd.Struct):
        """Empty235."""

    @jd.record()
    class Empty236(jd.Struct):
        """Empty236."""

    @jd.record()
    class Empty237(jd.Struct):
        """Empty237."""

    @jd.record()
    class Empty238(jd.Struct):
        """Empty238."""

    @jd.record()
    class Empty239(jd.Struct):
        """Empty239."""

    @jd.record()
    class Empty240(jd.Struct):
        """Empty240."""

    @jd.record()
    class Empty241(jd.Struct):
        """Empty241."""

    @jd.record()
    class Empty242(jd.Struct):
        """Empty242."""

    @jd.record()
    class Empty243(jd.Struct):
        """Empty243."""

    @jd.record()
    class Empty244(jd.Struct):
        """Empty244."""

    @jd.record()
    class Empty245(jd.Struct):
        """Empty245."""

    @jd.record()
    class Empty246(jd.Struct):
        """Empty246."""

    @jd.record()
    class Empty247(jd.Struct):
        """Empty247."""

    @jd.record()
    class Empty248(jd.Struct):
        """Empty248."""

    @jd.record()
    class Empty249(jd.Struct):
        """Empty249."""

    @jd.record()
    class Empty250(jd.Struct):
        """Empty250."""

    @jd.record()
    class Empty251(jd.Struct):
        """Empty251."""

    @jd.record()
    class Empty252(jd.Struct):
        """Empty252."""

    @jd.record()
    class Empty253(jd.Struct):
        """Empty253."""

    @jd.record()
    class Empty254(jd.Struct):
        """Empty254."""

    @jd.record()
    class Empty255(jd.Struct):
        """Empty255."""

    @jd.record()
    class PushVar(jd.Struct):
        """Keep the present position, angle and colours.

        push_var: Keep the present position, angle and colours
        """
        push_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("PushVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    @jd.record()
    class PopVar(jd.Struct):
        """Go back to what was kept last.

        pop_var: Go back to what was kept last
        """
        pop_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("PopVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    @jd.record()
    class IfVar(jd.Struct):
        """Draw what follows when the number is not 0.

        if_var: Draw what follows when the number is not 0
        """
        if_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("IfVar", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class ElseIfVar(jd.Struct):
        """Otherwise, draw what follows when the number is not 0.

        else_if_var: Otherwise, draw what follows when the number is not 0
        """
        else_if_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("ElseIfVar", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class ElseVar(jd.Struct):
        """Otherwise draw what follows.

        else_var: Otherwise draw what follows
        """
        else_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("ElseVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    @jd.record()
    class EndIfVar(jd.Struct):
        """End of the last If.

        end_if_var: End of the last If
        """
        end_if_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("EndIfVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    @jd.record()
    class SelectVar(jd.Struct):
        """Draw the case that has this number.

        select_var: Draw the case that has this number
        """
        select_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("SelectVar", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class CaseVar(jd.Struct):
        """Draw what follows when this is the selected number.

        case_var: Draw what follows when this is the selected number
        """
        case_var: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("CaseVar", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))

    @jd.record()
    class DefaultVar(jd.Struct):
        """Draw what follows when no case had the selected number.

        default_var: Draw what follows when no case had the selected number
        """
        default_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("DefaultVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    @jd.record()
    class EndSelectVar(jd.Struct):
        """End of the last Select.

        end_select_var: End of the last Select
        """
        end_select_var: ReportDrawingDefinition.Empty0 | ReportDrawingDefinition.Empty1 | ReportDrawingDefinition.Empty2 | ReportDrawingDefinition.Empty3 | ReportDrawingDefinition.Empty4 | ReportDrawingDefinition.Empty5 | ReportDrawingDefinition.Empty6 | ReportDrawingDefinition.Empty7 | ReportDrawingDefinition.Empty8 | ReportDrawingDefinition.Empty9 | ReportDrawingDefinition.Empty10 | ReportDrawingDefinition.Empty11 | ReportDrawingDefinition.Empty12 | ReportDrawingDefinition.Empty13 | ReportDrawingDefinition.Empty14 | ReportDrawingDefinition.Empty15 | ReportDrawingDefinition.Empty16 | ReportDrawingDefinition.Empty17 | ReportDrawingDefinition.Empty18 | ReportDrawingDefinition.Empty19 | ReportDrawingDefinition.Empty20 | ReportDrawingDefinition.Empty21 | ReportDrawingDefinition.Empty22 | ReportDrawingDefinition.Empty23 | ReportDrawingDefinition.Empty24 | ReportDrawingDefinition.Empty25 | ReportDrawingDefinition.Empty26 | ReportDrawingDefinition.Empty27 | ReportDrawingDefinition.Empty28 | ReportDrawingDefinition.Empty29 | ReportDrawingDefinition.Empty30 | ReportDrawingDefinition.Empty31 | ReportDrawingDefinition.Empty32 | ReportDrawingDefinition.Empty33 | ReportDrawingDefinition.Empty34 | ReportDrawingDefinition.Empty35 | ReportDrawingDefinition.Empty36 | ReportDrawingDefinition.Empty37 | ReportDrawingDefinition.Empty38 | ReportDrawingDefinition.Empty39 | ReportDrawingDefinition.Empty40 | ReportDrawingDefinition.Empty41 | ReportDrawingDefinition.Empty42 | ReportDrawingDefinition.Empty43 | ReportDrawingDefinition.Empty44 | ReportDrawingDefinition.Empty45 | ReportDrawingDefinition.Empty46 | ReportDrawingDefinition.Empty47 | ReportDrawingDefinition.Empty48 | ReportDrawingDefinition.Empty49 | ReportDrawingDefinition.Empty50 | ReportDrawingDefinition.Empty51 | ReportDrawingDefinition.Empty52 | ReportDrawingDefinition.Empty53 | ReportDrawingDefinition.Empty54 | ReportDrawingDefinition.Empty55 | ReportDrawingDefinition.Empty56 | ReportDrawingDefinition.Empty57 | ReportDrawingDefinition.Empty58 | ReportDrawingDefinition.Empty59 | ReportDrawingDefinition.Empty60 | ReportDrawingDefinition.Empty61 | ReportDrawingDefinition.Empty62 | ReportDrawingDefinition.Empty63 | ReportDrawingDefinition.Empty64 | ReportDrawingDefinition.Empty65 | ReportDrawingDefinition.Empty66 | ReportDrawingDefinition.Empty67 | ReportDrawingDefinition.Empty68 | ReportDrawingDefinition.Empty69 | ReportDrawingDefinition.Empty70 | ReportDrawingDefinition.Empty71 | ReportDrawingDefinition.Empty72 | ReportDrawingDefinition.Empty73 | ReportDrawingDefinition.Empty74 | ReportDrawingDefinition.Empty75 | ReportDrawingDefinition.Empty76 | ReportDrawingDefinition.Empty77 | ReportDrawingDefinition.Empty78 | ReportDrawingDefinition.Empty79 | ReportDrawingDefinition.Empty80 | ReportDrawingDefinition.Empty81 | ReportDrawingDefinition.Empty82 | ReportDrawingDefinition.Empty83 | ReportDrawingDefinition.Empty84 | ReportDrawingDefinition.Empty85 | ReportDrawingDefinition.Empty86 | ReportDrawingDefinition.Empty87 | ReportDrawingDefinition.Empty88 | ReportDrawingDefinition.Empty89 | ReportDrawingDefinition.Empty90 | ReportDrawingDefinition.Empty91 | ReportDrawingDefinition.Empty92 | ReportDrawingDefinition.Empty93 | ReportDrawingDefinition.Empty94 | ReportDrawingDefinition.Empty95 | ReportDrawingDefinition.Empty96 | ReportDrawingDefinition.Empty97 | ReportDrawingDefinition.Empty98 | ReportDrawingDefinition.Empty99 | ReportDrawingDefinition.Empty100 | ReportDrawingDefinition.Empty101 | ReportDrawingDefinition.Empty102 | ReportDrawingDefinition.Empty103 | ReportDrawingDefinition.Empty104 | ReportDrawingDefinition.Empty105 | ReportDrawingDefinition.Empty106 | ReportDrawingDefinition.Empty107 | ReportDrawingDefinition.Empty108 | ReportDrawingDefinition.Empty109 | ReportDrawingDefinition.Empty110 | ReportDrawingDefinition.Empty111 | ReportDrawingDefinition.Empty112 | ReportDrawingDefinition.Empty113 | ReportDrawingDefinition.Empty114 | ReportDrawingDefinition.Empty115 | ReportDrawingDefinition.Empty116 | ReportDrawingDefinition.Empty117 | ReportDrawingDefinition.Empty118 | ReportDrawingDefinition.Empty119 | ReportDrawingDefinition.Empty120 | ReportDrawingDefinition.Empty121 | ReportDrawingDefinition.Empty122 | ReportDrawingDefinition.Empty123 | ReportDrawingDefinition.Empty124 | ReportDrawingDefinition.Empty125 | ReportDrawingDefinition.Empty126 | ReportDrawingDefinition.Empty127 | ReportDrawingDefinition.Empty128 | ReportDrawingDefinition.Empty129 | ReportDrawingDefinition.Empty130 | ReportDrawingDefinition.Empty131 | ReportDrawingDefinition.Empty132 | ReportDrawingDefinition.Empty133 | ReportDrawingDefinition.Empty134 | ReportDrawingDefinition.Empty135 | ReportDrawingDefinition.Empty136 | ReportDrawingDefinition.Empty137 | ReportDrawingDefinition.Empty138 | ReportDrawingDefinition.Empty139 | ReportDrawingDefinition.Empty140 | ReportDrawingDefinition.Empty141 | ReportDrawingDefinition.Empty142 | ReportDrawingDefinition.Empty143 | ReportDrawingDefinition.Empty144 | ReportDrawingDefinition.Empty145 | ReportDrawingDefinition.Empty146 | ReportDrawingDefinition.Empty147 | ReportDrawingDefinition.Empty148 | ReportDrawingDefinition.Empty149 | ReportDrawingDefinition.Empty150 | ReportDrawingDefinition.Empty151 | ReportDrawingDefinition.Empty152 | ReportDrawingDefinition.Empty153 | ReportDrawingDefinition.Empty154 | ReportDrawingDefinition.Empty155 | ReportDrawingDefinition.Empty156 | ReportDrawingDefinition.Empty157 | ReportDrawingDefinition.Empty158 | ReportDrawingDefinition.Empty159 | ReportDrawingDefinition.Empty160 | ReportDrawingDefinition.Empty161 | ReportDrawingDefinition.Empty162 | ReportDrawingDefinition.Empty163 | ReportDrawingDefinition.Empty164 | ReportDrawingDefinition.Empty165 | ReportDrawingDefinition.Empty166 | ReportDrawingDefinition.Empty167 | ReportDrawingDefinition.Empty168 | ReportDrawingDefinition.Empty169 | ReportDrawingDefinition.Empty170 | ReportDrawingDefinition.Empty171 | ReportDrawingDefinition.Empty172 | ReportDrawingDefinition.Empty173 | ReportDrawingDefinition.Empty174 | ReportDrawingDefinition.Empty175 | ReportDrawingDefinition.Empty176 | ReportDrawingDefinition.Empty177 | ReportDrawingDefinition.Empty178 | ReportDrawingDefinition.Empty179 | ReportDrawingDefinition.Empty180 | ReportDrawingDefinition.Empty181 | ReportDrawingDefinition.Empty182 | ReportDrawingDefinition.Empty183 | ReportDrawingDefinition.Empty184 | ReportDrawingDefinition.Empty185 | ReportDrawingDefinition.Empty186 | ReportDrawingDefinition.Empty187 | ReportDrawingDefinition.Empty188 | ReportDrawingDefinition.Empty189 | ReportDrawingDefinition.Empty190 | ReportDrawingDefinition.Empty191 | ReportDrawingDefinition.Empty192 | ReportDrawingDefinition.Empty193 | ReportDrawingDefinition.Empty194 | ReportDrawingDefinition.Empty195 | ReportDrawingDefinition.Empty196 | ReportDrawingDefinition.Empty197 | ReportDrawingDefinition.Empty198 | ReportDrawingDefinition.Empty199 | ReportDrawingDefinition.Empty200 | ReportDrawingDefinition.Empty201 | ReportDrawingDefinition.Empty202 | ReportDrawingDefinition.Empty203 | ReportDrawingDefinition.Empty204 | ReportDrawingDefinition.Empty205 | ReportDrawingDefinition.Empty206 | ReportDrawingDefinition.Empty207 | ReportDrawingDefinition.Empty208 | ReportDrawingDefinition.Empty209 | ReportDrawingDefinition.Empty210 | ReportDrawingDefinition.Empty211 | ReportDrawingDefinition.Empty212 | ReportDrawingDefinition.Empty213 | ReportDrawingDefinition.Empty214 | ReportDrawingDefinition.Empty215 | ReportDrawingDefinition.Empty216 | ReportDrawingDefinition.Empty217 | ReportDrawingDefinition.Empty218 | ReportDrawingDefinition.Empty219 | ReportDrawingDefinition.Empty220 | ReportDrawingDefinition.Empty221 | ReportDrawingDefinition.Empty222 | ReportDrawingDefinition.Empty223 | ReportDrawingDefinition.Empty224 | ReportDrawingDefinition.Empty225 | ReportDrawingDefinition.Empty226 | ReportDrawingDefinition.Empty227 | ReportDrawingDefinition.Empty228 | ReportDrawingDefinition.Empty229 | ReportDrawingDefinition.Empty230 | ReportDrawingDefinition.Empty231 | ReportDrawingDefinition.Empty232 | ReportDrawingDefinition.Empty233 | ReportDrawingDefinition.Empty234 | ReportDrawingDefinition.Empty235 | ReportDrawingDefinition.Empty236 | ReportDrawingDefinition.Empty237 | ReportDrawingDefinition.Empty238 | ReportDrawingDefinition.Empty239 | ReportDrawingDefinition.Empty240 | ReportDrawingDefinition.Empty241 | ReportDrawingDefinition.Empty242 | ReportDrawingDefinition.Empty243 | ReportDrawingDefinition.Empty244 | ReportDrawingDefinition.Empty245 | ReportDrawingDefinition.Empty246 | ReportDrawingDefinition.Empty247 | ReportDrawingDefinition.Empty248 | ReportDrawingDefinition.Empty249 | ReportDrawingDefinition.Empty250 | ReportDrawingDefinition.Empty251 | ReportDrawingDefinition.Empty252 | ReportDrawingDefinition.Empty253 | ReportDrawingDefinition.Empty254 | ReportDrawingDefinition.Empty255 = jd.field("EndSelectVar", lambda: jd.Union.of("B", empty0=ReportDrawingDefinition.Empty0, empty1=ReportDrawingDefinition.Empty1, empty2=ReportDrawingDefinition.Empty2, empty3=ReportDrawingDefinition.Empty3, empty4=ReportDrawingDefinition.Empty4, empty5=ReportDrawingDefinition.Empty5, empty6=ReportDrawingDefinition.Empty6, empty7=ReportDrawingDefinition.Empty7, empty8=ReportDrawingDefinition.Empty8, empty9=ReportDrawingDefinition.Empty9, empty10=ReportDrawingDefinition.Empty10, empty11=ReportDrawingDefinition.Empty11, empty12=ReportDrawingDefinition.Empty12, empty13=ReportDrawingDefinition.Empty13, empty14=ReportDrawingDefinition.Empty14, empty15=ReportDrawingDefinition.Empty15, empty16=ReportDrawingDefinition.Empty16, empty17=ReportDrawingDefinition.Empty17, empty18=ReportDrawingDefinition.Empty18, empty19=ReportDrawingDefinition.Empty19, empty20=ReportDrawingDefinition.Empty20, empty21=ReportDrawingDefinition.Empty21, empty22=ReportDrawingDefinition.Empty22, empty23=ReportDrawingDefinition.Empty23, empty24=ReportDrawingDefinition.Empty24, empty25=ReportDrawingDefinition.Empty25, empty26=ReportDrawingDefinition.Empty26, empty27=ReportDrawingDefinition.Empty27, empty28=ReportDrawingDefinition.Empty28, empty29=ReportDrawingDefinition.Empty29, empty30=ReportDrawingDefinition.Empty30, empty31=ReportDrawingDefinition.Empty31, empty32=ReportDrawingDefinition.Empty32, empty33=ReportDrawingDefinition.Empty33, empty34=ReportDrawingDefinition.Empty34, empty35=ReportDrawingDefinition.Empty35, empty36=ReportDrawingDefinition.Empty36, empty37=ReportDrawingDefinition.Empty37, empty38=ReportDrawingDefinition.Empty38, empty39=ReportDrawingDefinition.Empty39, empty40=ReportDrawingDefinition.Empty40, empty41=ReportDrawingDefinition.Empty41, empty42=ReportDrawingDefinition.Empty42, empty43=ReportDrawingDefinition.Empty43, empty44=ReportDrawingDefinition.Empty44, empty45=ReportDrawingDefinition.Empty45, empty46=ReportDrawingDefinition.Empty46, empty47=ReportDrawingDefinition.Empty47, empty48=ReportDrawingDefinition.Empty48, empty49=ReportDrawingDefinition.Empty49, empty50=ReportDrawingDefinition.Empty50, empty51=ReportDrawingDefinition.Empty51, empty52=ReportDrawingDefinition.Empty52, empty53=ReportDrawingDefinition.Empty53, empty54=ReportDrawingDefinition.Empty54, empty55=ReportDrawingDefinition.Empty55, empty56=ReportDrawingDefinition.Empty56, empty57=ReportDrawingDefinition.Empty57, empty58=ReportDrawingDefinition.Empty58, empty59=ReportDrawingDefinition.Empty59, empty60=ReportDrawingDefinition.Empty60, empty61=ReportDrawingDefinition.Empty61, empty62=ReportDrawingDefinition.Empty62, empty63=ReportDrawingDefinition.Empty63, empty64=ReportDrawingDefinition.Empty64, empty65=ReportDrawingDefinition.Empty65, empty66=ReportDrawingDefinition.Empty66, empty67=ReportDrawingDefinition.Empty67, empty68=ReportDrawingDefinition.Empty68, empty69=ReportDrawingDefinition.Empty69, empty70=ReportDrawingDefinition.Empty70, empty71=ReportDrawingDefinition.Empty71, empty72=ReportDrawingDefinition.Empty72, empty73=ReportDrawingDefinition.Empty73, empty74=ReportDrawingDefinition.Empty74, empty75=ReportDrawingDefinition.Empty75, empty76=ReportDrawingDefinition.Empty76, empty77=ReportDrawingDefinition.Empty77, empty78=ReportDrawingDefinition.Empty78, empty79=ReportDrawingDefinition.Empty79, empty80=ReportDrawingDefinition.Empty80, empty81=ReportDrawingDefinition.Empty81, empty82=ReportDrawingDefinition.Empty82, empty83=ReportDrawingDefinition.Empty83, empty84=ReportDrawingDefinition.Empty84, empty85=ReportDrawingDefinition.Empty85, empty86=ReportDrawingDefinition.Empty86, empty87=ReportDrawingDefinition.Empty87, empty88=ReportDrawingDefinition.Empty88, empty89=ReportDrawingDefinition.Empty89, empty90=ReportDrawingDefinition.Empty90, empty91=ReportDrawingDefinition.Empty91, empty92=ReportDrawingDefinition.Empty92, empty93=ReportDrawingDefinition.Empty93, empty94=ReportDrawingDefinition.Empty94, empty95=ReportDrawingDefinition.Empty95, empty96=ReportDrawingDefinition.Empty96, empty97=ReportDrawingDefinition.Empty97, empty98=ReportDrawingDefinition.Empty98, empty99=ReportDrawingDefinition.Empty99, empty100=ReportDrawingDefinition.Empty100, empty101=ReportDrawingDefinition.Empty101, empty102=ReportDrawingDefinition.Empty102, empty103=ReportDrawingDefinition.Empty103, empty104=ReportDrawingDefinition.Empty104, empty105=ReportDrawingDefinition.Empty105, empty106=ReportDrawingDefinition.Empty106, empty107=ReportDrawingDefinition.Empty107, empty108=ReportDrawingDefinition.Empty108, empty109=ReportDrawingDefinition.Empty109, empty110=ReportDrawingDefinition.Empty110, empty111=ReportDrawingDefinition.Empty111, empty112=ReportDrawingDefinition.Empty112, empty113=ReportDrawingDefinition.Empty113, empty114=ReportDrawingDefinition.Empty114, empty115=ReportDrawingDefinition.Empty115, empty116=ReportDrawingDefinition.Empty116, empty117=ReportDrawingDefinition.Empty117, empty118=ReportDrawingDefinition.Empty118, empty119=ReportDrawingDefinition.Empty119, empty120=ReportDrawingDefinition.Empty120, empty121=ReportDrawingDefinition.Empty121, empty122=ReportDrawingDefinition.Empty122, empty123=ReportDrawingDefinition.Empty123, empty124=ReportDrawingDefinition.Empty124, empty125=ReportDrawingDefinition.Empty125, empty126=ReportDrawingDefinition.Empty126, empty127=ReportDrawingDefinition.Empty127, empty128=ReportDrawingDefinition.Empty128, empty129=ReportDrawingDefinition.Empty129, empty130=ReportDrawingDefinition.Empty130, empty131=ReportDrawingDefinition.Empty131, empty132=ReportDrawingDefinition.Empty132, empty133=ReportDrawingDefinition.Empty133, empty134=ReportDrawingDefinition.Empty134, empty135=ReportDrawingDefinition.Empty135, empty136=ReportDrawingDefinition.Empty136, empty137=ReportDrawingDefinition.Empty137, empty138=ReportDrawingDefinition.Empty138, empty139=ReportDrawingDefinition.Empty139, empty140=ReportDrawingDefinition.Empty140, empty141=ReportDrawingDefinition.Empty141, empty142=ReportDrawingDefinition.Empty142, empty143=ReportDrawingDefinition.Empty143, empty144=ReportDrawingDefinition.Empty144, empty145=ReportDrawingDefinition.Empty145, empty146=ReportDrawingDefinition.Empty146, empty147=ReportDrawingDefinition.Empty147, empty148=ReportDrawingDefinition.Empty148, empty149=ReportDrawingDefinition.Empty149, empty150=ReportDrawingDefinition.Empty150, empty151=ReportDrawingDefinition.Empty151, empty152=ReportDrawingDefinition.Empty152, empty153=ReportDrawingDefinition.Empty153, empty154=ReportDrawingDefinition.Empty154, empty155=ReportDrawingDefinition.Empty155, empty156=ReportDrawingDefinition.Empty156, empty157=ReportDrawingDefinition.Empty157, empty158=ReportDrawingDefinition.Empty158, empty159=ReportDrawingDefinition.Empty159, empty160=ReportDrawingDefinition.Empty160, empty161=ReportDrawingDefinition.Empty161, empty162=ReportDrawingDefinition.Empty162, empty163=ReportDrawingDefinition.Empty163, empty164=ReportDrawingDefinition.Empty164, empty165=ReportDrawingDefinition.Empty165, empty166=ReportDrawingDefinition.Empty166, empty167=ReportDrawingDefinition.Empty167, empty168=ReportDrawingDefinition.Empty168, empty169=ReportDrawingDefinition.Empty169, empty170=ReportDrawingDefinition.Empty170, empty171=ReportDrawingDefinition.Empty171, empty172=ReportDrawingDefinition.Empty172, empty173=ReportDrawingDefinition.Empty173, empty174=ReportDrawingDefinition.Empty174, empty175=ReportDrawingDefinition.Empty175, empty176=ReportDrawingDefinition.Empty176, empty177=ReportDrawingDefinition.Empty177, empty178=ReportDrawingDefinition.Empty178, empty179=ReportDrawingDefinition.Empty179, empty180=ReportDrawingDefinition.Empty180, empty181=ReportDrawingDefinition.Empty181, empty182=ReportDrawingDefinition.Empty182, empty183=ReportDrawingDefinition.Empty183, empty184=ReportDrawingDefinition.Empty184, empty185=ReportDrawingDefinition.Empty185, empty186=ReportDrawingDefinition.Empty186, empty187=ReportDrawingDefinition.Empty187, empty188=ReportDrawingDefinition.Empty188, empty189=ReportDrawingDefinition.Empty189, empty190=ReportDrawingDefinition.Empty190, empty191=ReportDrawingDefinition.Empty191, empty192=ReportDrawingDefinition.Empty192, empty193=ReportDrawingDefinition.Empty193, empty194=ReportDrawingDefinition.Empty194, empty195=ReportDrawingDefinition.Empty195, empty196=ReportDrawingDefinition.Empty196, empty197=ReportDrawingDefinition.Empty197, empty198=ReportDrawingDefinition.Empty198, empty199=ReportDrawingDefinition.Empty199, empty200=ReportDrawingDefinition.Empty200, empty201=ReportDrawingDefinition.Empty201, empty202=ReportDrawingDefinition.Empty202, empty203=ReportDrawingDefinition.Empty203, empty204=ReportDrawingDefinition.Empty204, empty205=ReportDrawingDefinition.Empty205, empty206=ReportDrawingDefinition.Empty206, empty207=ReportDrawingDefinition.Empty207, empty208=ReportDrawingDefinition.Empty208, empty209=ReportDrawingDefinition.Empty209, empty210=ReportDrawingDefinition.Empty210, empty211=ReportDrawingDefinition.Empty211, empty212=ReportDrawingDefinition.Empty212, empty213=ReportDrawingDefinition.Empty213, empty214=ReportDrawingDefinition.Empty214, empty215=ReportDrawingDefinition.Empty215, empty216=ReportDrawingDefinition.Empty216, empty217=ReportDrawingDefinition.Empty217, empty218=ReportDrawingDefinition.Empty218, empty219=ReportDrawingDefinition.Empty219, empty220=ReportDrawingDefinition.Empty220, empty221=ReportDrawingDefinition.Empty221, empty222=ReportDrawingDefinition.Empty222, empty223=ReportDrawingDefinition.Empty223, empty224=ReportDrawingDefinition.Empty224, empty225=ReportDrawingDefinition.Empty225, empty226=ReportDrawingDefinition.Empty226, empty227=ReportDrawingDefinition.Empty227, empty228=ReportDrawingDefinition.Empty228, empty229=ReportDrawingDefinition.Empty229, empty230=ReportDrawingDefinition.Empty230, empty231=ReportDrawingDefinition.Empty231, empty232=ReportDrawingDefinition.Empty232, empty233=ReportDrawingDefinition.Empty233, empty234=ReportDrawingDefinition.Empty234, empty235=ReportDrawingDefinition.Empty235, empty236=ReportDrawingDefinition.Empty236, empty237=ReportDrawingDefinition.Empty237, empty238=ReportDrawingDefinition.Empty238, empty239=ReportDrawingDefinition.Empty239, empty240=ReportDrawingDefinition.Empty240, empty241=ReportDrawingDefinition.Empty241, empty242=ReportDrawingDefinition.Empty242, empty243=ReportDrawingDefinition.Empty243, empty244=ReportDrawingDefinition.Empty244, empty245=ReportDrawingDefinition.Empty245, empty246=ReportDrawingDefinition.Empty246, empty247=ReportDrawingDefinition.Empty247, empty248=ReportDrawingDefinition.Empty248, empty249=ReportDrawingDefinition.Empty249, empty250=ReportDrawingDefinition.Empty250, empty251=ReportDrawingDefinition.Empty251, empty252=ReportDrawingDefinition.Empty252, empty253=ReportDrawingDefinition.Empty253, empty254=ReportDrawingDefinition.Empty254, empty255=ReportDrawingDefinition.Empty255))

    class ImageType(IntEnum):
        PPM = 0
        JPEG = 1
        TIFF = 2
        NITF = 3
        BMP = 4

    @jd.record()
    class ImageTypeRec(jd.Struct):
        """image_type: ImageType. Coding of the image"""
        image_type: ReportDrawingDefinition.ImageType | int = jd.field("ImageType", lambda: jd.Number("b", jd.Values(ReportDrawingDefinition.ImageType)))

    @jd.record()
    class ImageSeq(jd.Struct):
        """x: X of the figure
        y: Y of the figure
        width: Width of the figure
        height: Height of the figure
        reference_to_data: Number of the data structure that holds the image
        """
        x: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("X", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        y: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Y", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        width: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Width", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        height: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("Height", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        reference_to_data: ReportDrawingDefinition.Literal | ReportDrawingDefinition.Reference = jd.field("ReferenceToData", lambda: jd.Union.of("B", literal=ReportDrawingDefinition.Literal, reference=ReportDrawingDefinition.Reference))
        image_type_rec: ReportDrawingDefinition.ImageTypeRec = jd.field("ImageTypeRec", lambda: ReportDrawingDefinition.ImageTypeRec.layout())

    reference_field_rec: ReportDrawingDefinition.ReferenceFieldRec = jd.field("ReferenceFieldRec", lambda: ReportDrawingDefinition.ReferenceFieldRec.layout())
    graphics_command_list: list[ReportDrawingDefinition.PageSeq | ReportDrawingDefinition.BackgroundRec | ReportDrawingDefinition.PenRec | ReportDrawingDefinition.PenWidthRec | ReportDrawingDefinition.BrushRec | ReportDrawingDefinition.DigitalControlRec | ReportDrawingDefinition.DigitalControlGroupRec | ReportDrawingDefinition.LabelSeq | ReportDrawingDefinition.ValueSeq | ReportDrawingDefinition.RotateSeq | ReportDrawingDefinition.AntiRotateSeq | ReportDrawingDefinition.TranslateSeq | ReportDrawingDefinition.AntiTranslateSeq | ReportDrawingDefinition.RectangleSeq | ReportDrawingDefinition.FilledRectangleSeq | ReportDrawingDefinition.CircleSeq | ReportDrawingDefinition.FilledCircleSeq | ReportDrawingDefinition.EllipseSeq | ReportDrawingDefinition.FilledEllipseSeq | ReportDrawingDefinition.LineSeq | ReportDrawingDefinition.PolylineList | ReportDrawingDefinition.PolygonList | ReportDrawingDefinition.FilledPolygonList | ReportDrawingDefinition.ArcSeq | ReportDrawingDefinition.FilledArcSec | ReportDrawingDefinition.PushVar | ReportDrawingDefinition.PopVar | ReportDrawingDefinition.IfVar | ReportDrawingDefinition.ElseIfVar | ReportDrawingDefinition.ElseVar | ReportDrawingDefinition.EndIfVar | ReportDrawingDefinition.SelectVar | ReportDrawingDefinition.CaseVar | ReportDrawingDefinition.DefaultVar | ReportDrawingDefinition.EndSelectVar | ReportDrawingDefinition.ImageSeq] = jd.field("GraphicsCommandList", lambda: jd.Repeat(jd.Count("H", 0, 65535), jd.Union.of("B", page_seq=ReportDrawingDefinition.PageSeq, background_rec=ReportDrawingDefinition.BackgroundRec, pen_rec=ReportDrawingDefinition.PenRec, pen_width_rec=ReportDrawingDefinition.PenWidthRec, brush_rec=ReportDrawingDefinition.BrushRec, digital_control_rec=ReportDrawingDefinition.DigitalControlRec, digital_control_group_rec=ReportDrawingDefinition.DigitalControlGroupRec, label_seq=ReportDrawingDefinition.LabelSeq, value_seq=ReportDrawingDefinition.ValueSeq, rotate_seq=ReportDrawingDefinition.RotateSeq, anti_rotate_seq=ReportDrawingDefinition.AntiRotateSeq, translate_seq=ReportDrawingDefinition.TranslateSeq, anti_translate_seq=ReportDrawingDefinition.AntiTranslateSeq, rectangle_seq=ReportDrawingDefinition.RectangleSeq, filled_rectangle_seq=ReportDrawingDefinition.FilledRectangleSeq, circle_seq=ReportDrawingDefinition.CircleSeq, filled_circle_seq=ReportDrawingDefinition.FilledCircleSeq, ellipse_seq=ReportDrawingDefinition.EllipseSeq, filled_ellipse_seq=ReportDrawingDefinition.FilledEllipseSeq, line_seq=ReportDrawingDefinition.LineSeq, polyline_list=ReportDrawingDefinition.PolylineList, polygon_list=ReportDrawingDefinition.PolygonList, filled_polygon_list=ReportDrawingDefinition.FilledPolygonList, arc_seq=ReportDrawingDefinition.ArcSeq, filled_arc_sec=ReportDrawingDefinition.FilledArcSec, push_var=ReportDrawingDefinition.PushVar, pop_var=ReportDrawingDefinition.PopVar, if_var=ReportDrawingDefinition.IfVar, else_if_var=ReportDrawingDefinition.ElseIfVar, else_var=ReportDrawingDefinition.ElseVar, end_if_var=ReportDrawingDefinition.EndIfVar, select_var=ReportDrawingDefinition.SelectVar, case_var=ReportDrawingDefinition.CaseVar, default_var=ReportDrawingDefinition.DefaultVar, end_select_var=ReportDrawingDefinition.EndSelectVar, image_seq=ReportDrawingDefinition.ImageSeq)))


@jd.message(_SERVICE, 0x2700, query=True)
class QueryDrawingDefinition(jd.Message):
    """QueryDrawingDefinition (0x2700): Asks for the picture."""
    REPORT = ReportDrawingDefinition


@jd.message(_SERVICE, 0x4701)
class ReportDataDefinition(jd.Message):
    """ReportDataDefinition (0x4701): Tells the types of the data that the picture uses.

    primitive_data_definition_list: 0..65535 items. The fields of the structure, in order
    """

    @jd.record()
    class ReferenceRec(jd.Struct):
        """data_structure_reference: Number of the data structure"""
        data_structure_reference: int = jd.field("DataStructureReference", jd.Number("H"))

    class PrimitiveDataDefinition(IntEnum):
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

    @jd.record()
    class PrimitiveDataDefinitionRec(jd.Struct):
        """primitive_data_definition: PrimitiveDataDefinition. Type of one field"""
        primitive_data_definition: ReportDataDefinition.PrimitiveDataDefinition | int = jd.field("PrimitiveDataDefinition", lambda: jd.Number("B", jd.Values(ReportDataDefinition.PrimitiveDataDefinition)))

    reference_rec: ReportDataDefinition.ReferenceRec = jd.field("ReferenceRec", lambda: ReportDataDefinition.ReferenceRec.layout())
    primitive_data_definition_list: list[ReportDataDefinition.PrimitiveDataDefinitionRec] = jd.field("PrimitiveDataDefinitionList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDataDefinition.PrimitiveDataDefinitionRec.layout()))


@jd.message(_SERVICE, 0x2701, query=True)
class QueryDataDefinition(jd.Message):
    """QueryDataDefinition (0x2701): Asks which data the picture uses."""
    REPORT = ReportDataDefinition


@jd.message(_SERVICE, 0x4702)
class ReportData(jd.Message):
    """ReportData (0x4702): Tells data that the picture uses.

    data_list: 0..65535 items. The fields of the structure, in order
    """

    @jd.record()
    class ReportDataRec(jd.Struct):
        """data_structure_reference: Number of the data structure"""
        data_structure_reference: int = jd.field("DataStructureReference", jd.Number("H"))

    @jd.record()
    class ByteRec(jd.Struct):
        """data: A byte"""
        data: int = jd.field("Data", jd.Number("B"))

    @jd.record()
    class ShortIntRec(jd.Struct):
        """data: A signed 16-bit number"""
        data: int = jd.field("Data", jd.Number("h"))

    @jd.record()
    class IntegerRec(jd.Struct):
        """data: A signed 32-bit number"""
        data: int = jd.field("Data", jd.Number("i"))

    @jd.record()
    class LongIntRec(jd.Struct):
        """data: A signed 64-bit number"""
        data: int = jd.field("Data", jd.Number("q"))

    @jd.record()
    class UShortIntRec(jd.Struct):
        """data: An unsigned 16-bit number"""
        data: int = jd.field("Data", jd.Number("H"))

    @jd.record()
    class UIntegerRec(jd.Struct):
        """data: An unsigned 32-bit number"""
        data: int = jd.field("Data", jd.Number("I"))

    @jd.record()
    class ULongIntRec(jd.Struct):
        """data: An unsigned 64-bit number"""
        data: int = jd.field("Data", jd.Number("Q"))

    @jd.record()
    class FloatRec(jd.Struct):
        """data: A 32-bit real number"""
        data: float = jd.field("Data", jd.Number("f"))

    @jd.record()
    class LongFloatRec(jd.Struct):
        """data: A 64-bit real number"""
        data: float = jd.field("Data", jd.Number("d"))

    @jd.record()
    class ByteList(jd.Struct):
        """Bytes.

        byte_list: 0..255 items. Bytes
        """
        byte_list: list[ReportData.ByteRec] = jd.field("ByteList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.ByteRec.layout()))

    @jd.record()
    class ShortIntList(jd.Struct):
        """Signed 16-bit numbers.

        short_int_list: 0..255 items. Signed 16-bit numbers
        """
        short_int_list: list[ReportData.ShortIntRec] = jd.field("ShortIntList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.ShortIntRec.layout()))

    @jd.record()
    class IntegerList(jd.Struct):
        """Signed 32-bit numbers.

        integer_list: 0..255 items. Signed 32-bit numbers
        """
        integer_list: list[ReportData.IntegerRec] = jd.field("IntegerList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.IntegerRec.layout()))

    @jd.record()
    class LongIntList(jd.Struct):
        """Signed 64-bit numbers.

        long_int_list: 0..255 items. Signed 64-bit numbers
        """
        long_int_list: list[ReportData.LongIntRec] = jd.field("LongIntList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.LongIntRec.layout()))

    @jd.record()
    class UShortIntList(jd.Struct):
        """Unsigned 16-bit numbers.

        u_short_int_list: 0..255 items. Unsigned 16-bit numbers
        """
        u_short_int_list: list[ReportData.UShortIntRec] = jd.field("UShortIntList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.UShortIntRec.layout()))

    @jd.record()
    class UIntegerList(jd.Struct):
        """Unsigned 32-bit numbers.

        u_integer_list: 0..255 items. Unsigned 32-bit numbers
        """
        u_integer_list: list[ReportData.UIntegerRec] = jd.field("UIntegerList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.UIntegerRec.layout()))

    @jd.record()
    class ULongIntList(jd.Struct):
        """Unsigned 64-bit numbers.

        u_long_int_list: 0..255 items. Unsigned 64-bit numbers
        """
        u_long_int_list: list[ReportData.ULongIntRec] = jd.field("ULongIntList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.ULongIntRec.layout()))

    @jd.record()
    class FloatList(jd.Struct):
        """32-bit real numbers.

        float_list: 0..255 items. 32-bit real numbers
        """
        float_list: list[ReportData.FloatRec] = jd.field("FloatList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.FloatRec.layout()))

    @jd.record()
    class LongFloatList(jd.Struct):
        """64-bit real numbers.

        long_float_list: 0..255 items. 64-bit real numbers
        """
        long_float_list: list[ReportData.LongFloatRec] = jd.field("LongFloatList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.LongFloatRec.layout()))

    @jd.record()
    class CharList(jd.Struct):
        """Characters.

        char_list: 0..255 items. Characters
        """
        char_list: list[ReportData.ByteRec] = jd.field("CharList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportData.ByteRec.layout()))

    report_data_rec: ReportData.ReportDataRec = jd.field("ReportDataRec", lambda: ReportData.ReportDataRec.layout())
    data_list: list[ReportData.ByteRec | ReportData.ShortIntRec | ReportData.IntegerRec | ReportData.LongIntRec | ReportData.UShortIntRec | ReportData.UIntegerRec | ReportData.ULongIntRec | ReportData.FloatRec | ReportData.LongFloatRec | ReportData.ByteList | ReportData.ShortIntList | ReportData.IntegerList | ReportData.LongIntList | ReportData.UShortIntList | ReportData.UIntegerList | ReportData.ULongIntList | ReportData.FloatList | ReportData.LongFloatList | ReportData.CharList] = jd.field("DataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), jd.Union.of("B", byte_rec=ReportData.ByteRec, short_int_rec=ReportData.ShortIntRec, integer_rec=ReportData.IntegerRec, long_int_rec=ReportData.LongIntRec, u_short_int_rec=ReportData.UShortIntRec, u_integer_rec=ReportData.UIntegerRec, u_long_int_rec=ReportData.ULongIntRec, float_rec=ReportData.FloatRec, long_float_rec=ReportData.LongFloatRec, byte_list=ReportData.ByteList, short_int_list=ReportData.ShortIntList, integer_list=ReportData.IntegerList, long_int_list=ReportData.LongIntList, u_short_int_list=ReportData.UShortIntList, u_integer_list=ReportData.UIntegerList, u_long_int_list=ReportData.ULongIntList, float_list=ReportData.FloatList, long_float_list=ReportData.LongFloatList, char_list=ReportData.CharList)))


@jd.message(_SERVICE, 0x2702, query=True)
class QueryData(jd.Message):
    """QueryData (0x2702): Asks for data that the picture uses.

    data_structure_reference: Number of the data structure
    """
    REPORT = ReportData
    data_structure_reference: int = jd.field("DataStructureReference", jd.Number("H"))
