"""Messages of iop, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.iop.v1_0.data_logging import (
        QueryLoggerCapability as QueryLoggerCapability, QueryLoggerConfiguration as QueryLoggerConfiguration,
        QueryLoggerStatus as QueryLoggerStatus, ReportLoggerCapability as ReportLoggerCapability,
        ReportLoggerConfiguration as ReportLoggerConfiguration, ReportLoggerStatus as ReportLoggerStatus,
        SetLoggerConfiguration as SetLoggerConfiguration,
        SetLoggerConfigurationResponse as SetLoggerConfigurationResponse, SetLoggerState as SetLoggerState,
    )
    from jauspy.messages.iop.v1_0.enhanced_global_waypoint_list_driver import (
        QueryEnhancedGlobalWaypointInformation as QueryEnhancedGlobalWaypointInformation,
        QueryGlobalWaypointStatus as QueryGlobalWaypointStatus,
        ReportEnhancedGlobalWaypointInformation as ReportEnhancedGlobalWaypointInformation,
        ReportGlobalWaypointStatus as ReportGlobalWaypointStatus,
        SetEnhancedGlobalWaypointInformation as SetEnhancedGlobalWaypointInformation,
    )
    from jauspy.messages.iop.v1_0.enhanced_local_waypoint_list_driver import (
        QueryEnhancedLocalWaypointInformation as QueryEnhancedLocalWaypointInformation,
        QueryLocalWaypointStatus as QueryLocalWaypointStatus,
        ReportEnhancedLocalWaypointInformation as ReportEnhancedLocalWaypointInformation,
        ReportLocalWaypointStatus as ReportLocalWaypointStatus,
        SetEnhancedLocalWaypointInformation as SetEnhancedLocalWaypointInformation,
    )
    from jauspy.messages.iop.v1_0.h264_video_encoding import (
        QueryH264VideoEncodingCapabilities as QueryH264VideoEncodingCapabilities,
        QueryH264VideoEncodingConfiguration as QueryH264VideoEncodingConfiguration,
        ReportH264VideoEncodingCapabilities as ReportH264VideoEncodingCapabilities,
        ReportH264VideoEncodingConfiguration as ReportH264VideoEncodingConfiguration,
        SetH264VideoEncodingConfiguration as SetH264VideoEncodingConfiguration,
    )
    from jauspy.messages.iop.v1_0.military_illumination_service import (
        QueryMilitaryIlluminationMode as QueryMilitaryIlluminationMode,
        ReportMilitaryIlluminationMode as ReportMilitaryIlluminationMode,
        SetMilitaryIlluminationMode as SetMilitaryIlluminationMode,
    )
    from jauspy.messages.iop.v1_0.types import (
        CostAndConfidenceDataRec as CostAndConfidenceDataRec, CostDataRec as CostDataRec,
        CostMap2DGlobalPoseRec as CostMap2DGlobalPoseRec, CostMap2DLocalPoseRec as CostMap2DLocalPoseRec,
        CostMap2DRec as CostMap2DRec, DeviceRec as DeviceRec,
        DigitalResourceEndpointRec as DigitalResourceEndpointRec, FilterType as FilterType,
        GlobalPoseRec as GlobalPoseRec, GlobalVertexRec as GlobalVertexRec, JAUS_ID as JAUS_ID,
        LocalVertexRec as LocalVertexRec, ParentID as ParentID,
        PathReporterCapabilitiesRec as PathReporterCapabilitiesRec, QueryCostMap2DRec as QueryCostMap2DRec,
        ReadingRec as ReadingRec, ReleaseControlRec as ReleaseControlRec,
        RunLengthEncodedDataRec as RunLengthEncodedDataRec, TimestampRec as TimestampRec, ValueRec as ValueRec,
        WaypointInformationRec as WaypointInformationRec,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.iop.v1_0.data_logging": "QueryLoggerCapability QueryLoggerConfiguration QueryLoggerStatus ReportLoggerCapability ReportLoggerConfiguration ReportLoggerStatus SetLoggerConfiguration SetLoggerConfigurationResponse SetLoggerState",
    "jauspy.messages.iop.v1_0.enhanced_global_waypoint_list_driver": "QueryEnhancedGlobalWaypointInformation QueryGlobalWaypointStatus ReportEnhancedGlobalWaypointInformation ReportGlobalWaypointStatus SetEnhancedGlobalWaypointInformation",
    "jauspy.messages.iop.v1_0.enhanced_local_waypoint_list_driver": "QueryEnhancedLocalWaypointInformation QueryLocalWaypointStatus ReportEnhancedLocalWaypointInformation ReportLocalWaypointStatus SetEnhancedLocalWaypointInformation",
    "jauspy.messages.iop.v1_0.h264_video_encoding": "QueryH264VideoEncodingCapabilities QueryH264VideoEncodingConfiguration ReportH264VideoEncodingCapabilities ReportH264VideoEncodingConfiguration SetH264VideoEncodingConfiguration",
    "jauspy.messages.iop.v1_0.military_illumination_service": "QueryMilitaryIlluminationMode ReportMilitaryIlluminationMode SetMilitaryIlluminationMode",
    "jauspy.messages.iop.v1_0.types": "CostAndConfidenceDataRec CostDataRec CostMap2DGlobalPoseRec CostMap2DLocalPoseRec CostMap2DRec DeviceRec DigitalResourceEndpointRec FilterType GlobalPoseRec GlobalVertexRec JAUS_ID LocalVertexRec ParentID PathReporterCapabilitiesRec QueryCostMap2DRec ReadingRec ReleaseControlRec RunLengthEncodedDataRec TimestampRec ValueRec WaypointInformationRec",
})
