"""Messages of mobility, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.mobility.v1_0.acceleration_state_sensor import (
        QueryAccelerationState as QueryAccelerationState, ReportAccelerationState as ReportAccelerationState,
    )
    from jauspy.messages.mobility.v1_0.global_path_segment_driver import (
        ExecuteList as ExecuteList, QueryActiveElement as QueryActiveElement,
        QueryGlobalPathSegment as QueryGlobalPathSegment, QueryTravelSpeed as QueryTravelSpeed,
        ReportActiveElement as ReportActiveElement, ReportGlobalPathSegment as ReportGlobalPathSegment,
        ReportTravelSpeed as ReportTravelSpeed, SetGlobalPathSegment as SetGlobalPathSegment,
    )
    from jauspy.messages.mobility.v1_0.global_pose_sensor import (
        QueryGeomagneticProperty as QueryGeomagneticProperty, QueryGlobalPose as QueryGlobalPose,
        ReportGeomagneticProperty as ReportGeomagneticProperty, ReportGlobalPose as ReportGlobalPose,
        SetGeomagneticProperty as SetGeomagneticProperty, SetGlobalPose as SetGlobalPose,
    )
    from jauspy.messages.mobility.v1_0.global_vector_driver import (
        QueryGlobalVector as QueryGlobalVector, ReportGlobalVector as ReportGlobalVector,
        SetGlobalVector as SetGlobalVector,
    )
    from jauspy.messages.mobility.v1_0.global_waypoint_driver import (
        QueryGlobalWaypoint as QueryGlobalWaypoint, ReportGlobalWaypoint as ReportGlobalWaypoint,
        SetGlobalWaypoint as SetGlobalWaypoint, SetTravelSpeed as SetTravelSpeed,
    )
    from jauspy.messages.mobility.v1_0.list_manager import (
        ConfirmElementRequest as ConfirmElementRequest, DeleteElement as DeleteElement,
        QueryElement as QueryElement, QueryElementCount as QueryElementCount, QueryElementList as QueryElementList,
        RejectElementRequest as RejectElementRequest, ReportElement as ReportElement,
        ReportElementCount as ReportElementCount, ReportElementList as ReportElementList, SetElement as SetElement,
    )
    from jauspy.messages.mobility.v1_0.local_path_segment_driver import (
        QueryLocalPathSegment as QueryLocalPathSegment, ReportLocalPathSegment as ReportLocalPathSegment,
        SetLocalPathSegment as SetLocalPathSegment,
    )
    from jauspy.messages.mobility.v1_0.local_pose_sensor import (
        QueryLocalPose as QueryLocalPose, ReportLocalPose as ReportLocalPose, SetLocalPose as SetLocalPose,
    )
    from jauspy.messages.mobility.v1_0.local_vector_driver import (
        QueryLocalVector as QueryLocalVector, ReportLocalVector as ReportLocalVector,
        SetLocalVector as SetLocalVector,
    )
    from jauspy.messages.mobility.v1_0.local_waypoint_driver import (
        QueryLocalWaypoint as QueryLocalWaypoint, ReportLocalWaypoint as ReportLocalWaypoint,
        SetLocalWaypoint as SetLocalWaypoint,
    )
    from jauspy.messages.mobility.v1_0.primitive_driver import (
        QueryWrenchEffort as QueryWrenchEffort, ReportWrenchEffort as ReportWrenchEffort,
        SetWrenchEffort as SetWrenchEffort,
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
    from jauspy.messages.mobility.v1_0.velocity_state_driver import (
        QueryAccelerationLimit as QueryAccelerationLimit, QueryVelocityCommand as QueryVelocityCommand,
        ReportAccelerationLimit as ReportAccelerationLimit, ReportVelocityCommand as ReportVelocityCommand,
        SetAccelerationLimit as SetAccelerationLimit, SetVelocityCommand as SetVelocityCommand,
    )
    from jauspy.messages.mobility.v1_0.velocity_state_sensor import (
        QueryVelocityState as QueryVelocityState, ReportVelocityState as ReportVelocityState,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.mobility.v1_0.acceleration_state_sensor": "QueryAccelerationState ReportAccelerationState",
    "jauspy.messages.mobility.v1_0.global_path_segment_driver": "ExecuteList QueryActiveElement QueryGlobalPathSegment QueryTravelSpeed ReportActiveElement ReportGlobalPathSegment ReportTravelSpeed SetGlobalPathSegment",
    "jauspy.messages.mobility.v1_0.global_pose_sensor": "QueryGeomagneticProperty QueryGlobalPose ReportGeomagneticProperty ReportGlobalPose SetGeomagneticProperty SetGlobalPose",
    "jauspy.messages.mobility.v1_0.global_vector_driver": "QueryGlobalVector ReportGlobalVector SetGlobalVector",
    "jauspy.messages.mobility.v1_0.global_waypoint_driver": "QueryGlobalWaypoint ReportGlobalWaypoint SetGlobalWaypoint SetTravelSpeed",
    "jauspy.messages.mobility.v1_0.list_manager": "ConfirmElementRequest DeleteElement QueryElement QueryElementCount QueryElementList RejectElementRequest ReportElement ReportElementCount ReportElementList SetElement",
    "jauspy.messages.mobility.v1_0.local_path_segment_driver": "QueryLocalPathSegment ReportLocalPathSegment SetLocalPathSegment",
    "jauspy.messages.mobility.v1_0.local_pose_sensor": "QueryLocalPose ReportLocalPose SetLocalPose",
    "jauspy.messages.mobility.v1_0.local_vector_driver": "QueryLocalVector ReportLocalVector SetLocalVector",
    "jauspy.messages.mobility.v1_0.local_waypoint_driver": "QueryLocalWaypoint ReportLocalWaypoint SetLocalWaypoint",
    "jauspy.messages.mobility.v1_0.primitive_driver": "QueryWrenchEffort ReportWrenchEffort SetWrenchEffort",
    "jauspy.messages.mobility.v1_0.types": "ExcursionRec GlobalPoseRec GlobalWaypointRec GlobalZPosition LocalPoseRec PolygonRec RaceTrackRec ReportAccelerationStateExtRec ReportGlobalPoseExtRec ReportLocalPoseExtRec ReportVelocityStateExtRec Speed VelocityLocalXYZRec VelocityNEDRec VelocityVehicleXYZRec ZPosition ZoneIDRec",
    "jauspy.messages.mobility.v1_0.velocity_state_driver": "QueryAccelerationLimit QueryVelocityCommand ReportAccelerationLimit ReportVelocityCommand SetAccelerationLimit SetVelocityCommand",
    "jauspy.messages.mobility.v1_0.velocity_state_sensor": "QueryVelocityState ReportVelocityState",
})
