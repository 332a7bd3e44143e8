"""Messages of iop, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_0.types import (
        SeverityRec as SeverityRec, UGVSeverityRec as UGVSeverityRec,
    )
    from jauspy.messages.exp.v1_4.health_monitor import (
        QueryUGVSummary as QueryUGVSummary, ReportUGVSummary as ReportUGVSummary,
        UpdateUGVSummary as UpdateUGVSummary,
    )
    from jauspy.messages.iop.v1_0.types import (
        CostAndConfidenceDataRec as CostAndConfidenceDataRec, CostDataRec as CostDataRec,
        CostMap2DGlobalPoseRec as CostMap2DGlobalPoseRec, CostMap2DLocalPoseRec as CostMap2DLocalPoseRec,
        CostMap2DRec as CostMap2DRec, DeviceRec as DeviceRec,
        DigitalResourceEndpointRec as DigitalResourceEndpointRec, GlobalPoseRec as GlobalPoseRec,
        GlobalVertexRec as GlobalVertexRec, LocalVertexRec as LocalVertexRec,
        PathReporterCapabilitiesRec as PathReporterCapabilitiesRec, QueryCostMap2DRec as QueryCostMap2DRec,
        ReadingRec as ReadingRec, ReleaseControlRec as ReleaseControlRec,
        RunLengthEncodedDataRec as RunLengthEncodedDataRec, TimestampRec as TimestampRec, ValueRec as ValueRec,
    )
    from jauspy.messages.iop.v1_1.cbrn_sensor import (
        CBDetailedMeasurement as CBDetailedMeasurement, CBRN4 as CBRN4, CBRNCommand as CBRNCommand,
        CBRNConfigurationCommand as CBRNConfigurationCommand, CBRNConfigurationState as CBRNConfigurationState,
        CBRNDetection as CBRNDetection, CBRNDisplayConfigurationCommand as CBRNDisplayConfigurationCommand,
        CBRNOperatingState as CBRNOperatingState,
        CBRNScanWindowConfigurationCommand as CBRNScanWindowConfigurationCommand,
        CBRNScanWindowOperatingState as CBRNScanWindowOperatingState,
        QueryCBDetailedMeasurement as QueryCBDetailedMeasurement, QueryCBRN4 as QueryCBRN4,
        QueryCBRNConfiguration as QueryCBRNConfiguration, QueryCBRNDetection as QueryCBRNDetection,
        QueryCBRNOperatingState as QueryCBRNOperatingState,
        QueryCBRNScanWindowOperatingState as QueryCBRNScanWindowOperatingState,
        QueryRNDetailedMeasurement as QueryRNDetailedMeasurement, RNDetailedMeasurement as RNDetailedMeasurement,
    )
    from jauspy.messages.iop.v1_1.cost_map2d import (
        AddNoGoZone as AddNoGoZone, AddNoGoZoneResponse as AddNoGoZoneResponse, QueryCostMap2D as QueryCostMap2D,
        QueryNoGoZones as QueryNoGoZones, RemoveNoGoZone as RemoveNoGoZone, ReportCostMap2D as ReportCostMap2D,
        ReportNoGoZones as ReportNoGoZones,
    )
    from jauspy.messages.iop.v1_1.digital_resource_discovery import (
        ConfirmDigitalResourceEndpoint as ConfirmDigitalResourceEndpoint,
        QueryDigitalResourceEndpoint as QueryDigitalResourceEndpoint,
        RegisterDigitalResourceEndpoint as RegisterDigitalResourceEndpoint,
        RemoveDigitalResourceEndpoint as RemoveDigitalResourceEndpoint,
        ReportDigitalResourceEndpoint as ReportDigitalResourceEndpoint,
    )
    from jauspy.messages.iop.v1_1.enhanced_access_control import (
        ConfirmHandoffRequest as ConfirmHandoffRequest, ConfirmReleaseControl as ConfirmReleaseControl,
        QueryEnhancedTimeout as QueryEnhancedTimeout, QueryHandoffTimeout as QueryHandoffTimeout,
        RemoveHandoffRequest as RemoveHandoffRequest, ReportEnhancedTimeout as ReportEnhancedTimeout,
        ReportHandoffTimeout as ReportHandoffTimeout, RequestHandoff as RequestHandoff,
    )
    from jauspy.messages.iop.v1_1.handoff_controller import (
        RequestReleaseControl as RequestReleaseControl,
    )
    from jauspy.messages.iop.v1_1.measurement_sensor import (
        QueryMeasurement as QueryMeasurement, ReportMeasurement as ReportMeasurement,
    )
    from jauspy.messages.iop.v1_1.path_reporter import (
        QueryPath as QueryPath, QueryPathReporterCapabilities as QueryPathReporterCapabilities,
        ReportPath as ReportPath, ReportPathReporterCapabilities as ReportPathReporterCapabilities,
    )
    from jauspy.messages.iop.v1_1.platform_mode import (
        QueryPlatformMode as QueryPlatformMode, QuerySupportedPlatformModes as QuerySupportedPlatformModes,
        ReportPlatformMode as ReportPlatformMode, ReportSupportedPlatformModes as ReportSupportedPlatformModes,
        SetPlatformMode as SetPlatformMode,
    )
    from jauspy.messages.iop.v1_1.platform_state import (
        ClearEmergency as ClearEmergency, ConfirmPlatformStateRequest as ConfirmPlatformStateRequest,
        QueryPlatformState as QueryPlatformState, ReportPlatformState as ReportPlatformState,
        SetEmergency as SetEmergency, SetPlatformState as SetPlatformState,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.exp.v1_0.types": "SeverityRec UGVSeverityRec",
    "jauspy.messages.exp.v1_4.health_monitor": "QueryUGVSummary ReportUGVSummary UpdateUGVSummary",
    "jauspy.messages.iop.v1_0.types": "CostAndConfidenceDataRec CostDataRec CostMap2DGlobalPoseRec CostMap2DLocalPoseRec CostMap2DRec DeviceRec DigitalResourceEndpointRec GlobalPoseRec GlobalVertexRec LocalVertexRec PathReporterCapabilitiesRec QueryCostMap2DRec ReadingRec ReleaseControlRec RunLengthEncodedDataRec TimestampRec ValueRec",
    "jauspy.messages.iop.v1_1.cbrn_sensor": "CBDetailedMeasurement CBRN4 CBRNCommand CBRNConfigurationCommand CBRNConfigurationState CBRNDetection CBRNDisplayConfigurationCommand CBRNOperatingState CBRNScanWindowConfigurationCommand CBRNScanWindowOperatingState QueryCBDetailedMeasurement QueryCBRN4 QueryCBRNConfiguration QueryCBRNDetection QueryCBRNOperatingState QueryCBRNScanWindowOperatingState QueryRNDetailedMeasurement RNDetailedMeasurement",
    "jauspy.messages.iop.v1_1.cost_map2d": "AddNoGoZone AddNoGoZoneResponse QueryCostMap2D QueryNoGoZones RemoveNoGoZone ReportCostMap2D ReportNoGoZones",
    "jauspy.messages.iop.v1_1.digital_resource_discovery": "ConfirmDigitalResourceEndpoint QueryDigitalResourceEndpoint RegisterDigitalResourceEndpoint RemoveDigitalResourceEndpoint ReportDigitalResourceEndpoint",
    "jauspy.messages.iop.v1_1.enhanced_access_control": "ConfirmHandoffRequest ConfirmReleaseControl QueryEnhancedTimeout QueryHandoffTimeout RemoveHandoffRequest ReportEnhancedTimeout ReportHandoffTimeout RequestHandoff",
    "jauspy.messages.iop.v1_1.handoff_controller": "RequestReleaseControl",
    "jauspy.messages.iop.v1_1.measurement_sensor": "QueryMeasurement ReportMeasurement",
    "jauspy.messages.iop.v1_1.path_reporter": "QueryPath QueryPathReporterCapabilities ReportPath ReportPathReporterCapabilities",
    "jauspy.messages.iop.v1_1.platform_mode": "QueryPlatformMode QuerySupportedPlatformModes ReportPlatformMode ReportSupportedPlatformModes SetPlatformMode",
    "jauspy.messages.iop.v1_1.platform_state": "ClearEmergency ConfirmPlatformStateRequest QueryPlatformState ReportPlatformState SetEmergency SetPlatformState",
})
