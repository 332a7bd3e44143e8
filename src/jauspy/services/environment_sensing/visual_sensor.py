"""VisualSensor: what cameras have in common; these have a fixed lens (AS6060)."""

from __future__ import annotations

import ipaddress
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Final, Protocol, TypeAlias
from urllib.parse import urlsplit

from jauspy.errors import ConfigError
from jauspy.messages.environment_sensing.v1_0.types import (
    SensorIdRec,
    SupportedFrameSizes,
    SupportedStates,
    VisualSensorErrorRec,
)
from jauspy.messages.environment_sensing.v2_0.digital_video import ReportDigitalVideoSensorConfiguration
from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
    ConfirmSensorConfiguration,
    QuerySensorGeometricProperties,
    QueryVisualSensorCapabilities,
    QueryVisualSensorCapabilitiesExt,
    QueryVisualSensorConfiguration,
    ReportSensorGeometricProperties,
    ReportVisualSensorCapabilities,
    ReportVisualSensorCapabilitiesExt,
    ReportVisualSensorConfiguration,
    SetVisualSensorConfiguration,
)
from jauspy.platform.camera import CameraSetup
from jauspy.platform.video_settings import Still, StillSettings, VideoSettings
from jauspy.services.environment_sensing.sensors import OnVehicle, geometric_properties, requested_sensors
from jauspy.services.service import Service

Address: TypeAlias = tuple[str, int]


class VideoSource(Protocol):
    """Encodes what a camera sees and sends it to all who watch, and takes still images; no caller ever waits."""

    @property
    def setup(self) -> CameraSetup:
        """What the camera is."""
        ...

    @property
    def settings(self) -> VideoSettings:
        """How the stream is encoded."""
        ...

    @settings.setter
    def settings(self, settings: VideoSettings) -> None: ...

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send there, or pause; `ConfigError` when it cannot."""
        ...

    def leave(self, address: Address) -> None:
        """Send there no longer."""
        ...

    def take(self, settings: StillSettings, then: Callable[[Still | None], None]) -> None:
        """Take a still image; `then` gets it, some time later, or None if none comes of it; `ConfigError` says why."""
        ...


@dataclass(frozen=True, slots=True)
class VideoCamera(OnVehicle):
    """A camera of the vehicle."""

    source: VideoSource = field(kw_only=True)


Cameras: TypeAlias = Mapping[int, VideoCamera]
"""The cameras of a component by the ids of their sensors, which count from 1."""


def parse_rtp_url(url: str) -> Address:
    """Where `rtp://ADDRESS:PORT` is; `ConfigError` says what is wrong with it. Names are not looked up."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname or "", parts.port or 0
        ipaddress.ip_address(host)
    except ValueError as error:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with an address in numbers: {error}") from error
    if parts.scheme != "rtp" or not 1 <= port <= 65534:
        raise ConfigError(f"{url!r} is not rtp://ADDRESS:PORT with a port of 1..65534")
    return host, port


FrameSize = ReportDigitalVideoSensorConfiguration.FrameSize

MAX_PIXELS: Final = 1920 * 1200
"""Pixels of the largest picture that is offered: above it no small machine keeps up."""


def _pixels(size: FrameSize) -> tuple[int, int]:
    _, width, height = size.name.split("_")
    return int(width), int(height.removeprefix("X"))


FRAME_SIZES: Final = {size: _pixels(size) for size in FrameSize}
"""Width and height."""

SUPPORTED_FRAME_SIZES: Final = {
    size: (width, height) for size, (width, height) in FRAME_SIZES.items() if width * height <= MAX_PIXELS
}


def frame_size(width: int, height: int) -> FrameSize | None:
    """The first size that is so wide and high; None when JAUS has none."""
    return next((size for size, pixels in FRAME_SIZES.items() if pixels == (width, height)), None)


def supported_frame_sizes() -> SupportedFrameSizes:
    """All sizes that are offered, for a report."""
    return SupportedFrameSizes(*(int(size in SUPPORTED_FRAME_SIZES) for size in FrameSize))


