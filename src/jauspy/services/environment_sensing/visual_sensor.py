"""VisualSensor: lens, exposure and mounting of cameras (AS6060)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Protocol, TypeAlias

from jauspy.messages.environment_sensing.v1_0.types import (
    SensorIdRec,
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
from jauspy.platform.imaging import ImagingSettings
from jauspy.platform.video_settings import Still, StillSettings, VideoSettings
from jauspy.services.environment_sensing.sensors import MountedSensor, geometric_properties, requested_sensors
from jauspy.services.environment_sensing.visual_settings import (
    Code,
    capabilities,
    fields_of_view,
    reported_settings,
    requested_settings,
    vertical,
)
from jauspy.services.service import Service

Address: TypeAlias = tuple[str, int]

_Ext = ReportVisualSensorCapabilitiesExt.VisualSensorCapabilitiesRec

_Capabilities = ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec

_Configuration = ReportVisualSensorConfiguration.VisualSensorConfigurationRec

_RequestedSettings = SetVisualSensorConfiguration.VisualSensorConfigurationRec


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

    @property
    def imaging(self) -> ImagingSettings:
        """Zoom, focus, exposure and colours."""
        ...

    @imaging.setter
    def imaging(self, settings: ImagingSettings) -> None: ...

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
    """Cameras that are always active; each offers what its lens and sensor can do.

    Settings are applied together or, if one of them is refused, not at all.
    """

    def __init__(self, cameras: Cameras) -> None:
        self._cameras = cameras

    def send_report_visual_sensor_capabilities(
        self, query: QueryVisualSensorCapabilities
    ) -> ReportVisualSensorCapabilities:
        """Return name, modes and limits of each camera."""
        requested = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilities(
            [
                _Capabilities(
                    sensor,
                    self._name(sensor),
                    **capabilities(self._cameras[sensor].source.setup),
                    imaging_modes=ReportVisualSensorCapabilities.ImagingModes(1, 1, 0, 0, 0, 0, 0, 0),
                )
                for sensor, _ in requested
            ]
        )

    def send_report_visual_sensor_capabilities_ext(
        self, query: QueryVisualSensorCapabilitiesExt
    ) -> ReportVisualSensorCapabilitiesExt:
        """Return name, modes, limits and fields of view (radians) of each camera."""
        requested = requested_sensors(query.query_visual_sensor_capabilities_list, self._cameras, known_only=True)
        return ReportVisualSensorCapabilitiesExt([self._extended(sensor) for sensor, _ in requested])

    def send_report_visual_sensor_configuration(
        self, query: QueryVisualSensorConfiguration
    ) -> ReportVisualSensorConfiguration:
        """Return the settings of each camera. Exposure time and sensitivity are those that were set."""
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
        """Return for each camera its sensor id, or an error record with the reason."""
        request = ConfirmSensorConfiguration.RequestIdRec(msg.request_id_rec.request_id)
        requested = requested_sensors(msg.visual_sensor_configuration_list, self._cameras)
        return ConfirmSensorConfiguration(request, [self._refusal(*each) or SensorIdRec(each[0]) for each in requested])

    def update_visual_sensor_configuration(self, msg: SetVisualSensorConfiguration) -> None:
        """Apply valid settings from the next picture on; omitted settings keep their values."""
        for sensor, record in requested_sensors(msg.visual_sensor_configuration_list, self._cameras, known_only=True):
            source = self._cameras[sensor].source
            settings, problems = requested_settings(record, source)
            if not problems:
                source.imaging = settings

    def _refusal(self, sensor: int, requested: _RequestedSettings) -> VisualSensorErrorRec | None:
        if sensor not in self._cameras:
            return VisualSensorErrorRec(sensor, Code.UNKNOWN_SENSOR_ID, f"there is no sensor {sensor}")
        _, problems = requested_settings(requested, self._cameras[sensor].source)
        if not problems:
            return None
        code = problems[0][0] if len(problems) == 1 else Code.MULTIPLE_INVALID_PARAMETERS
        return VisualSensorErrorRec(sensor, code, "; ".join(text for _, text in problems)[:255])

    def _name(self, sensor: int) -> str:
        return self._cameras[sensor].source.setup.name

    def _extended(self, sensor: int) -> _Ext:
        source = self._cameras[sensor].source
        narrowest, widest = fields_of_view(source)
        return _Ext(
            sensor,
            self._name(sensor),
            **capabilities(source.setup),
            imaging_modes=ReportVisualSensorCapabilitiesExt.ImagingModes(1, 1, 0, 0, 0, 0, 0, 0, 0),
            minimum_horizontal_field_of_view=narrowest,
            maximum_horizontal_field_of_view=widest,
            minimum_vertical_field_of_view=vertical(narrowest, source.settings),
            maximum_vertical_field_of_view=vertical(widest, source.settings),
        )

    def _configuration(self, sensor: int) -> _Configuration:
        return _Configuration(sensor, **reported_settings(self._cameras[sensor].source))
