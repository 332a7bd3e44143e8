"""Mobility services (AS6009) over the contracts of `jauspy.platform`."""

from jauspy.services.mobility.local_pose_sensor import LocalPoseSensor
from jauspy.services.mobility.primitive_driver import PrimitiveDriver
from jauspy.services.mobility.velocity_state_sensor import VelocityStateSensor

__all__ = ["LocalPoseSensor", "PrimitiveDriver", "VelocityStateSensor"]