_Ext = ReportVisualSensorCapabilitiesExt.VisualSensorCapabilitiesRec
_Capabilities = ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec
_Configuration = ReportVisualSensorConfiguration.VisualSensorConfigurationRec
_Wanted = SetVisualSensorConfiguration.VisualSensorConfigurationRec
_Code = VisualSensorErrorRec.VisualSensorErrorCode

_SETTINGS: Final = tuple(each.name for each in fields(_Wanted) if each.name not in {"sensor_id", "reserved_presence"})


class VisualSensor(Service, urn="urn:jaus:jss:environmentSensing:VisualSensor"):
    """Cameras that are always active and see in colour, with a field of view that does not change."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_visual_sensor_capabilities(
        self, query: QueryVisualSensorCapabilities
    ) -> ReportVisualSensorCapabilities:
        """What each camera can do."""
        wanted = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilities(
            [
                _Capabilities(sensor, self._name(sensor), supported_states=SupportedStates(1, 0, 0))
                for sensor, _ in wanted
            ]
        )

    def send_report_visual_sensor_capabilities_ext(
        self, query: QueryVisualSensorCapabilitiesExt
    ) -> ReportVisualSensorCapabilitiesExt:
        """What each camera can do, and its field of view."""
        wanted = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilitiesExt([self._extended(sensor) for sensor, _ in wanted])

    def send_report_visual_sensor_configuration(
        self, query: QueryVisualSensorConfiguration
    ) -> ReportVisualSensorConfiguration:
        """How each camera is set."""
        wanted = requested_sensors(query.query_visual_sensor_configuration_list, self._cameras, known_only=True)
        return ReportVisualSensorConfiguration([self._configuration(sensor) for sensor, _ in wanted])

    def send_report_sensor_geometric_properties(
        self, query: QuerySensorGeometricProperties
    ) -> ReportSensorGeometricProperties:
        """Where each camera is on the vehicle."""
        wanted = requested_sensors(query.sensor_id_list, self._cameras, known_only=True)
        return ReportSensorGeometricProperties(
            [geometric_properties(sensor, self._cameras[sensor]) for sensor, _ in wanted]
        )

    def send_confirm_sensor_configuration(self, msg: SetVisualSensorConfiguration) -> ConfirmSensorConfiguration:
        """That nothing is to be changed, or that it cannot be."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        wanted = requested_sensors(msg.visual_sensor_configuration_list, self._cameras)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in wanted])

    def update_visual_sensor_configuration(self) -> None:
        """There is nothing to set."""

    def _refusal(self, sensor: int, wanted: _Wanted) -> VisualSensorErrorRec | None:
        if sensor not in self._cameras:
            return VisualSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        present = self._configuration(sensor)
        wrong = [name for name in _SETTINGS if getattr(wanted, name) not in {None, getattr(present, name)}]
        if not wrong:
            return None
        text = f"these cannot be set on this camera: {', '.join(wrong)}"
        return VisualSensorErrorRec(sensor, _Code.MULTIPLE_INVALID_PARAMETERS, text[:255])

    def _name(self, sensor: int) -> str:
        return self._cameras[sensor].source.setup.name

    def _extended(self, sensor: int) -> _Ext:
        across, down = _fields_of_view(self._cameras[sensor])
        return _Ext(
            sensor,
            self._name(sensor),
            supported_states=SupportedStates(1, 0, 0),
            minimum_horizontal_field_of_view=across,
            maximum_horizontal_field_of_view=across,
            minimum_vertical_field_of_view=down,
            maximum_vertical_field_of_view=down,
        )

    def _configuration(self, sensor: int) -> _Configuration:
        across, down = _fields_of_view(self._cameras[sensor])
        return _Configuration(
            sensor,
            sensor_state=ReportVisualSensorConfiguration.SensorState.ACTIVE,
            horizontal_field_of_view=across,
            vertical_field_of_view=down,
            imaging_mode=ReportVisualSensorConfiguration.ImagingMode.COLOR,
        )


def _fields_of_view(camera: VideoCamera) -> tuple[float, float]:
    """From left to right and from top to bottom, radians; the latter follows from the size of the pictures."""
    across, size = camera.source.setup.fov, camera.source.settings
    return across, 2.0 * math.atan(math.tan(across / 2.0) * size.height / size.width)
