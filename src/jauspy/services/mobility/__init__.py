"""Mobility services (AS6009) over the contracts of `jauspy.platform`."""

from jauspy.services.mobility.acceleration_state_sensor import AccelerationStateSensor
from jauspy.services.mobility.global_waypoint_driver import GlobalWaypointDriver
from jauspy.services.mobility.global_waypoint_list_driver import GlobalWaypointListDriver
from jauspy.services.mobility.local_waypoint_driver import LocalWaypointDriver
from jauspy.services.mobility.local_waypoint_list_driver import LocalWaypointListDriver
from jauspy.services.mobility.pose_sensors import GlobalPoseSensor, LocalPoseSensor
from jauspy.services.mobility.primitive_driver import PrimitiveDriver
from jauspy.services.mobility.reference_frames import GlobalPose
from jauspy.services.mobility.vector_drivers import GlobalVectorDriver, LocalVectorDriver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.velocity_state_driver import VelocityStateDriver
from jauspy.services.mobility.velocity_state_sensor import VelocityStateSensor

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
