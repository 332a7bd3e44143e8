"""DigitalVideo: size, rates and flow of the cameras' streams (AS6060)."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v1_0.types import (
    DigitalVideoSensorErrorRec,
    SensorIdRec,
    SupportedDigitalFormats,
)
from jauspy.messages.environment_sensing.v2_0.digital_video import (
    ControlDigitalVideoSensorStream,
    QueryDigitalVideoSensorCapabilitiesExt,
    QueryDigitalVideoSensorConfiguration,
    QueryDigitalVideoSensorStatus,
    ReportDigitalVideoSensorCapabilitiesExt,
    ReportDigitalVideoSensorConfiguration,
    ReportDigitalVideoSensorStatus,
    SetDigitalVideoSensorConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.platform.video_settings import MAX_BIT_RATE, MAX_RATE, MIN_BIT_RATE, VideoSettings
from jauspy.services.environment_sensing.digital_resource_discovery import StreamState, VideoStreams
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.environment_sensing.visual_sensor import SUPPORTED_FRAME_SIZES, frame_size, supported_frame_sizes
from jauspy.services.service import Service

_Capabilities = ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec
_Configuration = ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec
_Status = ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec
_Wanted = SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec
_Code = DigitalVideoSensorErrorRec.DigitalVideoErrorCode

H264: Final = ReportDigitalVideoSensorConfiguration.DigitalFormat.MPEG_4_AVC
KILO: Final = 1000


class DigitalVideo(Service, urn="urn:jaus:jss:environmentSensing:DigitalVideo"):
    """Streams in H.264. There is one bit rate: the least and the largest that are reported are the same.

    A client plays, pauses and stops its own end points (`DigitalResourceDiscovery`); others see what they saw.
    """

    omits = frozenset({"update_digital_video_sensor_recording_state"})

    def __init__(self, viewers: VideoStreams) -> None:
        self._viewers, self._cameras = viewers, viewers.cameras

    def is_supported(self) -> bool:
        """The cameras do not record."""
        return False

    def send_report_digital_video_sensor_capabilities_ext(
        self, query: QueryDigitalVideoSensorCapabilitiesExt
    ) -> ReportDigitalVideoSensorCapabilitiesExt:
        """What each stream can be."""
        wanted = requested_sensors(query.query_digital_video_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportDigitalVideoSensorCapabilitiesExt([_capabilities(sensor) for sensor, _ in wanted])

    def send_report_digital_video_sensor_configuration(
        self, query: QueryDigitalVideoSensorConfiguration
    ) -> ReportDigitalVideoSensorConfiguration:
        """What each stream is."""
        wanted = requested_sensors(query.query_digital_video_configuration_list, self._cameras, known_only=True)
        return ReportDigitalVideoSensorConfiguration([self._configuration(sensor) for sensor, _ in wanted])

    def send_report_digital_video_sensor_status(
        self, query: QueryDigitalVideoSensorStatus
    ) -> ReportDigitalVideoSensorStatus:
        """Whether each stream plays for anybody."""
        wanted = requested_sensors(query.sensor_id_list, self._cameras, known_only=True)
        idle = ReportDigitalVideoSensorStatus.RecordingState.NOT_RECORDING
        states = ReportDigitalVideoSensorStatus.StreamingState
        return ReportDigitalVideoSensorStatus(
            [_Status(sensor, states(self._viewers.flow(sensor).value), idle) for sensor, _ in wanted]
        )

    def send_confirm_sensor_configuration(self, msg: SetDigitalVideoSensorConfiguration) -> ConfirmSensorConfiguration:
        """For each camera that it is set, or why not."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = requested_sensors(msg.digital_video_sensor_list, self._cameras)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def update_digital_video_sensor_configuration(self, msg: SetDigitalVideoSensorConfiguration) -> None:
        """Set what can be set, from the next picture on; a setting that is left out stays."""
        for sensor, record in requested_sensors(msg.digital_video_sensor_list, self._cameras, known_only=True):
            if self._refusal(sensor, record) is None:
                source = self._cameras[sensor].source
                source.settings = _settings(record, source.settings)

    def modify_digital_video_sensor_stream(self, msg: ControlDigitalVideoSensorStream, source: JausID) -> None:
        """Play, pause or stop what the client has entered; a new PLAY begins with a whole picture."""
        try:
            found = self._viewers.control(source, msg.sensor_id, StreamState(msg.stream_state))
        except ConfigError as error:
            self.host.count("stream_refused", f"{source}: {error}")
            return
        if not found:
            self.host.count("stream_unknown", f"{source} has no end point of sensor {msg.sensor_id}")

    def client_lost(self, client: JausID) -> None:
        """Its streams end."""
        self._viewers.forget(client)

    def _configuration(self, sensor: int) -> _Configuration:
        settings = self._cameras[sensor].source.settings
        return _Configuration(
            sensor,
            minimum_bit_rate=settings.bit_rate // KILO,
            maximum_bit_rate=settings.bit_rate // KILO,
            frame_rate=settings.rate,
            frame_size=frame_size(settings.width, settings.height),
            digital_format=H264,
        )

    def _refusal(self, sensor: int, wanted: _Wanted) -> DigitalVideoSensorErrorRec | None:
        if sensor not in self._cameras:
            return DigitalVideoSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        wrong = _problems(wanted) or _beyond_level(wanted, self._cameras[sensor].source.settings)
        if not wrong:
            return None
        code = wrong[0][0] if len(wrong) == 1 else _Code.MULTIPLE_INVALID_PARAMETERS
        return DigitalVideoSensorErrorRec(sensor, code, "; ".join(text for _, text in wrong)[:255])


