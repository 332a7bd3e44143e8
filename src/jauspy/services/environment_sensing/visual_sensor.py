"""VisualSensor: lens, exposure and mounting of cameras (AS6060)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum, IntEnum
from typing import Any, Final, Protocol, TypeAlias, TypeVar

from jauspy.messages.environment_sensing.v1_0.types import (
    ExposureModes,
    FocusModes,
    LightSensitivityLevels,
    MeteringModes,
    SensorIdRec,
    SupportedStates,
    SupportedWhiteBalance,
    VisualSensorErrorRec,
    ZoomModes,
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
    ReportVisualSensorConfiguration as Report,
    SetVisualSensorConfiguration,
)
from jauspy.platform.camera import CameraSetup
from jauspy.platform.imaging_settings import (
    ISO_LEVELS,
    ExposureMode,
    FocusMode,
    ImagingMode,
    ImagingSettings,
    ImagingSetup,
    MeteringMode,
    WhiteBalance,
    ZoomMode,
    narrowed,
)
from jauspy.platform.video_settings import Still, StillSettings, VideoSettings
from jauspy.services.environment_sensing.sensors import MountedSensor, geometric_properties, requested_sensors
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

    @property
    def reduced(self) -> str:
        """A sentence for users about a camera for which the machine is too slow; else empty."""
        ...

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
                    imaging_modes=ReportVisualSensorCapabilities.ImagingModes(
                        color=1,
                        greyscale=1,
                        infrared=0,
                        lowlight=0,
                        thermal_white_hot=0,
                        thermal_black_hot=0,
                        thermal_rainbow=0,
                        reserved_for_future_use=0,
                    ),
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
        return ConfirmSensorConfiguration(
            request, [self._refusal(*request) or SensorIdRec(request[0]) for request in requested]
        )

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
            imaging_modes=ReportVisualSensorCapabilitiesExt.ImagingModes(
                color=1,
                greyscale=1,
                infrared=0,
                lowlight=0,
                thermal_white_hot=0,
                thermal_black_hot=0,
                thermal_rainbow=0,
                reserved_for_future_use=0,
                reserved_for_program_specific_use=0,
            ),
            minimum_horizontal_field_of_view=narrowest,
            maximum_horizontal_field_of_view=widest,
            minimum_vertical_field_of_view=vertical(narrowest, source.settings),
            maximum_vertical_field_of_view=vertical(widest, source.settings),
        )

    def _configuration(self, sensor: int) -> _Configuration:
        return _Configuration(sensor, **reported_settings(self._cameras[sensor].source))


Code: TypeAlias = VisualSensorErrorRec.VisualSensorErrorCode
Problem: TypeAlias = tuple[Code, str]
Requested: TypeAlias = SetVisualSensorConfiguration.VisualSensorConfigurationRec

ANGLE_TOLERANCE: Final = 1e-4
"""Radians by which a field of view may be beyond its limits, because it is rounded on the wire."""
SHUTTER_TOLERANCE: Final = 60.0 / 65535
"""Seconds: the step of exposure times on the wire."""
APERTURE_TOLERANCE: Final = 128.0 / 65535

EnumT = TypeVar("EnumT", bound=Enum)


class Source(Protocol):
    """Camera and settings that the fields describe."""

    @property
    def setup(self) -> CameraSetup:
        """The camera."""
        ...

    @property
    def settings(self) -> VideoSettings:
        """The size of its pictures."""
        ...

    @property
    def imaging(self) -> ImagingSettings:
        """The present settings."""
        ...


def capabilities(camera: CameraSetup) -> dict[str, Any]:
    """The fields of a report of capabilities, apart from imaging modes and fields of view."""
    setup = camera.imaging
    optical = setup.optical_zoom
    return {
        "supported_states": SupportedStates(1, 0, 0),
        "zoom_modes": ZoomModes(*_bits(ZoomMode, setup.zoom_modes)),
        "focus_modes": FocusModes(*_bits(FocusMode, FocusMode)),
        "white_balance": SupportedWhiteBalance(*_bits(WhiteBalance, WhiteBalance)),
        "exposure_modes": ExposureModes(*_bits(ExposureMode, setup.exposure_modes)),
        "metering_modes": MeteringModes(*_bits(MeteringMode, MeteringMode)),
        "minimum_shutter_speed": setup.exposure_time[0],
        "maximum_shutter_speed": setup.exposure_time[1],
        "minimum_aperture": setup.aperture[0],
        "maximum_aperture": setup.aperture[1],
        "minimum_focal_length": setup.focal_length(camera.fov),
        "maximum_focal_length": setup.focal_length(narrowed(camera.fov, optical)),
        "light_sensitivity_levels": LightSensitivityLevels(1, *_bits(ISO_LEVELS, setup.iso_levels)),
        "image_stabilization": 0,
    }


def _bits(every: Iterable[object], offered: Iterable[object]) -> Iterator[int]:
    found = list(offered)
    return (int(mode in found) for mode in every)


def fields_of_view(source: Source) -> tuple[float, float]:
    """The narrowest and the widest horizontal field of view, in radians, with any way of zooming."""
    setup, widest = source.setup.imaging, source.setup.fov
    return narrowed(widest, max(setup.max_zoom(mode) for mode in setup.zoom_modes)), widest


def vertical(horizontal: float, size: VideoSettings) -> float:
    """The vertical field of view, in radians, of pictures of that size."""
    return 2.0 * math.atan(math.tan(horizontal / 2.0) * size.height / size.width)


def reported_settings(source: Source) -> dict[str, Any]:
    """The fields of a report of the configuration."""
    setup, now = source.setup.imaging, source.imaging
    optical, digital = setup.zoom_factors(now)
    horizontal = narrowed(source.setup.fov, optical * digital)
    return {
        "sensor_state": Report.SensorState.ACTIVE,
        "zoom_mode": Report.ZoomMode[now.zoom_mode.name],
        "zoom_level": _level(optical * digital, setup.max_zoom(now.zoom_mode)),
        "focal_length": setup.focal_length(narrowed(source.setup.fov, optical)),
        "horizontal_field_of_view": horizontal,
        "vertical_field_of_view": vertical(horizontal, source.settings),
        "focus_mode": Report.FocusMode[now.focus_mode.name],
        "focus_value": 100.0 * now.focus,
        "white_balance": Report.WhiteBalance[now.white_balance.name],
        "imaging_mode": Report.ImagingMode[now.imaging_mode.name],
        "exposure_mode": Report.ExposureMode[now.exposure_mode.name],
        "metering_mode": Report.MeteringMode[now.metering_mode.name],
        "shutter_speed": now.shutter,
        "aperture": now.aperture,
        "light_sensitivity": _sensitivity_number(now.iso),
        "image_stabilization": Report.ImageStabilization.OFF,
    }


def _level(zoom: float, largest: float) -> float:
    """The zoom in percent from the widest to the narrowest; focal lengths change evenly."""
    return 100.0 * (zoom - 1.0) / (largest - 1.0) if largest > 1.0 else 0.0


def _sensitivity_number(iso: int | None) -> Report.LightSensitivity:
    return Report.LightSensitivity.AUTO if iso is None else Report.LightSensitivity[f"ISO_{iso}"]


def requested_settings(wanted: Requested, source: Source) -> tuple[ImagingSettings, list[Problem]]:
    """The present settings with the requested changes, and what of it the camera cannot do."""
    setup, problems = source.setup.imaging, list[Problem]()
    changed = source.imaging
    chosen: dict[str, Any] = {
        "zoom_mode": _chosen(Report.ZoomMode, wanted.zoom_mode, setup.zoom_modes, Code.INVALID_ZOOM_MODE, problems),
        "focus_mode": _chosen(Report.FocusMode, wanted.focus_mode, tuple(FocusMode), Code.INVALID_FOCUS_MODE, problems),
        "white_balance": _chosen(
            Report.WhiteBalance, wanted.white_balance, tuple(WhiteBalance), Code.INVALID_WHITE_BALANCE, problems
        ),
        "imaging_mode": _chosen(
            Report.ImagingMode, wanted.imaging_mode, tuple(ImagingMode), Code.INVALID_IMAGING_MODE, problems
        ),
        "exposure_mode": _chosen(
            Report.ExposureMode, wanted.exposure_mode, setup.exposure_modes, Code.INVALID_EXPOSURE_MODE, problems
        ),
        "metering_mode": _chosen(
            Report.MeteringMode, wanted.metering_mode, tuple(MeteringMode), Code.INVALID_METERING_MODE, problems
        ),
        "shutter": _within(
            wanted.shutter_speed,
            setup.exposure_time,
            SHUTTER_TOLERANCE,
            (Code.INVALID_SHUTTER_SPEED, "exposure times are {:g}..{:g} s"),
            problems,
        ),
        "aperture": _within(
            wanted.aperture,
            setup.aperture,
            APERTURE_TOLERANCE,
            (Code.INVALID_APERTURE_VALUE, "f-numbers are {:g}..{:g}"),
            problems,
        ),
        "focus": None if wanted.focus_value is None else wanted.focus_value / 100.0,
    }
    changed = replace(changed, **{name: value for name, value in chosen.items() if value is not None})
    if wanted.light_sensitivity is not None:
        changed = _sensitive(changed, wanted.light_sensitivity, setup, problems)
    if wanted.sensor_state not in {None, Report.SensorState.ACTIVE}:
        problems.append((Code.INVALID_SENSOR_STATE, "the camera is always active"))
    if wanted.image_stabilization not in {None, Report.ImageStabilization.OFF}:
        problems.append((Code.INVALID_IMAGE_STABILIZATION, "the camera cannot steady its image"))
    return _zoomed(changed, wanted, source, problems), problems


def _chosen(
    numbers: type[IntEnum],
    wanted: int | None,
    offered: tuple[EnumT, ...],
    code: Code,
    problems: list[Problem],
) -> EnumT | None:
    """The mode of that number; None if it is left out or not offered."""
    if wanted is None:
        return None
    name = next((number.name for number in numbers if number == wanted), "")
    found = next((mode for mode in offered if mode.name == name), None)
    if found is None:
        what = code.name.removeprefix("INVALID_").lower().replace("_", " ")
        problems.append((code, f"{what} can be {', '.join(mode.name for mode in offered)}"))
    return found


def _within(
    wanted: float | None,
    limits: tuple[float, float],
    tolerance: float,
    refusal: tuple[Code, str],
    problems: list[Problem],
) -> float | None:
    """The number, moved to a limit that it misses by rounding; None if it is left out or too far away."""
    low, high = limits
    if wanted is None:
        return None
    if not low - tolerance <= wanted <= high + tolerance:
        problems.append((refusal[0], refusal[1].format(low, high)))
        return None
    return min(max(wanted, low), high)


def _sensitive(now: ImagingSettings, wanted: int, setup: ImagingSetup, problems: list[Problem]) -> ImagingSettings:
    if wanted == Report.LightSensitivity.AUTO:
        return replace(now, iso=None)
    if not 1 <= wanted <= len(setup.iso_levels):
        levels = ", ".join(map(str, setup.iso_levels))
        problems.append((Code.INVALID_LIGHT_SENSITIVITY, f"sensitivities are AUTO and ISO {levels}"))
        return now
    return replace(now, iso=setup.iso_levels[wanted - 1])


def _zoomed(now: ImagingSettings, wanted: Requested, source: Source, problems: list[Problem]) -> ImagingSettings:
    """The settings with the zoom that the request asks for: in percent, or as focal length or field of view."""
    largest = source.setup.imaging.max_zoom(now.zoom_mode)
    asked = list(_asked_zooms(now, wanted, source))
    for zoom, code, name in asked:
        if not 1.0 - 1e-3 <= zoom <= largest * (1.0 + 1e-3):
            problems.append((code, f"{name} is out of range: zoom mode {now.zoom_mode.name} enlarges 1..{largest:g}"))
            return now
    for zoom, code, name in asked[1:]:
        if abs(zoom / asked[0][0] - 1.0) > 0.01:
            problems.append((code, f"{name} contradicts {asked[0][2]}"))
            return now
    zoom = asked[0][0] if asked else now.zoom
    return replace(now, zoom=min(max(zoom, 1.0), largest))


def _asked_zooms(now: ImagingSettings, wanted: Requested, source: Source) -> Iterator[tuple[float, Code, str]]:
    """Each field of the request that means a zoom, as factor, error code and name."""
    setup, size = source.setup.imaging, source.settings
    spread = math.tan(source.setup.fov / 2.0)
    for name, angle, extent, code in (
        ("horizontal_field_of_view", wanted.horizontal_field_of_view, 1.0, Code.INVALID_HORIZONTAL_FOV),
        ("vertical_field_of_view", wanted.vertical_field_of_view, size.width / size.height, Code.INVALID_VERTICAL_FOV),
    ):
        if angle is not None:
            yield (spread / (math.tan(angle / 2.0) * extent) if angle > ANGLE_TOLERANCE else math.inf), code, name
    if wanted.focal_length is not None:
        factor = wanted.focal_length / setup.focal_length(source.setup.fov)
        # With a digital zoom, the focal length says only what the lens does.
        if not _is_present(factor, setup.zoom_factors(now)[0]):
            yield factor, Code.INVALID_ZOOM_VALUE, "focal_length"
    if wanted.zoom_level is not None:
        largest = setup.max_zoom(now.zoom_mode)
        factor = 1.0 + wanted.zoom_level / 100.0 * (largest - 1.0)
        yield (factor if largest > 1.0 or wanted.zoom_level == 0.0 else math.inf), Code.INVALID_ZOOM_VALUE, "zoom_level"


def _is_present(factor: float, optical: float) -> bool:
    return abs(factor - optical) < 1e-3
