"""urn:jauspy:older:DigitalVideoCapabilities 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import digital_video as environment_sensing_v1_0_digital_video

_SERVICE = jd.Service("urn:jauspy:older:DigitalVideoCapabilities", "1.0")

@jd.derived(_SERVICE)
class ReportDigitalVideoSensorCapabilities(environment_sensing_v1_0_digital_video.ReportDigitalVideoSensorCapabilities): ...

@jd.derived(_SERVICE)
class QueryDigitalVideoSensorCapabilities(environment_sensing_v1_0_digital_video.QueryDigitalVideoSensorCapabilities):
    REPORT = ReportDigitalVideoSensorCapabilities
