"""DigitalVideo: size, frame rate, bit rate and state of the cameras' streams (AS6060)."""

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
from jauspy.platform.video_settings import (
    MAX_BIT_RATE,
    MAX_RATE,
    MIN_BIT_RATE,
    SUPPORTED_FRAME_SIZES,
    VideoSettings,
    frame_size,
    supported_frame_sizes,
)
from jauspy.services.environment_sensing.digital_resource_discovery import StreamState, VideoStreams
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.service import Service

_Capabilities = ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec
_Configuration = ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec
_Status = ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec
_RequestedSettings = SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec
_Code = DigitalVideoSensorErrorRec.DigitalVideoErrorCode

H264: Final = ReportDigitalVideoSensorConfiguration.DigitalFormat.MPEG_4_AVC
KILO: Final = 1000


class DigitalVideo(Service, urn="urn:jaus:jss:environmentSensing:DigitalVideo"):
    """H.264 streams. The encoder has one bit rate, which is reported as both the minimum and the maximum.

    A client plays, pauses and stops its own end points (`DigitalResourceDiscovery`); other clients are unaffected.
    """

    omits = frozenset({"update_digital_video_sensor_recording_state"})

    def __init__(self, streams: VideoStreams) -> None:
        self._streams, self._cameras = streams, streams.cameras

    def is_supported(self) -> bool:
        """Return False: the cameras do not record."""
        return False

    def send_report_digital_video_sensor_capabilities_ext(
        self, query: QueryDigitalVideoSensorCapabilitiesExt
    ) -> ReportDigitalVideoSensorCapabilitiesExt:
        """Return the sizes, frame rates and bit rates that each camera supports."""
        requested = requested_sensors(
            query.query_digital_video_sensor_capabilities_list, self._cameras, known_only=True
        )
        return ReportDigitalVideoSensorCapabilitiesExt([capabilities(sensor) for sensor, _ in requested])

    def send_report_digital_video_sensor_configuration(
        self, query: QueryDigitalVideoSensorConfiguration
    ) -> ReportDigitalVideoSensorConfiguration:
        """Return the size, frame rate and bit rate of each stream."""
        requested = requested_sensors(query.query_digital_video_configuration_list, self._cameras, known_only=True)
        return ReportDigitalVideoSensorConfiguration([self._configuration(sensor) for sensor, _ in requested])

    def send_report_digital_video_sensor_status(
        self, query: QueryDigitalVideoSensorStatus
    ) -> ReportDigitalVideoSensorStatus:
        """Return for each stream PLAY if any end point plays it; it is never recorded."""
        requested = requested_sensors(query.sensor_id_list, self._cameras, known_only=True)
        idle = ReportDigitalVideoSensorStatus.RecordingState.NOT_RECORDING
        states = ReportDigitalVideoSensorStatus.StreamingState
        return ReportDigitalVideoSensorStatus(
            [_Status(sensor, states(self._streams.state(sensor).value), idle) for sensor, _ in requested]
        )

    def send_confirm_sensor_configuration(self, msg: SetDigitalVideoSensorConfiguration) -> ConfirmSensorConfiguration:
        """Return for each camera its sensor id, or an error record with the reason."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = requested_sensors(msg.digital_video_sensor_list, self._cameras)
        return ConfirmSensorConfiguration(
            request, [self._refusal(*request) or SensorIdRec(request[0]) for request in requested]
        )

    def update_digital_video_sensor_configuration(self, msg: SetDigitalVideoSensorConfiguration) -> None:
        """Apply valid settings from the next frame on; omitted settings keep their values."""
        for sensor, record in requested_sensors(msg.digital_video_sensor_list, self._cameras, known_only=True):
            if self._refusal(sensor, record) is None:
                source = self._cameras[sensor].source
                source.settings = _apply_settings(record, source.settings)

    def modify_digital_video_sensor_stream(self, msg: ControlDigitalVideoSensorStream, source: JausID) -> None:
        """Play, pause or stop the client's end points; PLAY starts with an IDR frame."""
        state = next((state for state in StreamState if state.value == msg.stream_state), None)
        if state is None:
            self.host.count("stream_refused", f"{source}: there is no state {msg.stream_state}")
            return
        try:
            count = self._streams.control(source, msg.sensor_id, state)
        except ConfigError as error:
            self.host.count("stream_refused", f"{source}: {error}")
            return
        if not count:
            self.host.count("stream_unknown", f"{source} has no end point of sensor {msg.sensor_id}")

    def client_lost(self, client: JausID) -> None:
        """Remove the end points of the client."""
        self._streams.remove_client(client)

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

    def _refusal(self, sensor: int, requested: _RequestedSettings) -> DigitalVideoSensorErrorRec | None:
        if sensor not in self._cameras:
            return DigitalVideoSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        problems = _find_problems(requested) or _level_problems(requested, self._cameras[sensor].source.settings)
        if not problems:
            return None
        code = problems[0][0] if len(problems) == 1 else _Code.MULTIPLE_INVALID_PARAMETERS
        return DigitalVideoSensorErrorRec(sensor, code, "; ".join(text for _, text in problems)[:255])


