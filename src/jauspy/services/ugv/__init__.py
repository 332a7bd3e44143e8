"""Services of unmanned ground vehicles (AS6091) over the contracts of `jauspy.platform`."""

from jauspy.services.ugv.chassis import AckermannDriver, PlatformSpecifications, SkidSteerDriver

__all__ = ["AckermannDriver", "PlatformSpecifications", "SkidSteerDriver"]
