"""Messages of iop, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_0.types import (
        AttachmentFrameRecord as AttachmentFrameRecord, EncodingQuality as EncodingQuality,
        EndpointRecord as EndpointRecord, Formats as Formats, SampleWidths as SampleWidths,
        SeverityRec as SeverityRec, UGVSeverityRec as UGVSeverityRec,
    )
    from jauspy.messages.exp.v1_1.component_physical_properties import (
        QueryMassProperties as QueryMassProperties, QueryShape as QueryShape,
        ReportMassProperties as ReportMassProperties, ReportShape as ReportShape,
    )
    from jauspy.messages.exp.v1_1.mount_site_properties import (
        QueryMountSite as QueryMountSite, ReportMountSite as ReportMountSite,
    )
    from jauspy.messages.exp.v1_1.passthrough_message import (
        QueryPassthroughMessageProperties as QueryPassthroughMessageProperties,
        ReportPassthroughMessageProperties as ReportPassthroughMessageProperties,
        SetPassthroughMessage as SetPassthroughMessage,
    )
    from jauspy.messages.exp.v1_4.aeodrs_digital_video import (
        QueryAimpointParameters as QueryAimpointParameters, QueryDigitalVideoEndpoint as QueryDigitalVideoEndpoint,
        ReportAimpointParameters as ReportAimpointParameters,
        ReportDigitalVideoEndpoint as ReportDigitalVideoEndpoint,
        SetDigitalVideoEndpoint as SetDigitalVideoEndpoint,
    )
    from jauspy.messages.exp.v1_4.aeodrs_video_illuminator import (
        QueryDigitalVideoIlluminator as QueryDigitalVideoIlluminator,
        QueryDigitalVideoIlluminatorCapabilities as QueryDigitalVideoIlluminatorCapabilities,
        QueryDigitalVideoIlluminatorConfiguration as QueryDigitalVideoIlluminatorConfiguration,
        ReportDigitalVideoIlluminator as ReportDigitalVideoIlluminator,
        ReportDigitalVideoIlluminatorCapabilities as ReportDigitalVideoIlluminatorCapabilities,
        ReportDigitalVideoIlluminatorConfiguration as ReportDigitalVideoIlluminatorConfiguration,
        SetDigitalVideoIlluminator as SetDigitalVideoIlluminator,
        SetDigitalVideoIlluminatorConfiguration as SetDigitalVideoIlluminatorConfiguration,
    )
    from jauspy.messages.exp.v1_4.digital_audio_annuciator import (
        ConfirmAnnunciatorStream as ConfirmAnnunciatorStream, ControlAnnunciatorStream as ControlAnnunciatorStream,
        QueryAnnunciatorCapabilities as QueryAnnunciatorCapabilities,
        QueryAnnunciatorConfiguration as QueryAnnunciatorConfiguration,
        QueryAnnunciatorEndpoint as QueryAnnunciatorEndpoint,
        ReportAnnunciatorCapabilities as ReportAnnunciatorCapabilities,
        ReportAnnunciatorConfiguration as ReportAnnunciatorConfiguration,
        ReportAnnunciatorEndpoint as ReportAnnunciatorEndpoint,
        SetAnnunciatorConfiguration as SetAnnunciatorConfiguration,
    )
    from jauspy.messages.exp.v1_4.digital_audio_sensor import (
        ControlDigitalAudioSensorStream as ControlDigitalAudioSensorStream,
        QueryDigitalAudioSensorCapabilities as QueryDigitalAudioSensorCapabilities,
        QueryDigitalAudioSensorConfiguration as QueryDigitalAudioSensorConfiguration,
        QueryDigitalAudioSensorStreamEndpoint as QueryDigitalAudioSensorStreamEndpoint,
        ReportDigitalAudioSensorCapabilities as ReportDigitalAudioSensorCapabilities,
        ReportDigitalAudioSensorConfiguration as ReportDigitalAudioSensorConfiguration,
        ReportDigitalAudioSensorStreamEndpoint as ReportDigitalAudioSensorStreamEndpoint,
        SetDigitalAudioSensorConfiguration as SetDigitalAudioSensorConfiguration,
        SetDigitalAudioSensorStreamEndpoint as SetDigitalAudioSensorStreamEndpoint,
    )
    from jauspy.messages.exp.v1_4.health_monitor import (
        QueryUGVSummary as QueryUGVSummary, ReportUGVSummary as ReportUGVSummary,
        UpdateUGVSummary as UpdateUGVSummary,
    )
    from jauspy.messages.exp.v1_4.health_reporter import (
        QueryHealthDetails as QueryHealthDetails, QueryHealthSummary as QueryHealthSummary,
        QueryHourMeter as QueryHourMeter, QueryReminder as QueryReminder,
        QueryReminderSummary as QueryReminderSummary, ReportHealthDetails as ReportHealthDetails,
        ReportHealthSummary as ReportHealthSummary, ReportHourMeter as ReportHourMeter,
        ReportReminder as ReportReminder, ReportReminderSummary as ReportReminderSummary,
        ResetReminder as ResetReminder, UpdateHealthReporter as UpdateHealthReporter,
    )
    from jauspy.messages.exp.v1_4.subsystem_id_allocator import (
        GrantSubsystemID as GrantSubsystemID, QuerySubsystemIDs as QuerySubsystemIDs,
        ReportSubsystemIDs as ReportSubsystemIDs, RequestSubsystemID as RequestSubsystemID,
    )
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
    from jauspy.messages.iop.v1_1.acoustic_sensor import (
        QueryAcousticSensorStatus as QueryAcousticSensorStatus,
        ReportAcousticSensorStatus as ReportAcousticSensorStatus,
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
    from jauspy.messages.iop.v1_1.comms_lost_policy_manager import (
        QueryCommsLostCapabilities as QueryCommsLostCapabilities,
        QueryCommsLostConfiguration as QueryCommsLostConfiguration, QueryCommsLostStatus as QueryCommsLostStatus,
        ReportCommsLostCapabilities as ReportCommsLostCapabilities,
        ReportCommsLostConfiguration as ReportCommsLostConfiguration,
        ReportCommsLostStatus as ReportCommsLostStatus, SetCommsLostPolicy as SetCommsLostPolicy,
        SetCommsLostPolicyResponse as SetCommsLostPolicyResponse,
    )
    from jauspy.messages.iop.v1_1.communicator import (
        QueryCommunicatorCapability as QueryCommunicatorCapability,
        QueryCommunicatorConfiguration as QueryCommunicatorConfiguration,
        QueryCommunicatorHealth as QueryCommunicatorHealth,
        ReportCommunicatorCapability as ReportCommunicatorCapability,
        ReportCommunicatorConfiguration as ReportCommunicatorConfiguration,
        ReportCommunicatorHealth as ReportCommunicatorHealth,
        SetCommunicatorConfiguration as SetCommunicatorConfiguration,
        SetCommunicatorConfigurationResponse as SetCommunicatorConfigurationResponse,
    )
    from jauspy.messages.iop.v1_1.convoy import (
        QueryConvoyDetails as QueryConvoyDetails, ReportConvoyDetails as ReportConvoyDetails,
        UpdateConvoyDetails as UpdateConvoyDetails,
    )
    from jauspy.messages.iop.v1_1.cost_map2d import (
        AddNoGoZone as AddNoGoZone, AddNoGoZoneResponse as AddNoGoZoneResponse, QueryCostMap2D as QueryCostMap2D,
        QueryNoGoZones as QueryNoGoZones, RemoveNoGoZone as RemoveNoGoZone, ReportCostMap2D as ReportCostMap2D,
        ReportNoGoZones as ReportNoGoZones,
    )
    from jauspy.messages.iop.v1_1.debris_blower_service import (
        QueryDebrisBlowerCapabilities as QueryDebrisBlowerCapabilities,
        QueryDebrisBlowerConfiguration as QueryDebrisBlowerConfiguration,
        ReportDebrisBlowerCapabilities as ReportDebrisBlowerCapabilities,
        ReportDebrisBlowerConfiguration as ReportDebrisBlowerConfiguration,
        SetDebrisBlowerConfiguration as SetDebrisBlowerConfiguration,
    )
    from jauspy.messages.iop.v1_1.digital_audio import (
        QueryDigitalAudioCapabilities as QueryDigitalAudioCapabilities,
        QueryDigitalAudioConfiguration as QueryDigitalAudioConfiguration,
        ReportDigitalAudioCapabilities as ReportDigitalAudioCapabilities,
        ReportDigitalAudioConfiguration as ReportDigitalAudioConfiguration,
        SetDigitalAudioConfiguration as SetDigitalAudioConfiguration,
        SetDigitalAudioConfigurationResponse as SetDigitalAudioConfigurationResponse,
    )
    from jauspy.messages.iop.v1_1.digital_audio_annunciator import (
        QueryDigitalAudioStreamSource as QueryDigitalAudioStreamSource,
        ReportDigitalAudioStreamSource as ReportDigitalAudioStreamSource,
        SetDigitalAudioStreamSource as SetDigitalAudioStreamSource,
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
    from jauspy.messages.iop.v1_1.extended_primitive_manipulator import (
        QueryHostManipulator as QueryHostManipulator,
        QueryJointOperationalParameters as QueryJointOperationalParameters,
        ReportManipulatorHost as ReportManipulatorHost, ReportOperationalParameters as ReportOperationalParameters,
    )
    from jauspy.messages.iop.v1_1.extended_primitive_pan_tilt import (
        QueryPanTiltHostManipulator as QueryPanTiltHostManipulator,
        QueryPanTiltOperationalParameters as QueryPanTiltOperationalParameters,
        ReportPanTiltManipulatorHost as ReportPanTiltManipulatorHost,
        ReportPanTiltOperationalParameters as ReportPanTiltOperationalParameters,
    )
    from jauspy.messages.iop.v1_1.filter_mapper import (
        QueryComponentMappings as QueryComponentMappings, QueryFilterType as QueryFilterType,
        ReportComponentMappings as ReportComponentMappings, ReportFilterType as ReportFilterType,
    )
    from jauspy.messages.iop.v1_1.force_torque_sensor import (
        QueryForceTorque as QueryForceTorque, QueryForceTorqueCapabilities as QueryForceTorqueCapabilities,
        ReportForceTorque as ReportForceTorque, ReportForceTorqueCapabilities as ReportForceTorqueCapabilities,
    )
    from jauspy.messages.iop.v1_1.general_sensor import (
        QueryGeneralSensorCapabilities as QueryGeneralSensorCapabilities,
        QueryGeneralSensorConfiguration as QueryGeneralSensorConfiguration,
        ReportGeneralSensorCapabilities as ReportGeneralSensorCapabilities,
        ReportGeneralSensorConfiguration as ReportGeneralSensorConfiguration,
        SetGeneralSensorConfiguration as SetGeneralSensorConfiguration,
    )
    from jauspy.messages.iop.v1_1.guarded_teleop_policy_manager import (
        QueryGuardedTeleopCapabilities as QueryGuardedTeleopCapabilities,
        QueryGuardedTeleopConfiguration as QueryGuardedTeleopConfiguration,
        QueryGuardedTeleopStatus as QueryGuardedTeleopStatus,
        ReportGuardedTeleopCapabilities as ReportGuardedTeleopCapabilities,
        ReportGuardedTeleopConfiguration as ReportGuardedTeleopConfiguration,
        ReportGuardedTeleopStatus as ReportGuardedTeleopStatus, SetGuardedTeleopPolicy as SetGuardedTeleopPolicy,
        SetGuardedTeleopPolicyResponse as SetGuardedTeleopPolicyResponse,
    )
    from jauspy.messages.iop.v1_1.handoff_controller import (
        RequestReleaseControl as RequestReleaseControl,
    )
    from jauspy.messages.iop.v1_1.intelligent_vehicle_policy_manager import (
        QueryIntelligentVehicleCapabilities as QueryIntelligentVehicleCapabilities,
        QueryIntelligentVehicleConfiguration as QueryIntelligentVehicleConfiguration,
        QueryIntelligentVehicleStatus as QueryIntelligentVehicleStatus,
        ReportIntelligentVehicleCapabilities as ReportIntelligentVehicleCapabilities,
        ReportIntelligentVehicleConfiguration as ReportIntelligentVehicleConfiguration,
        ReportIntelligentVehicleStatus as ReportIntelligentVehicleStatus,
        SetIntelligentVehicleConfiguration as SetIntelligentVehicleConfiguration,
    )
    from jauspy.messages.iop.v1_1.leader_follower_driver import (
        QueryFollowerConfiguration as QueryFollowerConfiguration,
        ReportFollowerConfiguration as ReportFollowerConfiguration,
        SetFollowerConfiguration as SetFollowerConfiguration, SetFollowerState as SetFollowerState,
    )
    from jauspy.messages.iop.v1_1.leader_management import (
        QueryFollowers as QueryFollowers, RegisterFollower as RegisterFollower,
        RegisterFollowerResponse as RegisterFollowerResponse, ReportFollowers as ReportFollowers,
        RequestSpeedOverride as RequestSpeedOverride,
    )
    from jauspy.messages.iop.v1_1.loading_specifications_service import (
        QueryLoadingSpecifications as QueryLoadingSpecifications,
        ReportLoadingSpecifications as ReportLoadingSpecifications,
        SetLoadingSpecifications as SetLoadingSpecifications,
    )
    from jauspy.messages.iop.v1_1.magnetic_sensor import (
        QueryMagneticSensorStatus as QueryMagneticSensorStatus,
        ReportMagneticSensorStatus as ReportMagneticSensorStatus,
    )
    from jauspy.messages.iop.v1_1.manipulator_end_effector_force_torque_sensor import (
        QueryManipulatorEndEffectorForceTorque as QueryManipulatorEndEffectorForceTorque,
        ReportManipulatorEndEffectorForceTorque as ReportManipulatorEndEffectorForceTorque,
    )
    from jauspy.messages.iop.v1_1.measurement_sensor import (
        QueryMeasurement as QueryMeasurement, ReportMeasurement as ReportMeasurement,
    )
    from jauspy.messages.iop.v1_1.node_id_allocator import (
        GrantNodeID as GrantNodeID, RequestNodeID as RequestNodeID,
    )
    from jauspy.messages.iop.v1_1.path_reporter import (
        QueryPath as QueryPath, QueryPathReporterCapabilities as QueryPathReporterCapabilities,
        ReportPath as ReportPath, ReportPathReporterCapabilities as ReportPathReporterCapabilities,
    )
    from jauspy.messages.iop.v1_1.physical_specification_service import (
        QueryElectricalProperties as QueryElectricalProperties, QueryPhysicalProperties as QueryPhysicalProperties,
        ReportElectricalProperties as ReportElectricalProperties,
        ReportPhysicalProperties as ReportPhysicalProperties,
    )
    from jauspy.messages.iop.v1_1.platform_door_service import (
        QueryDoorStatus as QueryDoorStatus, ReportDoorStatus as ReportDoorStatus, SetDoorLock as SetDoorLock,
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
    from jauspy.messages.iop.v1_1.preset_pose import (
        QueryCurrentPose as QueryCurrentPose, QueryPresetPoseCapabilities as QueryPresetPoseCapabilities,
        QueryPresetPoseSpecifications as QueryPresetPoseSpecifications, ReportCurrentPose as ReportCurrentPose,
        ReportPresetPoseCapabilities as ReportPresetPoseCapabilities,
        ReportPresetPoseSpecifications as ReportPresetPoseSpecifications,
        ReportTransitionCompleted as ReportTransitionCompleted, SetCurrentPose as SetCurrentPose,
    )
    from jauspy.messages.iop.v1_1.render_useless import (
        ConfirmRenderUselessRequest as ConfirmRenderUselessRequest, QueryRenderUseless as QueryRenderUseless,
        RenderUseless as RenderUseless, ReportRenderUseless as ReportRenderUseless,
    )
    from jauspy.messages.iop.v1_1.retrotraverse import (
        CancelRetrotraverse as CancelRetrotraverse, QueryRetrotraverseStatus as QueryRetrotraverseStatus,
        ReportRetrotraverseStatus as ReportRetrotraverseStatus, StartRetrotraverse as StartRetrotraverse,
    )
    from jauspy.messages.iop.v1_1.seismic_sensor import (
        QuerySeismicSensorStatus as QuerySeismicSensorStatus,
        ReportSeismicSensorStatus as ReportSeismicSensorStatus,
    )
    from jauspy.messages.iop.v1_1.self_collision_avoidance_policy_manager import (
        QuerySelfCollisionAvoidanceCapabilities as QuerySelfCollisionAvoidanceCapabilities,
        QuerySelfCollisionAvoidanceConfiguration as QuerySelfCollisionAvoidanceConfiguration,
        QuerySelfCollisionAvoidanceStatus as QuerySelfCollisionAvoidanceStatus,
        ReportSelfCollisionAvoidanceCapabilities as ReportSelfCollisionAvoidanceCapabilities,
        ReportSelfCollisionAvoidanceConfiguration as ReportSelfCollisionAvoidanceConfiguration,
        ReportSelfCollisionAvoidanceStatus as ReportSelfCollisionAvoidanceStatus,
        SetSelfCollisionAvoidancePolicy as SetSelfCollisionAvoidancePolicy,
        SetSelfCollisionAvoidancePolicyResponse as SetSelfCollisionAvoidancePolicyResponse,
    )
    from jauspy.messages.iop.v1_1.software_version_reporting import (
        QuerySoftwareVersion as QuerySoftwareVersion, ReportSoftwareVersion as ReportSoftwareVersion,
    )
    from jauspy.messages.iop.v1_1.stability_control_service import (
        QueryStabilityControlCapabilities as QueryStabilityControlCapabilities,
        QueryStabilityControlStatus as QueryStabilityControlStatus,
        ReportStabilityControlCapabilities as ReportStabilityControlCapabilities,
        ReportStabilityControlStatus as ReportStabilityControlStatus,
        SetStabilityControlStatus as SetStabilityControlStatus,
    )
    from jauspy.messages.iop.v1_1.tamper_detection import (
        QueryTamperDetectionStatus as QueryTamperDetectionStatus,
        ReportTamperDetectionStatus as ReportTamperDetectionStatus,
        SetTamperDetectionState as SetTamperDetectionState,
    )
    from jauspy.messages.iop.v1_1.tire_pressure_service import (
        QueryTirePressureCapabilities as QueryTirePressureCapabilities,
        QueryTirePressureStatus as QueryTirePressureStatus,
        ReportTirePressureCapabilities as ReportTirePressureCapabilities,
        ReportTirePressureStatus as ReportTirePressureStatus, SetTirePressureStatus as SetTirePressureStatus,
    )
    from jauspy.messages.iop.v1_1.wiper_service import (
        QueryWiperCapabilities as QueryWiperCapabilities, QueryWiperStatus as QueryWiperStatus,
        ReportWiperCapabilities as ReportWiperCapabilities, ReportWiperStatus as ReportWiperStatus,
        SetWiperStatus as SetWiperStatus,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.exp.v1_0.types": "AttachmentFrameRecord EncodingQuality EndpointRecord Formats SampleWidths SeverityRec UGVSeverityRec",
    "jauspy.messages.exp.v1_1.component_physical_properties": "QueryMassProperties QueryShape ReportMassProperties ReportShape",
    "jauspy.messages.exp.v1_1.mount_site_properties": "QueryMountSite ReportMountSite",
    "jauspy.messages.exp.v1_1.passthrough_message": "QueryPassthroughMessageProperties ReportPassthroughMessageProperties SetPassthroughMessage",
    "jauspy.messages.exp.v1_4.aeodrs_digital_video": "QueryAimpointParameters QueryDigitalVideoEndpoint ReportAimpointParameters ReportDigitalVideoEndpoint SetDigitalVideoEndpoint",
    "jauspy.messages.exp.v1_4.aeodrs_video_illuminator": "QueryDigitalVideoIlluminator QueryDigitalVideoIlluminatorCapabilities QueryDigitalVideoIlluminatorConfiguration ReportDigitalVideoIlluminator ReportDigitalVideoIlluminatorCapabilities ReportDigitalVideoIlluminatorConfiguration SetDigitalVideoIlluminator SetDigitalVideoIlluminatorConfiguration",
    "jauspy.messages.exp.v1_4.digital_audio_annuciator": "ConfirmAnnunciatorStream ControlAnnunciatorStream QueryAnnunciatorCapabilities QueryAnnunciatorConfiguration QueryAnnunciatorEndpoint ReportAnnunciatorCapabilities ReportAnnunciatorConfiguration ReportAnnunciatorEndpoint SetAnnunciatorConfiguration",
    "jauspy.messages.exp.v1_4.digital_audio_sensor": "ControlDigitalAudioSensorStream QueryDigitalAudioSensorCapabilities QueryDigitalAudioSensorConfiguration QueryDigitalAudioSensorStreamEndpoint ReportDigitalAudioSensorCapabilities ReportDigitalAudioSensorConfiguration ReportDigitalAudioSensorStreamEndpoint SetDigitalAudioSensorConfiguration SetDigitalAudioSensorStreamEndpoint",
    "jauspy.messages.exp.v1_4.health_monitor": "QueryUGVSummary ReportUGVSummary UpdateUGVSummary",
    "jauspy.messages.exp.v1_4.health_reporter": "QueryHealthDetails QueryHealthSummary QueryHourMeter QueryReminder QueryReminderSummary ReportHealthDetails ReportHealthSummary ReportHourMeter ReportReminder ReportReminderSummary ResetReminder UpdateHealthReporter",
    "jauspy.messages.exp.v1_4.subsystem_id_allocator": "GrantSubsystemID QuerySubsystemIDs ReportSubsystemIDs RequestSubsystemID",
    "jauspy.messages.iop.v1_0.data_logging": "QueryLoggerCapability QueryLoggerConfiguration QueryLoggerStatus ReportLoggerCapability ReportLoggerConfiguration ReportLoggerStatus SetLoggerConfiguration SetLoggerConfigurationResponse SetLoggerState",
    "jauspy.messages.iop.v1_0.enhanced_global_waypoint_list_driver": "QueryEnhancedGlobalWaypointInformation QueryGlobalWaypointStatus ReportEnhancedGlobalWaypointInformation ReportGlobalWaypointStatus SetEnhancedGlobalWaypointInformation",
    "jauspy.messages.iop.v1_0.enhanced_local_waypoint_list_driver": "QueryEnhancedLocalWaypointInformation QueryLocalWaypointStatus ReportEnhancedLocalWaypointInformation ReportLocalWaypointStatus SetEnhancedLocalWaypointInformation",
    "jauspy.messages.iop.v1_0.h264_video_encoding": "QueryH264VideoEncodingCapabilities QueryH264VideoEncodingConfiguration ReportH264VideoEncodingCapabilities ReportH264VideoEncodingConfiguration SetH264VideoEncodingConfiguration",
    "jauspy.messages.iop.v1_0.military_illumination_service": "QueryMilitaryIlluminationMode ReportMilitaryIlluminationMode SetMilitaryIlluminationMode",
    "jauspy.messages.iop.v1_0.types": "CostAndConfidenceDataRec CostDataRec CostMap2DGlobalPoseRec CostMap2DLocalPoseRec CostMap2DRec DeviceRec DigitalResourceEndpointRec FilterType GlobalPoseRec GlobalVertexRec JAUS_ID LocalVertexRec ParentID PathReporterCapabilitiesRec QueryCostMap2DRec ReadingRec ReleaseControlRec RunLengthEncodedDataRec TimestampRec ValueRec WaypointInformationRec",
    "jauspy.messages.iop.v1_1.acoustic_sensor": "QueryAcousticSensorStatus ReportAcousticSensorStatus",
    "jauspy.messages.iop.v1_1.cbrn_sensor": "CBDetailedMeasurement CBRN4 CBRNCommand CBRNConfigurationCommand CBRNConfigurationState CBRNDetection CBRNDisplayConfigurationCommand CBRNOperatingState CBRNScanWindowConfigurationCommand CBRNScanWindowOperatingState QueryCBDetailedMeasurement QueryCBRN4 QueryCBRNConfiguration QueryCBRNDetection QueryCBRNOperatingState QueryCBRNScanWindowOperatingState QueryRNDetailedMeasurement RNDetailedMeasurement",
    "jauspy.messages.iop.v1_1.comms_lost_policy_manager": "QueryCommsLostCapabilities QueryCommsLostConfiguration QueryCommsLostStatus ReportCommsLostCapabilities ReportCommsLostConfiguration ReportCommsLostStatus SetCommsLostPolicy SetCommsLostPolicyResponse",
    "jauspy.messages.iop.v1_1.communicator": "QueryCommunicatorCapability QueryCommunicatorConfiguration QueryCommunicatorHealth ReportCommunicatorCapability ReportCommunicatorConfiguration ReportCommunicatorHealth SetCommunicatorConfiguration SetCommunicatorConfigurationResponse",
    "jauspy.messages.iop.v1_1.convoy": "QueryConvoyDetails ReportConvoyDetails UpdateConvoyDetails",
    "jauspy.messages.iop.v1_1.cost_map2d": "AddNoGoZone AddNoGoZoneResponse QueryCostMap2D QueryNoGoZones RemoveNoGoZone ReportCostMap2D ReportNoGoZones",
    "jauspy.messages.iop.v1_1.debris_blower_service": "QueryDebrisBlowerCapabilities QueryDebrisBlowerConfiguration ReportDebrisBlowerCapabilities ReportDebrisBlowerConfiguration SetDebrisBlowerConfiguration",
    "jauspy.messages.iop.v1_1.digital_audio": "QueryDigitalAudioCapabilities QueryDigitalAudioConfiguration ReportDigitalAudioCapabilities ReportDigitalAudioConfiguration SetDigitalAudioConfiguration SetDigitalAudioConfigurationResponse",
    "jauspy.messages.iop.v1_1.digital_audio_annunciator": "QueryDigitalAudioStreamSource ReportDigitalAudioStreamSource SetDigitalAudioStreamSource",
    "jauspy.messages.iop.v1_1.digital_resource_discovery": "ConfirmDigitalResourceEndpoint QueryDigitalResourceEndpoint RegisterDigitalResourceEndpoint RemoveDigitalResourceEndpoint ReportDigitalResourceEndpoint",
    "jauspy.messages.iop.v1_1.enhanced_access_control": "ConfirmHandoffRequest ConfirmReleaseControl QueryEnhancedTimeout QueryHandoffTimeout RemoveHandoffRequest ReportEnhancedTimeout ReportHandoffTimeout RequestHandoff",
    "jauspy.messages.iop.v1_1.extended_primitive_manipulator": "QueryHostManipulator QueryJointOperationalParameters ReportManipulatorHost ReportOperationalParameters",
    "jauspy.messages.iop.v1_1.extended_primitive_pan_tilt": "QueryPanTiltHostManipulator QueryPanTiltOperationalParameters ReportPanTiltManipulatorHost ReportPanTiltOperationalParameters",
    "jauspy.messages.iop.v1_1.filter_mapper": "QueryComponentMappings QueryFilterType ReportComponentMappings ReportFilterType",
    "jauspy.messages.iop.v1_1.force_torque_sensor": "QueryForceTorque QueryForceTorqueCapabilities ReportForceTorque ReportForceTorqueCapabilities",
    "jauspy.messages.iop.v1_1.general_sensor": "QueryGeneralSensorCapabilities QueryGeneralSensorConfiguration ReportGeneralSensorCapabilities ReportGeneralSensorConfiguration SetGeneralSensorConfiguration",
    "jauspy.messages.iop.v1_1.guarded_teleop_policy_manager": "QueryGuardedTeleopCapabilities QueryGuardedTeleopConfiguration QueryGuardedTeleopStatus ReportGuardedTeleopCapabilities ReportGuardedTeleopConfiguration ReportGuardedTeleopStatus SetGuardedTeleopPolicy SetGuardedTeleopPolicyResponse",
    "jauspy.messages.iop.v1_1.handoff_controller": "RequestReleaseControl",
    "jauspy.messages.iop.v1_1.intelligent_vehicle_policy_manager": "QueryIntelligentVehicleCapabilities QueryIntelligentVehicleConfiguration QueryIntelligentVehicleStatus ReportIntelligentVehicleCapabilities ReportIntelligentVehicleConfiguration ReportIntelligentVehicleStatus SetIntelligentVehicleConfiguration",
    "jauspy.messages.iop.v1_1.leader_follower_driver": "QueryFollowerConfiguration ReportFollowerConfiguration SetFollowerConfiguration SetFollowerState",
    "jauspy.messages.iop.v1_1.leader_management": "QueryFollowers RegisterFollower RegisterFollowerResponse ReportFollowers RequestSpeedOverride",
    "jauspy.messages.iop.v1_1.loading_specifications_service": "QueryLoadingSpecifications ReportLoadingSpecifications SetLoadingSpecifications",
    "jauspy.messages.iop.v1_1.magnetic_sensor": "QueryMagneticSensorStatus ReportMagneticSensorStatus",
    "jauspy.messages.iop.v1_1.manipulator_end_effector_force_torque_sensor": "QueryManipulatorEndEffectorForceTorque ReportManipulatorEndEffectorForceTorque",
    "jauspy.messages.iop.v1_1.measurement_sensor": "QueryMeasurement ReportMeasurement",
    "jauspy.messages.iop.v1_1.node_id_allocator": "GrantNodeID RequestNodeID",
    "jauspy.messages.iop.v1_1.path_reporter": "QueryPath QueryPathReporterCapabilities ReportPath ReportPathReporterCapabilities",
    "jauspy.messages.iop.v1_1.physical_specification_service": "QueryElectricalProperties QueryPhysicalProperties ReportElectricalProperties ReportPhysicalProperties",
    "jauspy.messages.iop.v1_1.platform_door_service": "QueryDoorStatus ReportDoorStatus SetDoorLock",
    "jauspy.messages.iop.v1_1.platform_mode": "QueryPlatformMode QuerySupportedPlatformModes ReportPlatformMode ReportSupportedPlatformModes SetPlatformMode",
    "jauspy.messages.iop.v1_1.platform_state": "ClearEmergency ConfirmPlatformStateRequest QueryPlatformState ReportPlatformState SetEmergency SetPlatformState",
    "jauspy.messages.iop.v1_1.preset_pose": "QueryCurrentPose QueryPresetPoseCapabilities QueryPresetPoseSpecifications ReportCurrentPose ReportPresetPoseCapabilities ReportPresetPoseSpecifications ReportTransitionCompleted SetCurrentPose",
    "jauspy.messages.iop.v1_1.render_useless": "ConfirmRenderUselessRequest QueryRenderUseless RenderUseless ReportRenderUseless",
    "jauspy.messages.iop.v1_1.retrotraverse": "CancelRetrotraverse QueryRetrotraverseStatus ReportRetrotraverseStatus StartRetrotraverse",
    "jauspy.messages.iop.v1_1.seismic_sensor": "QuerySeismicSensorStatus ReportSeismicSensorStatus",
    "jauspy.messages.iop.v1_1.self_collision_avoidance_policy_manager": "QuerySelfCollisionAvoidanceCapabilities QuerySelfCollisionAvoidanceConfiguration QuerySelfCollisionAvoidanceStatus ReportSelfCollisionAvoidanceCapabilities ReportSelfCollisionAvoidanceConfiguration ReportSelfCollisionAvoidanceStatus SetSelfCollisionAvoidancePolicy SetSelfCollisionAvoidancePolicyResponse",
    "jauspy.messages.iop.v1_1.software_version_reporting": "QuerySoftwareVersion ReportSoftwareVersion",
    "jauspy.messages.iop.v1_1.stability_control_service": "QueryStabilityControlCapabilities QueryStabilityControlStatus ReportStabilityControlCapabilities ReportStabilityControlStatus SetStabilityControlStatus",
    "jauspy.messages.iop.v1_1.tamper_detection": "QueryTamperDetectionStatus ReportTamperDetectionStatus SetTamperDetectionState",
    "jauspy.messages.iop.v1_1.tire_pressure_service": "QueryTirePressureCapabilities QueryTirePressureStatus ReportTirePressureCapabilities ReportTirePressureStatus SetTirePressureStatus",
    "jauspy.messages.iop.v1_1.wiper_service": "QueryWiperCapabilities QueryWiperStatus ReportWiperCapabilities ReportWiperStatus SetWiperStatus",
})
