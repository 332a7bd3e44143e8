"""StillImage: pictures on query and as events, and their size and format (AS6060)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from datetime import timedelta
from functools import partial
from typing import Final, TypeAlias

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
from jauspy.platform.video_settings import Still, StillFormat, StillSettings
from jauspy.services.deferred import Deferred
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.environment_sensing.visual_sensor import (
    SUPPORTED_FRAME_SIZES,
    Cameras,
    frame_size,
    supported_frame_sizes,
)
from jauspy.services.service import Service
from jauspy.services.units import time_stamp

Record: TypeAlias = ReportStillImageDataExt.StillImageDataRec

NATIVE: Final = ReportStillImageDataExt.ReportCoordinateSystem.NATIVE


class Album:
    """Fulfils `answer` when nothing is missing; a camera without a picture is reported without one."""

    def __init__(
        self, sensors: Iterable[int], answer: Callable[[Callable[[], ReportStillImageDataExt]], Deferred]
    ) -> None:
        self._records = {sensor: Record(sensor, NATIVE) for sensor in sensors}
        self._missing = set(self._records)
        self.answer = answer(self.report)
        self._look()

    def report(self) -> ReportStillImageDataExt:
        """What is there."""
        return ReportStillImageDataExt(list(self._records.values()))

    def add(self, sensor: int, develop: Callable[[Still], Record], still: Still | None) -> None:
        """A camera is done."""
        if still is not None:
            self._records[sensor] = develop(still)
        self._missing.discard(sensor)
        self._look()

    def _look(self) -> None:
        if not self._missing:
            self.answer.set_result(self.report())


Then: TypeAlias = Callable[[Still | None], None]


class Exposures:
    """Has the cameras take pictures. Those that come to nothing are counted: `still_refused`, `still_lost`."""

    def __init__(self, cameras: Cameras, count: Callable[[str, str], None]) -> None:
        self._cameras, self._count = cameras, count
        self._waiting: dict[tuple[int, StillSettings], list[Then]] = {}

    def take(self, sensor: int, settings: StillSettings, then: Then) -> None:
        """Call `then` with the picture, or with None when there is none, now or later."""
        under_way = self._waiting.get((sensor, settings))
        if under_way is not None:
            under_way.append(then)
            return
        self._waiting[sensor, settings] = [then]
        try:
            self._cameras[sensor].source.take(settings, partial(self._taken, sensor, settings))
        except ConfigError as error:
            self._count("still_refused", f"sensor {sensor}: {error}")
            self._hand_out(sensor, settings, None)

    def _taken(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        if still is None:
            self._count("still_lost", f"sensor {sensor}: its process ended before the picture was taken")
        self._hand_out(sensor, settings, still)

    def _hand_out(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        for then in self._waiting.pop((sensor, settings), []):
            then(still)


_Capabilities = ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec
_Configuration = ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec
_Wanted = SetStillImageSensorConfiguration.StillImageSensorConfigurationRec
_Code = StillImageSensorErrorRec.StillImageErrorCode
_Number = ReportStillImageDataExt.ImageFrameFormat

FORMATS: Final = {_Number.JPEG: StillFormat.JPEG, _Number.PNG: StillFormat.PNG}
"""By JAUS's numbers."""
NUMBERS: Final = {format: number for number, format in FORMATS.items()}


