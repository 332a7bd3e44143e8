"""Messages of mobility, newest versions; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.mobility.v1_0.global_path_segment_driver import (
        SetGlobalPathSegment as SetGlobalPathSegment,
    )
    from jauspy.messages.mobility.v1_0.list_manager import (
        ConfirmElementRequest as ConfirmElementRequest, DeleteElement as DeleteElement,
        QueryElement as QueryElement, QueryElementCount as QueryElementCount, QueryElementList as QueryElementList,
        RejectElementRequest as RejectElementRequest, ReportElement as ReportElement,
        ReportElementCount as ReportElementCount, ReportElementList as ReportElementList, SetElement as SetElement,
    )
    from jauspy.messages.mobility.v1_0.local_path_segment_driver import (
        SetLocalPathSegment as SetLocalPathSegment,
    )
    from jauspy.messages.mobility.v1_0.types import (
        ExcursionRec as ExcursionRec, GlobalPoseRec as GlobalPoseRec, GlobalWaypointRec as GlobalWaypointRec,
        GlobalZPosition as GlobalZPosition, LocalPoseRec as LocalPoseRec, PolygonRec as PolygonRec,
        RaceTrackRec as RaceTrackRec, ReportAccelerationStateExtRec as ReportAccelerationStateExtRec,
        ReportGlobalPoseExtRec as ReportGlobalPoseExtRec, ReportLocalPoseExtRec as ReportLocalPoseExtRec,
        ReportVelocityStateExtRec as ReportVelocityStateExtRec, Speed as Speed,
        VelocityLocalXYZRec as VelocityLocalXYZRec, VelocityNEDRec as VelocityNEDRec,
        VelocityVehicleXYZRec as VelocityVehicleXYZRec, ZPosition as ZPosition, ZoneIDRec as ZoneIDRec,
    )
    from jauspy.messages.mobility.v1_1.acceleration_state_sensor import (
        QueryAccelerationState as QueryAccelerationState, QueryAccelerationStateExt as QueryAccelerationStateExt,
        ReportAccelerationState as ReportAccelerationState,
        ReportAccelerationStateExt as ReportAccelerationStateExt,
    )
    from jauspy.messages.mobility.v1_1.global_loiter_driver import (
        QueryGlobalLoiter as QueryGlobalLoiter, QueryTravelSpeedExt as QueryTravelSpeedExt,
        ReportGlobalLoiter as ReportGlobalLoiter, ReportTravelSpeedExt as ReportTravelSpeedExt,
        SetGlobalLoiter as SetGlobalLoiter, SetTravelSpeedExt as SetTravelSpeedExt,
    )
    from jauspy.messages.mobility.v1_1.global_operating_zone import (
        DeleteZone as DeleteZone, QueryExcursion as QueryExcursion,
        QueryGlobalOperatingZone as QueryGlobalOperatingZone, ReportExcursion as ReportExcursion,
        ReportGlobalOperatingZone as ReportGlobalOperatingZone, SetGlobalOperatingZone as SetGlobalOperatingZone,
    )
    from jauspy.messages.mobility.v1_1.global_path_segment_driver import (
        ExecuteList as ExecuteList, ExecuteListExt as ExecuteListExt, QueryActiveElement as QueryActiveElement,
        QueryGlobalPathSegment as QueryGlobalPathSegment, QueryGlobalPathSegmentExt as QueryGlobalPathSegmentExt,
        QueryTravelSpeed as QueryTravelSpeed, ReportActiveElement as ReportActiveElement,
        ReportGlobalPathSegment as ReportGlobalPathSegment,
        ReportGlobalPathSegmentExt as ReportGlobalPathSegmentExt, ReportTravelSpeed as ReportTravelSpeed,
    )
    from jauspy.messages.mobility.v1_1.global_pose_sensor import (
        QueryGeomagneticProperty as QueryGeomagneticProperty, QueryGlobalPose as QueryGlobalPose,
        QueryGlobalPoseExt as QueryGlobalPoseExt, ReportGeomagneticProperty as ReportGeomagneticProperty,
        ReportGlobalPose as ReportGlobalPose, ReportGlobalPoseExt as ReportGlobalPoseExt,
        SetGeomagneticProperty as SetGeomagneticProperty, SetGlobalPose as SetGlobalPose,
        SetGlobalPoseExt as SetGlobalPoseExt,
    )
    from jauspy.messages.mobility.v1_1.global_vector_driver import (
        QueryGlobalVector as QueryGlobalVector, QueryGlobalVectorExt as QueryGlobalVectorExt,
        ReportGlobalVector as ReportGlobalVector, ReportGlobalVectorExt as ReportGlobalVectorExt,
        SetGlobalVector as SetGlobalVector, SetGlobalVectorExt as SetGlobalVectorExt,
    )
    from jauspy.messages.mobility.v1_1.global_waypoint_driver import (
        QueryGlobalWaypoint as QueryGlobalWaypoint, QueryGlobalWaypointExt as QueryGlobalWaypointExt,
        ReportGlobalWaypoint as ReportGlobalWaypoint, ReportGlobalWaypointExt as ReportGlobalWaypointExt,
        SetGlobalWaypoint as SetGlobalWaypoint, SetGlobalWaypointExt as SetGlobalWaypointExt,
        SetTravelSpeed as SetTravelSpeed,
    )
    from jauspy.messages.mobility.v1_1.gps_fix import (
        QueryGPSFix as QueryGPSFix, ReportGPSFix as ReportGPSFix, RequestGPSFix as RequestGPSFix,
    )
    from jauspy.messages.mobility.v1_1.inertial_sensor_control import (
        InertialSensorControl as InertialSensorControl, QueryInertialSensorStatus as QueryInertialSensorStatus,
        ReportInertialSensorStatus as ReportInertialSensorStatus,
    )
    from jauspy.messages.mobility.v1_1.local_loiter_driver import (
        QueryLocalLoiter as QueryLocalLoiter, ReportLocalLoiter as ReportLocalLoiter,
        SetLocalLoiter as SetLocalLoiter,
    )
    from jauspy.messages.mobility.v1_1.local_operating_zone import (
        QueryLocalOperatingZone as QueryLocalOperatingZone, ReportLocalOperatingZone as ReportLocalOperatingZone,
        SetLocalOperatingZone as SetLocalOperatingZone,
    )
    from jauspy.messages.mobility.v1_1.local_path_segment_driver import (
        QueryLocalPathSegment as QueryLocalPathSegment, QueryLocalPathSegmentExt as QueryLocalPathSegmentExt,
        ReportLocalPathSegment as ReportLocalPathSegment, ReportLocalPathSegmentExt as ReportLocalPathSegmentExt,
    )
    from jauspy.messages.mobility.v1_1.local_pose_sensor import (
        QueryLocalPose as QueryLocalPose, QueryLocalPoseExt as QueryLocalPoseExt,
        ReportLocalPose as ReportLocalPose, ReportLocalPoseExt as ReportLocalPoseExt, SetLocalPose as SetLocalPose,
        SetLocalPoseExt as SetLocalPoseExt,
    )
    from jauspy.messages.mobility.v1_1.local_vector_driver import (
        QueryLocalVector as QueryLocalVector, QueryLocalVectorExt as QueryLocalVectorExt,
        ReportLocalVector as ReportLocalVector, ReportLocalVectorExt as ReportLocalVectorExt,
        SetLocalVector as SetLocalVector, SetLocalVectorExt as SetLocalVectorExt,
    )
    from jauspy.messages.mobility.v1_1.local_waypoint_driver import (
        QueryLocalWaypoint as QueryLocalWaypoint, QueryLocalWaypointExt as QueryLocalWaypointExt,
        ReportLocalWaypoint as ReportLocalWaypoint, ReportLocalWaypointExt as ReportLocalWaypointExt,
        SetLocalWaypoint as SetLocalWaypoint, SetLocalWaypointExt as SetLocalWaypointExt,
    )
    from jauspy.messages.mobility.v1_1.navigation_state import (
        QueryNavigation as QueryNavigation, ReportNavigation as ReportNavigation,
    )
    from jauspy.messages.mobility.v1_1.primitive_driver import (
        QueryWrenchEffort as QueryWrenchEffort, ReportWrenchEffort as ReportWrenchEffort,
        SetWrenchEffort as SetWrenchEffort,
    )
    from jauspy.messages.mobility.v1_1.velocity_state_driver import (
        QueryAccelerationLimit as QueryAccelerationLimit, QueryVelocityCommand as QueryVelocityCommand,
        QueryVelocityCommandExt as QueryVelocityCommandExt, ReportAccelerationLimit as ReportAccelerationLimit,
        ReportVelocityCommand as ReportVelocityCommand, ReportVelocityCommandExt as ReportVelocityCommandExt,
        SetAccelerationLimit as SetAccelerationLimit, SetVelocityCommand as SetVelocityCommand,
        SetVelocityCommandExt as SetVelocityCommandExt,
    )
    from jauspy.messages.mobility.v1_1.velocity_state_sensor import (
        QueryVelocityState as QueryVelocityState, QueryVelocityStateExt as QueryVelocityStateExt,
        ReportVelocityState as ReportVelocityState, ReportVelocityStateExt as ReportVelocityStateExt,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.mobility.v1_0.global_path_segment_driver": "SetGlobalPathSegment",
    "jauspy.messages.mobility.v1_0.list_manager": "ConfirmElementRequest DeleteElement QueryElement QueryElementCount QueryElementList RejectElementRequest ReportElement ReportElementCount ReportElementList SetElement",
    "jauspy.messages.mobility.v1_0.local_path_segment_driver": "SetLocalPathSegment",
    "jauspy.messages.mobility.v1_0.types": "ExcursionRec GlobalPoseRec GlobalWaypointRec GlobalZPosition LocalPoseRec PolygonRec RaceTrackRec ReportAccelerationStateExtRec ReportGlobalPoseExtRec ReportLocalPoseExtRec ReportVelocityStateExtRec Speed VelocityLocalXYZRec VelocityNEDRec VelocityVehicleXYZRec ZPosition ZoneIDRec",
    "jauspy.messages.mobility.v1_1.acceleration_state_sensor": "QueryAccelerationState QueryAccelerationStateExt ReportAccelerationState ReportAccelerationStateExt",
    "jauspy.messages.mobility.v1_1.global_loiter_driver": "QueryGlobalLoiter QueryTravelSpeedExt ReportGlobalLoiter ReportTravelSpeedExt SetGlobalLoiter SetTravelSpeedExt",
    "jauspy.messages.mobility.v1_1.global_operating_zone": "DeleteZone QueryExcursion QueryGlobalOperatingZone ReportExcursion ReportGlobalOperatingZone SetGlobalOperatingZone",
    "jauspy.messages.mobility.v1_1.global_path_segment_driver": "ExecuteList ExecuteListExt QueryActiveElement QueryGlobalPathSegment QueryGlobalPathSegmentExt QueryTravelSpeed ReportActiveElement ReportGlobalPathSegment ReportGlobalPathSegmentExt ReportTravelSpeed",
    "jauspy.messages.mobility.v1_1.global_pose_sensor": "QueryGeomagneticProperty QueryGlobalPose QueryGlobalPoseExt ReportGeomagneticProperty ReportGlobalPose ReportGlobalPoseExt SetGeomagneticProperty SetGlobalPose SetGlobalPoseExt",
    "jauspy.messages.mobility.v1_1.global_vector_driver": "QueryGlobalVector QueryGlobalVectorExt ReportGlobalVector ReportGlobalVectorExt SetGlobalVector SetGlobalVectorExt",
    "jauspy.messages.mobility.v1_1.global_waypoint_driver": "QueryGlobalWaypoint QueryGlobalWaypointExt ReportGlobalWaypoint ReportGlobalWaypointExt SetGlobalWaypoint SetGlobalWaypointExt SetTravelSpeed",
    "jauspy.messages.mobility.v1_1.gps_fix": "QueryGPSFix ReportGPSFix RequestGPSFix",
    "jauspy.messages.mobility.v1_1.inertial_sensor_control": "InertialSensorControl QueryInertialSensorStatus ReportInertialSensorStatus",
    "jauspy.messages.mobility.v1_1.local_loiter_driver": "QueryLocalLoiter ReportLocalLoiter SetLocalLoiter",
    "jauspy.messages.mobility.v1_1.local_operating_zone": "QueryLocalOperatingZone ReportLocalOperatingZone SetLocalOperatingZone",
    "jauspy.messages.mobility.v1_1.local_path_segment_driver": "QueryLocalPathSegment QueryLocalPathSegmentExt ReportLocalPathSegment ReportLocalPathSegmentExt",
    "jauspy.messages.mobility.v1_1.local_pose_sensor": "QueryLocalPose QueryLocalPoseExt ReportLocalPose ReportLocalPoseExt SetLocalPose SetLocalPoseExt",
    "jauspy.messages.mobility.v1_1.local_vector_driver": "QueryLocalVector QueryLocalVectorExt ReportLocalVector ReportLocalVectorExt SetLocalVector SetLocalVectorExt",
    "jauspy.messages.mobility.v1_1.local_waypoint_driver": "QueryLocalWaypoint QueryLocalWaypointExt ReportLocalWaypoint ReportLocalWaypointExt SetLocalWaypoint SetLocalWaypointExt",
    "jauspy.messages.mobility.v1_1.navigation_state": "QueryNavigation ReportNavigation",
    "jauspy.messages.mobility.v1_1.primitive_driver": "QueryWrenchEffort ReportWrenchEffort SetWrenchEffort",
    "jauspy.messages.mobility.v1_1.velocity_state_driver": "QueryAccelerationLimit QueryVelocityCommand QueryVelocityCommandExt ReportAccelerationLimit ReportVelocityCommand ReportVelocityCommandExt SetAccelerationLimit SetVelocityCommand SetVelocityCommandExt",
    "jauspy.messages.mobility.v1_1.velocity_state_sensor": "QueryVelocityState QueryVelocityStateExt ReportVelocityState ReportVelocityStateExt",
})
