"""Services of unmanned ground vehicles (AS6091) over the contracts of `jauspy.platform`."""

from jauspy.services.ugv.platform_specifications import PlatformSpecifications
from jauspy.services.ugv.skid_steer_driver import SkidSteerDriver

__all__ = ["PlatformSpecifications", "SkidSteerDriver"]
