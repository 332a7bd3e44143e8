"""Services of the environment sensing set (AS6060)."""

from jauspy.services.environment_sensing.mounting import Mounted
from jauspy.services.environment_sensing.range_sensor import RangeSensor

__all__ = ["Mounted", "RangeSensor"]
