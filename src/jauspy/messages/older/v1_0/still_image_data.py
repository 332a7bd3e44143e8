"""urn:jauspy:older:StillImageData 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import still_image as environment_sensing_v1_0_still_image

_SERVICE = jd.Service("urn:jauspy:older:StillImageData", "1.0")

@jd.derived(_SERVICE)
class ReportStillImageData(environment_sensing_v1_0_still_image.ReportStillImageData): ...

@jd.derived(_SERVICE)
class QueryStillImageData(environment_sensing_v1_0_still_image.QueryStillImageData):
    REPORT = ReportStillImageData
