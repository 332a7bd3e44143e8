"""AEODRSDigitalVideo, and H264VideoEncoding in the form of IOP v3, for the streams of a component's cameras."""

from __future__ import annotations

import ipaddress
from functools import partial
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    SetH264VideoEncodingConfiguration as SensingConfiguration,
)
from jauspy.messages.exp import (
    QueryAimpointParameters,
    QueryDigitalVideoEndpoint,
    ReportAimpointParameters,
    ReportDigitalVideoEndpoint,
    SetDigitalVideoEndpoint,
)
from jauspy.messages.iop.v1_0.h264_video_encoding import (
    QueryH264VideoEncodingCapabilities,
    QueryH264VideoEncodingConfiguration,
    ReportH264VideoEncodingCapabilities,
    ReportH264VideoEncodingConfiguration,
    SetH264VideoEncodingConfiguration,
)
from jauspy.protocol.addressing import Location
from jauspy.services.environment_sensing import VideoStreams
from jauspy.services.environment_sensing.h264_video_encoding import (
    PRESET_OF,
    PROFILE_OF,
    PROFILES,
    apply_settings,
    find_problems,
    preset_flags,
)
from jauspy.services.environment_sensing.sensors import requested_sensors
from jauspy.services.environment_sensing.visual_sensor import Cameras
from jauspy.services.service import Service

_Endpoint = ReportDigitalVideoEndpoint.EndpointRecord


