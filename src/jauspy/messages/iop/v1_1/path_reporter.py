"""urn:jaus:jss:iop:PathReporter 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:PathReporter", "1.1")


@jd.message(_SERVICE, 0xDEF2)
class ReportPathReporterCapabilities(jd.Message):
    """ReportPathReporterCapabilities (0xDEF2): Tells which paths can be reported.

    path_reporter_capabilities_list: 0..255 items. The kinds of path
    """
    PathReporterCapabilitiesRec = iop_v1_0_types.PathReporterCapabilitiesRec
    path_reporter_capabilities_list: list[iop_v1_0_types.PathReporterCapabilitiesRec] = jd.field("PathReporterCapabilitiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.PathReporterCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0xDEF0, query=True)
class QueryPathReporterCapabilities(jd.Message):
    """QueryPathReporterCapabilities (0xDEF0): Asks which paths can be reported."""
    REPORT = ReportPathReporterCapabilities


@jd.message(_SERVICE, 0xDEF3)
class ReportPath(jd.Message):
    """ReportPath (0xDEF3): Tells a path.

    path_var: The points, in the order of travel
    """
    GlobalPoseRec = mobility_v1_0_types.GlobalPoseRec
    LocalPoseRec = mobility_v1_0_types.LocalPoseRec

    @jd.record()
    class HistoricalGlobalPath(jd.Struct):
        """The path travelled, on the globe.

        historical_global_path: 0..65535 items. The path travelled, on the globe
        """
        historical_global_path: list[mobility_v1_0_types.GlobalPoseRec] = jd.field("HistoricalGlobalPath", lambda: jd.Repeat(jd.Count("H", 0, 65535), mobility_v1_0_types.GlobalPoseRec.layout()))

    @jd.record()
    class HistoricalLocalPath(jd.Struct):
        """The path travelled, in the local frame.

        historical_local_path: 0..65535 items. The path travelled, in the local frame
        """
        historical_local_path: list[mobility_v1_0_types.LocalPoseRec] = jd.field("HistoricalLocalPath", lambda: jd.Repeat(jd.Count("H", 0, 65535), mobility_v1_0_types.LocalPoseRec.layout()))

    @jd.record()
    class PlannedGlobalPath(jd.Struct):
        """The path planned, on the globe.

        planned_global_path: 0..65535 items. The path planned, on the globe
        """
        planned_global_path: list[mobility_v1_0_types.GlobalPoseRec] = jd.field("PlannedGlobalPath", lambda: jd.Repeat(jd.Count("H", 0, 65535), mobility_v1_0_types.GlobalPoseRec.layout()))

    @jd.record()
    class PlannedLocalPath(jd.Struct):
        """The path planned, in the local frame.

        planned_local_path: 0..65535 items. The path planned, in the local frame
        """
        planned_local_path: list[mobility_v1_0_types.LocalPoseRec] = jd.field("PlannedLocalPath", lambda: jd.Repeat(jd.Count("H", 0, 65535), mobility_v1_0_types.LocalPoseRec.layout()))

    path_var: ReportPath.HistoricalGlobalPath | ReportPath.HistoricalLocalPath | ReportPath.PlannedGlobalPath | ReportPath.PlannedLocalPath = jd.field("PathVar", lambda: jd.Union.of("B", historical_global_path=ReportPath.HistoricalGlobalPath, historical_local_path=ReportPath.HistoricalLocalPath, planned_global_path=ReportPath.PlannedGlobalPath, planned_local_path=ReportPath.PlannedLocalPath))


@jd.message(_SERVICE, 0xDEF1, presence="B", query=True)
class QueryPath(jd.Message):
    """QueryPath (0xDEF1): Asks for a path.

    path_type: PathType. Whether the path was travelled or is planned, and its frame
    target_resolution: 0..10000 meter, optional. Wanted distance of points, in metres
    maximum_points: optional. Largest number of points
    maximum_distance: in meter, optional. Largest length of the path, in metres
    maximum_time: in second, optional. Longest time that the path covers, in seconds
    """
    REPORT = ReportPath

    class PathType(IntEnum):
        HISTORICAL_GLOBAL_PATH = 0
        HISTORICAL_LOCAL_PATH = 1
        PLANNED_GLOBAL_PATH = 2
        PLANNED_LOCAL_PATH = 3

    path_type: QueryPath.PathType | int = jd.field("PathType", lambda: jd.Number("B", jd.Values(QueryPath.PathType)))
    target_resolution: float | None = jd.field("TargetResolution", jd.real("H", 0.0, 10000.0, "meter"), default=None)
    maximum_points: int | None = jd.field("MaximumPoints", jd.Number("H"), default=None)
    maximum_distance: int | None = jd.field("MaximumDistance", jd.Number("I", jd.ANY, "meter"), default=None)
    maximum_time: int | None = jd.field("MaximumTime", jd.Number("I", jd.ANY, "second"), default=None)
    reserved_presence: int = 0
