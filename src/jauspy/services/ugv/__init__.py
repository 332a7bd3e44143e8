"""Services of unmanned ground vehicles (AS6091) over the contracts of `jauspy.platform`."""

from jauspy.services.ugv.chassis import AckermannDriver, PlatformSpecifications, SkidSteerDriver
from jauspy.services.ugv.illumination import IlluminationService
from jauspy.services.ugv.power_plant import PowerPlantManager

__all__ = ["AckermannDriver", "IlluminationService", "PlatformSpecifications", "PowerPlantManager", "SkidSteerDriver"]
