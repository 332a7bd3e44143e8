"""VisualSensor: cameras with a fixed lens, and their mounting (AS6060)."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from typing import Final, Protocol, TypeAlias

from jauspy.messages.environment_sensing.v1_0.types import (
    SensorIdRec,
    SupportedStates,
    VisualSensorErrorRec,
)
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
from jauspy.services.environment_sensing.sensors import MountedSensor, geometric_properties, requested_sensors
from jauspy.services.service import Service

Address: TypeAlias = tuple[str, int]

_Ext = ReportVisualSensorCapabilitiesExt.VisualSensorCapabilitiesRec

_Capabilities = ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec

_Configuration = ReportVisualSensorConfiguration.VisualSensorConfigurationRec

_RequestedSettings = SetVisualSensorConfiguration.VisualSensorConfigurationRec

_Code = VisualSensorErrorRec.VisualSensorErrorCode

_SETTINGS: Final = tuple(
    each.name for each in fields(_RequestedSettings) if each.name not in {"sensor_id", "reserved_presence"}
)


class VideoSource(Protocol):
    """Encodes a camera's images, sends them to all watching addresses, and takes still images. No method blocks."""

    @property
    def setup(self) -> CameraSetup:
        """Name, link and field of view of the camera."""
        ...

    @property
    def settings(self) -> VideoSettings:
        """Size, rates and coding of the stream."""
        ...

    @settings.setter
    def settings(self, settings: VideoSettings) -> None: ...

    def watch(self, address: Address, *, playing: bool = True) -> None:
        """Send the stream to an address, or pause it; raises `ConfigError` if there are too many."""
        ...

    def leave(self, address: Address) -> None:
        """Stop sending to an address."""
        ...

    def take(self, settings: StillSettings, then: Callable[[Still | None], None]) -> None:
        """Take a still image and pass it to `then` later, or None on failure; raises `ConfigError` if it is refused."""
        ...


@dataclass(frozen=True, slots=True)
class VideoCamera(MountedSensor):
    """A camera of the vehicle."""

    source: VideoSource = field(kw_only=True)


Cameras: TypeAlias = Mapping[int, VideoCamera]
"""The cameras of a component by sensor id, from 1."""


class VisualSensor(Service, urn="urn:jaus:jss:environmentSensing:VisualSensor"):
    """Cameras that are always active and see in colour, with a field of view that does not change."""

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_visual_sensor_capabilities(
        self, query: QueryVisualSensorCapabilities
    ) -> ReportVisualSensorCapabilities:
        """Return name and supported states of each camera."""
        requested = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilities(
            [
                _Capabilities(sensor, self._name(sensor), supported_states=SupportedStates(1, 0, 0))
                for sensor, _ in requested
            ]
        )

    def send_report_visual_sensor_capabilities_ext(
        self, query: QueryVisualSensorCapabilitiesExt
    ) -> ReportVisualSensorCapabilitiesExt:
        """Return name, supported states and field of view (radians) of each camera."""
        requested = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilitiesExt([self._extended(sensor) for sensor, _ in requested])

    def send_report_visual_sensor_configuration(
        self, query: QueryVisualSensorConfiguration
    ) -> ReportVisualSensorConfiguration:
        """Return state, field of view and imaging mode of each camera."""
        requested = requested_sensors(query.query_visual_sensor_configuration_list, self._cameras, known_only=True)
        return ReportVisualSensorConfiguration([self._configuration(sensor) for sensor, _ in requested])

    def send_report_sensor_geometric_properties(
        self, query: QuerySensorGeometricProperties
    ) -> ReportSensorGeometricProperties:
        """Return the mounting of each camera."""
        requested = requested_sensors(query.sensor_id_list, self._cameras, known_only=True)
        return ReportSensorGeometricProperties(
            [geometric_properties(sensor, self._cameras[sensor]) for sensor, _ in requested]
        )

    def send_confirm_sensor_configuration(self, msg: SetVisualSensorConfiguration) -> ConfirmSensorConfiguration:
        """Return for each camera its id if the settings equal the present ones, otherwise an error record."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = requested_sensors(msg.visual_sensor_configuration_list, self._cameras)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in requested])

    def update_visual_sensor_configuration(self) -> None:
        """Do nothing: no setting can be changed."""

    def _refusal(self, sensor: int, requested: _RequestedSettings) -> VisualSensorErrorRec | None:
        if sensor not in self._cameras:
            return VisualSensorErrorRec(sensor, _Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        present = self._configuration(sensor)
        problems = [name for name in _SETTINGS if getattr(requested, name) not in {None, getattr(present, name)}]
        if not problems:
            return None
        text = f"these cannot be set on this camera: {', '.join(problems)}"
        return VisualSensorErrorRec(sensor, _Code.MULTIPLE_INVALID_PARAMETERS, text[:255])

    def _name(self, sensor: int) -> str:
        return self._cameras[sensor].source.setup.name

    def _extended(self, sensor: int) -> _Ext:
        horizontal, vertical = _fields_of_view(self._cameras[sensor])
        return _Ext(
            sensor,
            self._name(sensor),
            supported_states=SupportedStates(1, 0, 0),
            minimum_horizontal_field_of_view=horizontal,
            maximum_horizontal_field_of_view=horizontal,
            minimum_vertical_field_of_view=vertical,
            maximum_vertical_field_of_view=vertical,
        )

    def _configuration(self, sensor: int) -> _Configuration:
        horizontal, vertical = _fields_of_view(self._cameras[sensor])
        return _Configuration(
            sensor,
            sensor_state=ReportVisualSensorConfiguration.SensorState.ACTIVE,
            horizontal_field_of_view=horizontal,
            vertical_field_of_view=vertical,
            imaging_mode=ReportVisualSensorConfiguration.ImagingMode.COLOR,
        )


def _fields_of_view(camera: VideoCamera) -> tuple[float, float]:
    """Horizontal and vertical angle, radians; the vertical one follows from the aspect ratio of the images."""
    horizontal, size = camera.source.setup.fov, camera.source.settings
    return horizontal, 2.0 * math.atan(math.tan(horizontal / 2.0) * size.height / size.width)
