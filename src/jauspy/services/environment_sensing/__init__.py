"""Services of the environment sensing set (AS6060)."""

from jauspy.services.environment_sensing.digital_resource_discovery import (
    DigitalResourceDiscovery,
    MediaStreams,
    VideoStreams,
)
from jauspy.services.environment_sensing.digital_video import DigitalVideo
from jauspy.services.environment_sensing.force_torque_sensor import ForceTorqueSensorService, MountedForceTorqueSensor
from jauspy.services.environment_sensing.h264_video_encoding import H264VideoEncoding
from jauspy.services.environment_sensing.older_versions import DigitalVideoCapabilities, StillImageData
from jauspy.services.environment_sensing.range_sensor import RangeSensor
from jauspy.services.environment_sensing.sensors import JointMount, MountedLidar
from jauspy.services.environment_sensing.still_image import StillImage
from jauspy.services.environment_sensing.visual_sensor import VideoCamera, VideoSource, VisualSensor

__all__ = [
    "DigitalResourceDiscovery",
    "DigitalVideo",
    "DigitalVideoCapabilities",
    "ForceTorqueSensorService",
    "H264VideoEncoding",
    "JointMount",
    "MediaStreams",
    "MountedForceTorqueSensor",
    "MountedLidar",
    "RangeSensor",
    "StillImage",
    "StillImageData",
    "VideoCamera",
    "VideoSource",
    "VideoStreams",
    "VisualSensor",
]
