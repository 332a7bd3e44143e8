"""StillImage: images on query and as events, and their size and format (AS6060)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from datetime import timedelta
from functools import partial
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import (
    SensorIdRec,
    StillImageSensorErrorRec,
    SupportedImageFormats,
)
from jauspy.messages.environment_sensing.v2_0.still_image import (
    QueryStillImageDataExt,
    QueryStillImageSensorCapabilities,
    QueryStillImageSensorConfiguration,
    ReportStillImageDataExt,
    ReportStillImageSensorCapabilities,
    ReportStillImageSensorConfiguration,
    SetStillImageSensorConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.platform.video_settings import (
    SUPPORTED_FRAME_SIZES,
    Still,
    StillFormat,
    StillSettings,
    frame_size,
    supported_frame_sizes,
)
from jauspy.services.deferred import Deferred
from jauspy.services.environment_sensing.sensors import SensorRecord, requested_sensors
from jauspy.services.environment_sensing.visual_sensor import Cameras
from jauspy.services.service import Service
from jauspy.services.units import time_stamp

Record: TypeAlias = ReportStillImageDataExt.StillImageDataRec

_Capabilities = ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec

_Configuration = ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec

_RequestedSettings = SetStillImageSensorConfiguration.StillImageSensorConfigurationRec

_Code = StillImageSensorErrorRec.StillImageErrorCode

_Number = ReportStillImageDataExt.ImageFrameFormat

OnImage: TypeAlias = Callable[[Still | None], None]

NATIVE: Final = ReportStillImageDataExt.ReportCoordinateSystem.NATIVE

FORMATS: Final = {_Number.JPEG: StillFormat.JPEG, _Number.PNG: StillFormat.PNG}
"""Formats by JAUS's numbers."""

FORMAT_NUMBERS: Final = {format: number for number, format in FORMATS.items()}