class AEODRSDigitalVideo(Service, urn="urn:jaus:jss:exp:aeodrs:AEODRSDigitalVideo"):
    """One end point of each camera for the client in control, by the rules of DigitalResourceDiscovery.

    The stream goes to the client's own machine, or into the networks of `video_targets`, and ends with control. The
    aiming mark is the middle of the picture.
    """

    def __init__(self, streams: VideoStreams) -> None:
        self._streams = streams
        self._numbers: dict[int, int] = {}
        """End points by sensor."""

    def set_digital_video_endpoint(self, msg: SetDigitalVideoEndpoint, source: JausID) -> None:
        """Send the stream there, in place of the address before; the address 0 ends it."""
        sensor, record = msg.sensor_id_rec.sensor_id, msg.endpoint_record
        if not record.ip_addr and not record.port:
            self._streams.remove(self._numbers.pop(sensor, 0))
            return
        url = f"rtp://{ipaddress.IPv4Address(record.ip_addr)}:{record.port}"
        self.host.locate(source, partial(self._register, source, sensor, url))

    def _register(self, client: JausID, sensor: int, url: str, location: Location) -> None:
        if client != self.host.controller:  # it has lost control meanwhile
            return
        try:
            number = self._streams.register(client, sensor, url, location, {client})
        except ConfigError as error:
            self.host.count("endpoint_refused", f"{client}: {error}")
            return
        before = self._numbers.get(sensor)
        self._numbers[sensor] = number
        if before is not None and before != number:
            self._streams.remove(before)

    def control_lost(self) -> None:
        """End the streams of the client."""
        for number in self._numbers.values():
            self._streams.remove(number)
        self._numbers.clear()

    def send_report_digital_video_endpoint(
        self, query: QueryDigitalVideoEndpoint, source: JausID
    ) -> ReportDigitalVideoEndpoint:
        """Where the stream goes; zeros if nowhere, or for other clients, from whom addresses are private."""
        point = self._streams.end_points.get(self._numbers.get(query.sensor_id, 0))
        host, port = ("", 0) if point is None or point.client != source else point.address
        return ReportDigitalVideoEndpoint(
            ReportDigitalVideoEndpoint.SensorIdRec(query.sensor_id),
            _Endpoint(int(ipaddress.IPv4Address(host)) if host else 0, port),
        )

    def send_report_aimpoint_parameters(self, query: QueryAimpointParameters) -> ReportAimpointParameters | None:
        """The size of the picture and its middle; None, and counted, if there is no such camera."""
        camera = self._streams.cameras.get(query.sensor_id)
        if camera is None:
            self.host.count("unknown_sensor", str(query.sensor_id))
            return None
        width, height = camera.source.settings.width, camera.source.settings.height
        return ReportAimpointParameters(
            ReportAimpointParameters.SensorIdRec(query.sensor_id),
            ReportAimpointParameters.ResolutionRec(width, height),
            ReportAimpointParameters.ReticlePositionRec(width // 2, height // 2),
        )


_Report = ReportH264VideoEncodingConfiguration
_Capabilities = ReportH264VideoEncodingCapabilities
_Record = SensingConfiguration.H264ConfigurationRec
_Sequence = SensingConfiguration.H264ConfigurationSequence
LEVEL_BITS: Final = 17
"""Levels 1 to 5.2, which the encoders have all."""
NO_REGION: Final = [0.0] * 6


class H264VideoEncoding(Service, urn="urn:jaus:jss:iop:H264VideoEncoding"):
    """The encoders of `environmentSensing:H264VideoEncoding`; a command with a part that is not possible is ignored."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def is_supported_command(self, msg: SetH264VideoEncodingConfiguration) -> bool:
        """Guard: True if all sensors are known, and their encoders can do what is asked."""
        return all(
            record.sensor_id in self._cameras
            and not find_problems(_requested(record), self._cameras[record.sensor_id].source.settings)
            for record in msg.h264_configuration_list
        )

    def set_h264_video_encoding_config(self, msg: SetH264VideoEncodingConfiguration) -> None:
        """Apply the settings; omitted ones keep their values."""
        for record in msg.h264_configuration_list:
            source = self._cameras[record.sensor_id].source
            source.settings = apply_settings(_requested(record), source.settings)

    def send_report_h264_video_encoding_capabilities(
        self, query: QueryH264VideoEncodingCapabilities
    ) -> ReportH264VideoEncodingCapabilities:
        """Profiles, levels and presets."""
        requested = requested_sensors(query.query_h264_video_encoding_capabilities_list, self._cameras, known_only=True)
        return ReportH264VideoEncodingCapabilities([_capabilities(sensor) for sensor, _ in requested])

    def send_report_h264_video_encoding_configuration(
        self, query: QueryH264VideoEncodingConfiguration
    ) -> ReportH264VideoEncodingConfiguration:
        """The settings of each encoder."""
        requested = requested_sensors(
            query.query_h264_video_encoding_configuration_list, self._cameras, known_only=True
        )
        return ReportH264VideoEncodingConfiguration([self._configuration(sensor) for sensor, _ in requested])

    def _configuration(self, sensor: int) -> Any:
        settings = self._cameras[sensor].source.settings
        return _Report.H264ConfigurationRec(
            sensor_id=sensor,
            profile=int(PROFILE_OF[settings.coding.profile]),
            preset=int(PRESET_OF[settings.coding.preset]),
            group_of_pictures=settings.gop,
            gradual_decoder_refresh_on_off=int(settings.coding.gradual),
            region_of_interest_on_off=0,
            roi_parameters=NO_REGION,
        )


def _requested(record: Any) -> _Sequence:
    """The same settings in the form of AS6060."""
    return _Sequence(
        _Record(
            record.sensor_id,
            profile=record.profile,
            preset=record.preset,
            group_of_pictures=record.group_of_pictures,
            gradual_decoder_refresh_on_off=record.gradual_decoder_refresh_on_off,
            region_of_interest_on_off=record.region_of_interest_on_off,
        )
    )


def _capabilities(sensor: int) -> Any:
    return _Capabilities.H264CapabilityRec(
        sensor,
        supported_profiles=_Capabilities.SupportedProfiles(
            *(int(int(number) in PROFILES) for number in _Report.Profile)
        ),
        supported_levels=_Capabilities.SupportedLevels(*[1] * LEVEL_BITS),
        supported_presets=_Capabilities.SupportedPresets(**preset_flags()),
        group_of_pictures_supported=1,
        gradual_decoder_refresh_supported=1,
        region_of_interest_supported=0,
    )
