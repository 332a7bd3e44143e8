"""Messages of older, v1_0; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.older.v1_0.digital_video_capabilities import (
        QueryDigitalVideoSensorCapabilities as QueryDigitalVideoSensorCapabilities,
        ReportDigitalVideoSensorCapabilities as ReportDigitalVideoSensorCapabilities,
    )
    from jauspy.messages.older.v1_0.still_image_data import (
        QueryStillImageData as QueryStillImageData, ReportStillImageData as ReportStillImageData,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.older.v1_0.digital_video_capabilities": "QueryDigitalVideoSensorCapabilities ReportDigitalVideoSensorCapabilities",
    "jauspy.messages.older.v1_0.still_image_data": "QueryStillImageData ReportStillImageData",
})