class StillImage(Service, urn="urn:jaus:jss:environmentSensing:StillImage"):
    """JPEG and PNG; at first JPEG of the size that the stream has at first. Each query has pictures taken.

    A camera that has no picture to give is reported without one. Images have no coordinates to be transformed.
    """

    omits = frozenset({"send_report_still_image_data_ext_in_requested_coordinate_system"})

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras
        streams = {sensor: camera.source.settings for sensor, camera in cameras.items()}
        self._settings = {
            sensor: StillSettings(stream.width, stream.height, StillFormat.JPEG) for sensor, stream in streams.items()
        }
        self._answer: Deferred | None = None

    def attached(self) -> None:
        """Pictures that come to nothing are counted by the component."""
        self._exposures = Exposures(self._cameras, self.host.count)

    def is_coordinate_transform_supported(self) -> bool:
        """An image stays as the camera sees it."""
        return False

    # --- pictures

    def capture_still_image(self, msg: QueryStillImageDataExt) -> None:
        """Take a picture with each camera that is asked for."""
        wanted = requested_sensors(msg.query_still_image_data_list, self._cameras, known_only=True)
        album = Album([sensor for sensor, _ in wanted], self.host.defer)
        for sensor, _ in wanted:
            settings = self._settings[sensor]
            develop = partial(self._developed, sensor, settings.format)
            self._exposures.take(sensor, settings, partial(album.add, sensor, develop))
        self._answer = album.answer

    def send_report_still_image_data_ext_in_native_coordinate_system(self) -> Deferred | None:
        """The pictures that were just asked for, when all are there."""
        answer, self._answer = self._answer, None
        return answer

    def _developed(self, sensor: int, format: StillFormat, still: Still) -> Record:
        at = time_stamp(self.host.utc_time - timedelta(seconds=still.age))
        image = ReportStillImageDataExt.ImageFrame(NUMBERS[format], still.content)
        return Record(sensor, NATIVE, at, image)

    # --- what they are, and how they are set

    def send_report_still_image_sensor_capabilities(
        self, query: QueryStillImageSensorCapabilities
    ) -> ReportStillImageSensorCapabilities:
        """Sizes and formats of each camera."""
        wanted = requested_sensors(query.query_still_image_sensor_capabilities_list, self._cameras, known_only=True)
        formats = SupportedImageFormats(*(int(number in FORMATS) for number in _Number))
        return ReportStillImageSensorCapabilities(
            [_Capabilities(sensor, supported_frame_sizes(), formats) for sensor, _ in wanted]
        )

    def send_report_still_image_sensor_configuration(
        self, query: QueryStillImageSensorConfiguration
    ) -> ReportStillImageSensorConfiguration:
        """How each camera is set."""
        wanted = requested_sensors(query.query_still_image_sensor_configuration_list, self._cameras, known_only=True)
        return ReportStillImageSensorConfiguration([self._configuration(sensor) for sensor, _ in wanted])

    def _configuration(self, sensor: int) -> _Configuration:
        now = self._settings[sensor]
        return _Configuration(sensor, frame_size(now.width, now.height), NUMBERS[now.format])

    # --- settings

    def send_confirm_sensor_configuration(self, msg: SetStillImageSensorConfiguration) -> ConfirmSensorConfiguration:
        """For each camera that it is set, or why not."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = requested_sensors(msg.still_image_sensor_list, self._cameras)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def update_still_image_sensor_configuration(self, msg: SetStillImageSensorConfiguration) -> None:
        """Set what can be set, for the next picture; a setting that is left out stays."""
        for sensor, record in requested_sensors(msg.still_image_sensor_list, self._cameras, known_only=True):
            if self._refusal(sensor, record) is None:
                self._settings[sensor] = _changed(self._settings[sensor], record)

    def _refusal(self, sensor: int, wanted: _Wanted) -> StillImageSensorErrorRec | None:
        if sensor not in self._cameras:
            return StillImageSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        wrong = []
        if wanted.frame_size is not None and wanted.frame_size not in SUPPORTED_FRAME_SIZES:
            wrong.append((_Code.INVALID_FRAME_SIZE, "the camera does not have this size"))
        if wanted.still_image_format is not None and wanted.still_image_format not in FORMATS:
            wrong.append((_Code.INVALID_FORMAT, "the camera writes JPEG and PNG only"))
        if not wrong:
            return None
        code = wrong[0][0] if len(wrong) == 1 else _Code.MULTIPLE_INVALID_PARAMETERS
        return StillImageSensorErrorRec(sensor, code, "; ".join(text for _, text in wrong))


def _changed(present: StillSettings, wanted: _Wanted) -> StillSettings:
    if wanted.frame_size is not None:
        width, height = SUPPORTED_FRAME_SIZES[wanted.frame_size]  # type: ignore[index]  # an IntEnum is as good as its number
        present = replace(present, width=width, height=height)
    if wanted.still_image_format is not None:
        present = replace(present, format=FORMATS[wanted.still_image_format])  # type: ignore[index]
    return present