class StillImage(Service, urn="urn:jaus:jss:environmentSensing:StillImage"):
    """Takes images on query, as JPEG or PNG; by default JPEG of the stream's initial size.

    A camera that fails is reported without an image. Coordinates are not transformed.
    """

    omits = frozenset({"send_report_still_image_data_ext_in_requested_coordinate_system"})

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras
        streams = {sensor: camera.source.settings for sensor, camera in cameras.items()}
        self._settings = {
            sensor: StillSettings(stream.width, stream.height, StillFormat.JPEG) for sensor, stream in streams.items()
        }
        self._reply: Deferred | None = None

    def attached(self) -> None:
        """Failed images are counted by the component."""
        self._image_requests = ImageRequests(self._cameras, self.host.count)

    def is_coordinate_transform_supported(self) -> bool:
        """Return False: images are not transformed."""
        return False

    def capture_still_image(self, msg: QueryStillImageDataExt) -> None:
        """Take an image with each requested camera."""
        self._reply = self.take(msg.query_still_image_data_list, ReportStillImageDataExt)

    def take(self, records: Sequence[SensorRecord], make_report: Callable[[list[Record]], Message]) -> Deferred:
        """Take an image with each camera that the records name; the reply is what `make_report` makes of them."""
        requested = requested_sensors(records, self._cameras, known_only=True)
        pending = PendingReport([sensor for sensor, _ in requested], self.host.defer, make_report)
        for sensor, _ in requested:
            settings = self._settings[sensor]
            make_record = partial(self._image_record, sensor, settings.format)
            self._image_requests.take(sensor, settings, partial(pending.add, sensor, make_record))
        return pending.reply

    def send_report_still_image_data_ext_in_native_coordinate_system(self) -> Deferred | None:
        """Return the deferred reply to the query that was just received."""
        reply, self._reply = self._reply, None
        return reply

    def _image_record(self, sensor: int, format: StillFormat, still: Still) -> Record:
        taken_at = time_stamp(self.host.utc_time - timedelta(seconds=still.age))
        image = ReportStillImageDataExt.ImageFrame(FORMAT_NUMBERS[format], still.content)
        return Record(sensor, NATIVE, taken_at, image)

    def send_report_still_image_sensor_capabilities(
        self, query: QueryStillImageSensorCapabilities
    ) -> ReportStillImageSensorCapabilities:
        """Return the sizes and formats that each camera supports."""
        requested = requested_sensors(query.query_still_image_sensor_capabilities_list, self._cameras, known_only=True)
        formats = SupportedImageFormats(*(int(number in FORMATS) for number in _Number))
        return ReportStillImageSensorCapabilities(
            [_Capabilities(sensor, supported_frame_sizes(), formats) for sensor, _ in requested]
        )

    def send_report_still_image_sensor_configuration(
        self, query: QueryStillImageSensorConfiguration
    ) -> ReportStillImageSensorConfiguration:
        """Return the size and format of each camera's images."""
        requested = requested_sensors(query.query_still_image_sensor_configuration_list, self._cameras, known_only=True)
        return ReportStillImageSensorConfiguration([self._configuration(sensor) for sensor, _ in requested])

    def _configuration(self, sensor: int) -> _Configuration:
        settings = self._settings[sensor]
        return _Configuration(sensor, frame_size(settings.width, settings.height), FORMAT_NUMBERS[settings.format])

    def send_confirm_sensor_configuration(self, msg: SetStillImageSensorConfiguration) -> ConfirmSensorConfiguration:
        """Return for each camera its sensor id, or an error record with the reason."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = requested_sensors(msg.still_image_sensor_list, self._cameras)
        return ConfirmSensorConfiguration(
            request, [self._refusal(*request) or SensorIdRec(request[0]) for request in requested]
        )

    def update_still_image_sensor_configuration(self, msg: SetStillImageSensorConfiguration) -> None:
        """Apply valid settings to later images; omitted settings keep their values."""
        for sensor, record in requested_sensors(msg.still_image_sensor_list, self._cameras, known_only=True):
            if self._refusal(sensor, record) is None:
                self._settings[sensor] = _apply_settings(self._settings[sensor], record)

    def _refusal(self, sensor: int, requested: _RequestedSettings) -> StillImageSensorErrorRec | None:
        if sensor not in self._cameras:
            return StillImageSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        problems = []
        if requested.frame_size is not None and requested.frame_size not in SUPPORTED_FRAME_SIZES:
            problems.append((_Code.INVALID_FRAME_SIZE, "the camera does not have this size"))
        if requested.still_image_format is not None and requested.still_image_format not in FORMATS:
            problems.append((_Code.INVALID_FORMAT, "the camera writes JPEG and PNG only"))
        if not problems:
            return None
        code = problems[0][0] if len(problems) == 1 else _Code.MULTIPLE_INVALID_PARAMETERS
        return StillImageSensorErrorRec(sensor, code, "; ".join(text for _, text in problems))


def _apply_settings(present: StillSettings, requested: _RequestedSettings) -> StillSettings:
    if requested.frame_size is not None:
        width, height = SUPPORTED_FRAME_SIZES[requested.frame_size]  # type: ignore[index]  # an IntEnum is as good as its number
        present = replace(present, width=width, height=height)
    if requested.still_image_format is not None:
        present = replace(present, format=FORMATS[requested.still_image_format])  # type: ignore[index]
    return present


class ImageRequests:
    """Takes images with cameras; equal requests share one image.

    Failures are counted as `still_refused` and `still_lost`.
    """

    def __init__(self, cameras: Cameras, count: Callable[[str, str], None]) -> None:
        self._cameras, self._count = cameras, count
        self._waiting: dict[tuple[int, StillSettings], list[OnImage]] = {}

    def take(self, sensor: int, settings: StillSettings, on_image: OnImage) -> None:
        """Call `on_image` with the image, or with None on failure, now or later."""
        under_way = self._waiting.get((sensor, settings))
        if under_way is not None:
            under_way.append(on_image)
            return
        self._waiting[sensor, settings] = [on_image]
        try:
            self._cameras[sensor].source.take(settings, partial(self._taken, sensor, settings))
        except ConfigError as error:
            self._count("still_refused", f"sensor {sensor}: {error}")
            self._deliver(sensor, settings, None)

    def _taken(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        if still is None:
            self._count("still_lost", f"sensor {sensor}: its process ended before the picture was taken")
        self._deliver(sensor, settings, still)

    def _deliver(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        for on_image in self._waiting.pop((sensor, settings), []):
            on_image(still)


class PendingReport:
    """A report whose deferred `reply` is completed when every camera has delivered its image or failed.

    Cameras that failed are reported without an image.
    """

    def __init__(
        self,
        sensors: Iterable[int],
        defer: Callable[[Callable[[], Message]], Deferred],
        make_report: Callable[[list[Record]], Message],
    ) -> None:
        self._make_report = make_report
        self._records = {sensor: Record(sensor, NATIVE) for sensor in sensors}
        self._missing = set(self._records)
        self.reply = defer(self.report)
        self._reply_if_complete()

    def report(self) -> Message:
        """Return the report with the images delivered so far."""
        return self._make_report(list(self._records.values()))

    def add(self, sensor: int, make_record: Callable[[Still], Record], still: Still | None) -> None:
        """Add the image of a camera; None if the camera failed."""
        if still is not None:
            self._records[sensor] = make_record(still)
        self._missing.discard(sensor)
        self._reply_if_complete()

    def _reply_if_complete(self) -> None:
        if not self._missing:
            self.reply.set_result(self.report())
