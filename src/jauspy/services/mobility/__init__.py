"""Mobility services (AS6009) over the contracts of `jauspy.platform`."""

from jauspy.services.mobility.driver import PrimitiveDriver
from jauspy.services.mobility.reference_frames import GlobalPose
from jauspy.services.mobility.vector_drivers import GlobalVectorDriver, LocalVectorDriver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.vehicle_sensors import (
    AccelerationStateSensor,
    GlobalPoseSensor,
    LocalPoseSensor,
    VelocityStateSensor,
)
from jauspy.services.mobility.velocity_state_driver import VelocityStateDriver
from jauspy.services.mobility.waypoint_drivers import (
    GlobalWaypointDriver,
    GlobalWaypointListDriver,
    LocalWaypointDriver,
    LocalWaypointListDriver,
)

__all__ = [
    "AccelerationStateSensor",
    "GlobalPose",
    "GlobalPoseSensor",
    "GlobalVectorDriver",
    "GlobalWaypointDriver",
    "GlobalWaypointListDriver",
    "LocalPoseSensor",
    "LocalVectorDriver",
    "LocalWaypointDriver",
    "LocalWaypointListDriver",
    "PrimitiveDriver",
    "Vehicle",
    "VelocityStateDriver",
    "VelocityStateSensor",
]