def _settings(wanted: _Wanted, present: VideoSettings) -> VideoSettings:
    width, height = SUPPORTED_FRAME_SIZES.get(wanted.frame_size, (present.width, present.height))  # type: ignore[call-overload]
    rate = present.rate if wanted.frame_rate is None else wanted.frame_rate
    kilobits = wanted.maximum_bit_rate if wanted.maximum_bit_rate is not None else wanted.minimum_bit_rate
    bit_rate = present.bit_rate if kilobits is None else kilobits * KILO
    return replace(present, width=width, height=height, rate=rate, bit_rate=bit_rate)


def _beyond_level(wanted: _Wanted, present: VideoSettings) -> list[tuple[_Code, str]]:
    try:
        _settings(wanted, present)
    except ConfigError as error:
        return [(_Code.INVALID_FRAME_SIZE, str(error))]
    return []


def _problems(wanted: _Wanted) -> list[tuple[_Code, str]]:
    low, high = MIN_BIT_RATE // KILO, MAX_BIT_RATE // KILO
    wrong = []
    least, most = wanted.minimum_bit_rate, wanted.maximum_bit_rate
    if least is not None and not (least if most is None else 0) <= least <= (high if most is None else most):
        wrong.append((_Code.INVALID_MINIMUM_BIT_RATE, f"the least bit rate is at most the largest, and {high} kbit/s"))
    if (rate := least if most is None else most) is not None and not low <= rate <= high:
        wrong.append((_Code.INVALID_MAXIMUM_BIT_RATE, f"bit rates are {low}..{high} kbit/s"))
    if wanted.frame_rate == 0:
        wrong.append((_Code.FRAME_RATE_TOO_LOW, f"frame rates are 1..{MAX_RATE} a second"))
    if wanted.frame_rate is not None and wanted.frame_rate > MAX_RATE:
        wrong.append((_Code.FRAME_RATE_TOO_HIGH, f"frame rates are 1..{MAX_RATE} a second"))
    if wanted.frame_size is not None and wanted.frame_size not in SUPPORTED_FRAME_SIZES:
        wrong.append((_Code.INVALID_FRAME_SIZE, "the camera does not have this size"))
    if wanted.digital_format not in {None, H264}:
        wrong.append((_Code.INVALID_FORMAT, "the camera codes H.264 only"))
    return wrong


def _capabilities(sensor: int) -> _Capabilities:
    return _Capabilities(
        sensor,
        minimum_bit_rate=MIN_BIT_RATE // KILO,
        maximum_bit_rate=MAX_BIT_RATE // KILO,
        minimum_frame_rate=1,
        maximum_frame_rate=MAX_RATE,
        supported_frame_sizes=supported_frame_sizes(),
        supported_digital_formats=SupportedDigitalFormats(0, 0, 0, 0, 0, 0, 1),
        recording_supported=ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported.UNSUPPORTED,
    )