def _apply_settings(requested: _RequestedSettings, present: VideoSettings) -> VideoSettings:
    width, height = SUPPORTED_FRAME_SIZES.get(requested.frame_size, (present.width, present.height))  # type: ignore[call-overload]
    rate = present.rate if requested.frame_rate is None else requested.frame_rate
    kilobits = requested.maximum_bit_rate if requested.maximum_bit_rate is not None else requested.minimum_bit_rate
    bit_rate = present.bit_rate if kilobits is None else kilobits * KILO
    return replace(present, width=width, height=height, rate=rate, bit_rate=bit_rate)


def _level_problems(requested: _RequestedSettings, present: VideoSettings) -> list[tuple[_Code, str]]:
    try:
        _apply_settings(requested, present)
    except ConfigError as error:
        return [(_Code.INVALID_FRAME_SIZE, str(error))]
    return []


def _find_problems(requested: _RequestedSettings) -> list[tuple[_Code, str]]:
    low, high = MIN_BIT_RATE // KILO, MAX_BIT_RATE // KILO
    problems = []
    minimum, maximum = requested.minimum_bit_rate, requested.maximum_bit_rate
    if minimum is not None and minimum > (high if maximum is None else maximum):
        problems.append(
            (_Code.INVALID_MINIMUM_BIT_RATE, f"the least bit rate is at most the largest, and {high} kbit/s")
        )
    if (bit_rate := minimum if maximum is None else maximum) is not None and not low <= bit_rate <= high:
        problems.append((_Code.INVALID_MAXIMUM_BIT_RATE, f"bit rates are {low}..{high} kbit/s"))
    if requested.frame_rate == 0:
        problems.append((_Code.FRAME_RATE_TOO_LOW, f"frame rates are 1..{MAX_RATE} a second"))
    if requested.frame_rate is not None and requested.frame_rate > MAX_RATE:
        problems.append((_Code.FRAME_RATE_TOO_HIGH, f"frame rates are 1..{MAX_RATE} a second"))
    if requested.frame_size is not None and requested.frame_size not in SUPPORTED_FRAME_SIZES:
        problems.append((_Code.INVALID_FRAME_SIZE, "the camera does not have this size"))
    if requested.digital_format not in {None, H264}:
        problems.append((_Code.INVALID_FORMAT, "the camera codes H.264 only"))
    return problems


def capabilities(sensor: int) -> _Capabilities:
    """Capabilities that the streams of every camera have."""
    return _Capabilities(
        sensor,
        minimum_bit_rate=MIN_BIT_RATE // KILO,
        maximum_bit_rate=MAX_BIT_RATE // KILO,
        minimum_frame_rate=1,
        maximum_frame_rate=MAX_RATE,
        supported_frame_sizes=supported_frame_sizes(),
        supported_digital_formats=SupportedDigitalFormats(
            avi=0, mjpeg=0, mpeg2=0, h263=0, h26_3_plus=0, mpeg4_visual=0, mpeg4_avc_h264=1
        ),
        recording_supported=ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported.UNSUPPORTED,
    )
