"""The queries of DigitalVideo 1.0 and StillImage 1.0 that version 2.0 does not have (AS6060)."""

from __future__ import annotations

from jauspy.messages.environment_sensing.v1_0 import digital_video, still_image
from jauspy.messages.older import (
    QueryDigitalVideoSensorCapabilities,
    QueryStillImageData,
    ReportDigitalVideoSensorCapabilities,
    ReportStillImageData,
)
from jauspy.services.deferred import Deferred
from jauspy.services.environment_sensing.digital_video import capabilities
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.environment_sensing.still_image import Record, StillImage
from jauspy.services.environment_sensing.visual_sensor import Cameras
from jauspy.services.service import Service

_Capabilities = digital_video.ReportDigitalVideoSensorCapabilities.DigitalVideoSensorCapabilitiesRec
_Image = still_image.ReportStillImageData.StillImageDataRec


class DigitalVideoCapabilities(Service, urn="urn:jauspy:older:DigitalVideoCapabilities", private=True):
    """Reports what the streams support to clients of DigitalVideo 1.0."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_digital_video_sensor_capabilities(
        self, query: QueryDigitalVideoSensorCapabilities
    ) -> ReportDigitalVideoSensorCapabilities:
        """Return the sizes, frame rates and bit rates that each camera supports."""
        requested = requested_sensors(
            query.query_digital_video_sensor_capabilities_list, self._cameras, known_only=True
        )
        return ReportDigitalVideoSensorCapabilities([_older_capabilities(sensor) for sensor, _ in requested])


def _older_capabilities(sensor: int) -> _Capabilities:
    newer = capabilities(sensor)
    return _Capabilities(
        sensor,
        minimum_bit_rate=newer.minimum_bit_rate,
        maximum_bit_rate=newer.maximum_bit_rate,
        minimum_frame_rate=newer.minimum_frame_rate,
        maximum_frame_rate=newer.maximum_frame_rate,
        supported_frame_sizes=newer.supported_frame_sizes,
        supported_digital_formats=newer.supported_digital_formats,
    )


class StillImageData(Service, urn="urn:jauspy:older:StillImageData", private=True):
    """Takes images for clients of StillImage 1.0; cameras that fail are left out, as every record has an image."""

    def __init__(self, still_image: StillImage) -> None:
        self._still_image = still_image

    def send_report_still_image_data(self, query: QueryStillImageData) -> Deferred:
        """Take an image with each requested camera, and report them."""
        return self._still_image.take(query.query_still_image_data_list, _older_report)


def _older_report(records: list[Record]) -> ReportStillImageData:
    return ReportStillImageData(
        [
            _Image(
                sensor_id=record.sensor_id,
                report_coordinate_system=record.report_coordinate_system,
                time_stamp=record.time_stamp,
                image_frame=still_image.ReportStillImageData.ImageFrame(
                    record.image_frame.format, record.image_frame.data
                ),
            )
            for record in records
            if record.image_frame is not None
        ]
    )
