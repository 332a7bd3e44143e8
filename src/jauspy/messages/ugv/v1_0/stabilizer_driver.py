"""urn:jaus:jss:ugv:StabilizerDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:StabilizerDriver", "1.0")


@jd.message(_SERVICE, 0x4503)
class ReportStabilizerEffort(jd.Message):
    """ReportStabilizerEffort (0x4503): Tells the efforts of stabilizers.

    stabilizer_effort: 0..255 items. The stabilizers
    """

    @jd.record()
    class StabilizerEffortRec(jd.Struct):
        """One stabilizer.

        stabilizer_id: Identifies the stabilizer
        effort: -100..100. Effort, in percent of the maximum; positive is up
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        effort: float = jd.field("Effort", jd.real("H", -100.0, 100.0))

    stabilizer_effort: list[ReportStabilizerEffort.StabilizerEffortRec] = jd.field("stabilizerEffort", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportStabilizerEffort.StabilizerEffortRec.layout()))


@jd.message(_SERVICE, 0x2503, query=True)
class QueryStabilizerEffort(jd.Message):
    """QueryStabilizerEffort (0x2503): Asks for the efforts of stabilizers.

    stabilizer_id: 0..255 items. The stabilizers
    """
    REPORT = ReportStabilizerEffort

    @jd.record()
    class QueryStabilizerRec(jd.Struct):
        """stabilizer_id: Identifies the stabilizer"""
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))

    stabilizer_id: list[QueryStabilizerEffort.QueryStabilizerRec] = jd.field("stabilizerID", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryStabilizerEffort.QueryStabilizerRec.layout()))


@jd.message(_SERVICE, 0x4505)
class ReportStabilizerCapabilities(jd.Message):
    """ReportStabilizerCapabilities (0x4505): Tells limits and outline of stabilizers.

    stabilizer_capabilities: 0..255 items. The stabilizers
    """

    @jd.record()
    class StabilizerCapabilitiesRec(jd.Struct):
        """stabilizer_id: Identifies the stabilizer
        maximum_up_angle: 0..3.14159 radian. Highest angle, in radians
        maximum_down_angle: -3.14158..0 radian. Lowest angle, in radians; 0 or negative
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        maximum_up_angle: float = jd.field("MaximumUpAngle", jd.real("H", 0.0, 3.14159, "radian"))
        maximum_down_angle: float = jd.field("MaximumDownAngle", jd.real("H", -3.14158, 0.0, "radian"))

    @jd.record()
    class Points(jd.Struct):
        """point_x: -32.768..32.767 meter. Position of the corner along X, in metres
        point_y: -32.768..32.767 meter. Position of the corner along Y, in metres
        point_z: -32.768..32.767 meter. Position of the corner along Z, in metres
        """
        point_x: float = jd.field("PointX", jd.real("H", -32.768, 32.767, "meter"))
        point_y: float = jd.field("PointY", jd.real("H", -32.768, 32.767, "meter"))
        point_z: float = jd.field("PointZ", jd.real("H", -32.768, 32.767, "meter"))

    @jd.record()
    class StabilizerCapabilitiesSeq(jd.Struct):
        """stabilizer_dimensions_list: 0..255 items. Corners of the outline"""
        stabilizer_capabilities_rec: ReportStabilizerCapabilities.StabilizerCapabilitiesRec = jd.field("stabilizerCapabilitiesRec", lambda: ReportStabilizerCapabilities.StabilizerCapabilitiesRec.layout())
        stabilizer_dimensions_list: list[ReportStabilizerCapabilities.Points] = jd.field("stabilizerDimensionsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportStabilizerCapabilities.Points.layout()))

    stabilizer_capabilities: list[ReportStabilizerCapabilities.StabilizerCapabilitiesSeq] = jd.field("stabilizerCapabilities", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportStabilizerCapabilities.StabilizerCapabilitiesSeq.layout()))


@jd.message(_SERVICE, 0x2505, query=True)
class QueryStabilizerCapabilities(jd.Message):
    """QueryStabilizerCapabilities (0x2505): Asks for limits and outline of stabilizers."""
    REPORT = ReportStabilizerCapabilities


@jd.message(_SERVICE, 0x0503, command=True)
class SetStabilizerEffort(jd.Message):
    """SetStabilizerEffort (0x0503): Sets the efforts of stabilizers.

    stabilizer_effort: 0..255 items. The stabilizers
    """

    @jd.record()
    class StabilizerEffortRec(jd.Struct):
        """One stabilizer.

        stabilizer_id: Identifies the stabilizer
        effort: -100..100. Effort, in percent of the maximum; positive is up
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        effort: float = jd.field("Effort", jd.real("H", -100.0, 100.0))

    stabilizer_effort: list[SetStabilizerEffort.StabilizerEffortRec] = jd.field("stabilizerEffort", lambda: jd.Repeat(jd.Count("B", 0, 255), SetStabilizerEffort.StabilizerEffortRec.layout()))


@jd.message(_SERVICE, 0x0504, command=True)
class SetStabilizerPosition(jd.Message):
    """SetStabilizerPosition (0x0504): Sets the angles of stabilizers.

    stabilizer_position: 0..255 items. The stabilizers
    """

    @jd.record()
    class StabilizerPositionRec(jd.Struct):
        """stabilizer_id: Identifies the stabilizer
        position: -3.14159..3.14159 radian. Wanted angle, in radians; positive is up
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        position: float = jd.field("Position", jd.real("H", -3.14159, 3.14159, "radian"))

    stabilizer_position: list[SetStabilizerPosition.StabilizerPositionRec] = jd.field("stabilizerPosition", lambda: jd.Repeat(jd.Count("B", 0, 255), SetStabilizerPosition.StabilizerPositionRec.layout()))


@jd.message(_SERVICE, 0x4504)
class ReportStabilizerPosition(jd.Message):
    """ReportStabilizerPosition (0x4504): Tells the angles of stabilizers.

    stabilizer_position: 0..255 items. The stabilizers
    """

    @jd.record()
    class StabilizerPositionRec(jd.Struct):
        """stabilizer_id: Identifies the stabilizer
        commanded_position: -3.14159..3.14159 radian. Wanted angle, in radians; positive is up
        actual_position: -3.14159..3.14159 radian. Present angle, in radians; positive is up
        """
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))
        commanded_position: float = jd.field("CommandedPosition", jd.real("H", -3.14159, 3.14159, "radian"))
        actual_position: float = jd.field("ActualPosition", jd.real("H", -3.14159, 3.14159, "radian"))

    stabilizer_position: list[ReportStabilizerPosition.StabilizerPositionRec] = jd.field("stabilizerPosition", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportStabilizerPosition.StabilizerPositionRec.layout()))


@jd.message(_SERVICE, 0x2504, query=True)
class QueryStabilizerPosition(jd.Message):
    """QueryStabilizerPosition (0x2504): Asks for the angles of stabilizers.

    stabilizer_id: 0..255 items. The stabilizers
    """
    REPORT = ReportStabilizerPosition

    @jd.record()
    class QueryStabilizerRec(jd.Struct):
        """stabilizer_id: Identifies the stabilizer"""
        stabilizer_id: int = jd.field("StabilizerID", jd.Number("B"))

    stabilizer_id: list[QueryStabilizerPosition.QueryStabilizerRec] = jd.field("stabilizerID", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryStabilizerPosition.QueryStabilizerRec.layout()))
