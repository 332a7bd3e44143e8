"""Messages of ugv, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.ugv.v1_0.ackermann_driver import (
        QueryAckermannConfiguration as QueryAckermannConfiguration,
        ReportAckermannConfiguration as ReportAckermannConfiguration,
        SetAckermannConfiguration as SetAckermannConfiguration,
    )
    from jauspy.messages.ugv.v1_0.annunciator_service import (
        QueryAnnunciatorConfiguration as QueryAnnunciatorConfiguration,
        QueryAnnunciatorState as QueryAnnunciatorState,
        ReportAnnunciatorConfiguration as ReportAnnunciatorConfiguration,
        ReportAnnunciatorState as ReportAnnunciatorState, SetAnnunciatorState as SetAnnunciatorState,
    )
    from jauspy.messages.ugv.v1_0.drive_train_driver import (
        QueryTransferCaseState as QueryTransferCaseState,
        QueryTransmissionCapabilities as QueryTransmissionCapabilities,
        QueryTransmissionState as QueryTransmissionState, ReportTransferCaseState as ReportTransferCaseState,
        ReportTransmissionCapabilities as ReportTransmissionCapabilities,
        ReportTransmissionState as ReportTransmissionState, SetTransferCaseState as SetTransferCaseState,
        SetTransmissionState as SetTransmissionState,
    )
    from jauspy.messages.ugv.v1_0.illumination_service import (
        QueryIlluminationConfiguration as QueryIlluminationConfiguration,
        QueryIlluminationState as QueryIlluminationState,
        ReportIlluminationConfiguration as ReportIlluminationConfiguration,
        ReportIlluminationState as ReportIlluminationState, SetIlluminationState as SetIlluminationState,
    )
    from jauspy.messages.ugv.v1_0.odometry_service import (
        QueryOdometry as QueryOdometry, ReportOdometry as ReportOdometry, ResetOdometry as ResetOdometry,
    )
    from jauspy.messages.ugv.v1_0.parking_brake_driver import (
        QueryParkingBrake as QueryParkingBrake, ReportParkingBrake as ReportParkingBrake,
        SetParkingBrake as SetParkingBrake,
    )
    from jauspy.messages.ugv.v1_0.platform_specifications_service import (
        QueryPlatformSpecifications as QueryPlatformSpecifications,
        ReportPlatformSpecifications as ReportPlatformSpecifications,
    )
    from jauspy.messages.ugv.v1_0.power_plant_manager import (
        QueryPowerPlantCapabilities as QueryPowerPlantCapabilities,
        QueryPowerPlantConfiguration as QueryPowerPlantConfiguration,
        QueryPowerPlantStatus as QueryPowerPlantStatus,
        ReportPowerPlantCapabilities as ReportPowerPlantCapabilities,
        ReportPowerPlantConfiguration as ReportPowerPlantConfiguration,
        ReportPowerPlantStatus as ReportPowerPlantStatus, SetPowerPlantConfiguration as SetPowerPlantConfiguration,
    )
    from jauspy.messages.ugv.v1_0.skid_steer_driver import (
        QuerySkidSteerEffort as QuerySkidSteerEffort, ReportSkidSteerEffort as ReportSkidSteerEffort,
        SetSkidSteerEffort as SetSkidSteerEffort,
    )
    from jauspy.messages.ugv.v1_0.stabilizer_driver import (
        QueryStabilizerCapabilities as QueryStabilizerCapabilities, QueryStabilizerEffort as QueryStabilizerEffort,
        QueryStabilizerPosition as QueryStabilizerPosition,
        ReportStabilizerCapabilities as ReportStabilizerCapabilities,
        ReportStabilizerEffort as ReportStabilizerEffort, ReportStabilizerPosition as ReportStabilizerPosition,
        SetStabilizerEffort as SetStabilizerEffort, SetStabilizerPosition as SetStabilizerPosition,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.ugv.v1_0.ackermann_driver": "QueryAckermannConfiguration ReportAckermannConfiguration SetAckermannConfiguration",
    "jauspy.messages.ugv.v1_0.annunciator_service": "QueryAnnunciatorConfiguration QueryAnnunciatorState ReportAnnunciatorConfiguration ReportAnnunciatorState SetAnnunciatorState",
    "jauspy.messages.ugv.v1_0.drive_train_driver": "QueryTransferCaseState QueryTransmissionCapabilities QueryTransmissionState ReportTransferCaseState ReportTransmissionCapabilities ReportTransmissionState SetTransferCaseState SetTransmissionState",
    "jauspy.messages.ugv.v1_0.illumination_service": "QueryIlluminationConfiguration QueryIlluminationState ReportIlluminationConfiguration ReportIlluminationState SetIlluminationState",
    "jauspy.messages.ugv.v1_0.odometry_service": "QueryOdometry ReportOdometry ResetOdometry",
    "jauspy.messages.ugv.v1_0.parking_brake_driver": "QueryParkingBrake ReportParkingBrake SetParkingBrake",
    "jauspy.messages.ugv.v1_0.platform_specifications_service": "QueryPlatformSpecifications ReportPlatformSpecifications",
    "jauspy.messages.ugv.v1_0.power_plant_manager": "QueryPowerPlantCapabilities QueryPowerPlantConfiguration QueryPowerPlantStatus ReportPowerPlantCapabilities ReportPowerPlantConfiguration ReportPowerPlantStatus SetPowerPlantConfiguration",
    "jauspy.messages.ugv.v1_0.skid_steer_driver": "QuerySkidSteerEffort ReportSkidSteerEffort SetSkidSteerEffort",
    "jauspy.messages.ugv.v1_0.stabilizer_driver": "QueryStabilizerCapabilities QueryStabilizerEffort QueryStabilizerPosition ReportStabilizerCapabilities ReportStabilizerEffort ReportStabilizerPosition SetStabilizerEffort SetStabilizerPosition",
})
