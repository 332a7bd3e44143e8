"""Lens, shutter and sensor of cameras: capabilities, and the settings of clients.

Light is linear: twice the exposure is twice the light. Pixels are its square root, as displays expect (gamma 2).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Final, TypeAlias

from annotated_types import Ge, Interval, Le

from jauspy.platform.tables import Converted, Seed, Table

NORMAL_TIME: Final = 0.01
"""Seconds of exposure that, at ISO 100 and the widest aperture, show a scene in daylight as it is rendered."""

ISO_LEVELS: Final = (100, 200, 400, 800, 1600, 3200)
"""Sensitivities that JAUS defines."""


class ZoomMode(Enum):
    """Means of zooming: the lens, computation, or both."""

    MIXED = "mixed"
    ANALOG_ONLY = "analog"
    DIGITAL_ONLY = "digital"
    OFF = "off"


class FocusMode(Enum):
    """Focus by hand or automatic. With autofocus everything is sharp."""

    AUTO_FOCUS = "auto"
    MANUAL_FOCUS = "manual"


class WhiteBalance(Enum):
    """The kind of light that is shown as white. Scenes have daylight, which AUTO finds."""

    AUTO = "auto"
    DAYLIGHT = "daylight"
    CLOUDY = "cloudy"
    SHADE = "shade"
    TUNGSTEN = "tungsten"
    FLUORESCENT = "fluorescent"
    FLASH = "flash"


class ImagingMode(Enum):
    """Colour or grey."""

    COLOR = "colour"
    GREYSCALE = "greyscale"


class ExposureMode(Enum):
    """Automatic parts of the exposure. The sensitivity is automatic besides, unless it is set."""

    AUTO = "auto"
    MANUAL = "manual"
    SHUTTER_PRIORITY = "shutter"
    APERTURE_PRIORITY = "aperture"


class MeteringMode(Enum):
    """The part of the picture that the automatic exposure measures."""

    AUTO = "auto"
    CENTER_WEIGHTED = "centre"
    SPOT = "spot"


def _metres(millimetres: float) -> float:
    return millimetres / 1000.0


_Coefficient: TypeAlias = Annotated[float, Interval(ge=-10.0, le=10.0)]


@dataclass(frozen=True, slots=True)
class ImagingSetup(Table):
    """Capabilities of one camera, and imperfections of its lens and sensor: the table `imaging`."""

    optical_zoom: Annotated[float, Interval(ge=1.0, le=50.0)] = 1.0
    """Largest factor of the lens; 1 for a fixed focal length."""
    digital_zoom: Annotated[float, Interval(ge=1.0, le=16.0)] = 4.0
    """Largest factor of the digital zoom; 1 for none."""
    exposure_time: tuple[Annotated[float, Ge(0.0001)], Annotated[float, Le(60.0)]] = (0.001, 0.066)
    """Shortest and longest, in seconds."""
    aperture: tuple[Annotated[float, Ge(0.7)], Annotated[float, Le(128.0)]] = (2.8, 2.8)
    """Smallest and largest f-number."""
    max_iso: Annotated[int, Interval(ge=100, le=3200)] = 3200
    sensor_width: Annotated[float, Interval(ge=1.0, le=50.0), Converted(_metres)] = 0.0064
    """Metres (millimetres in the file); with the field of view it determines focal length and depth of field."""
    nearest_focus: Annotated[float, Interval(ge=0.01, le=10.0)] = 0.1
    """Metres."""
    distortion: tuple[_Coefficient, _Coefficient, _Coefficient, _Coefficient, _Coefficient] = (0.0, 0.0, 0.0, 0.0, 0.0)
    """k1, k2, p1, p2, k3 of OpenCV's model; zero bends nothing."""
    shot_noise: Annotated[float, Interval(ge=0.0, le=0.5)] = 0.0035
    """Standard deviation of the light of a white pixel at ISO 100, as a fraction; that of a darker one goes with the
    root of its light."""
    read_noise: Annotated[float, Interval(ge=0.0, le=0.5)] = 0.0002
    """Standard deviation at ISO 100 in black, as a fraction of white."""
    seed: Seed = 0
    """Seed of the noise: the same seed gives the same noise."""

    def __post_init__(self) -> None:
        for key, (low, high) in (("exposure_time", self.exposure_time), ("aperture", self.aperture)):
            if low > high:
                raise ValueError(f"{key}: [{low}, {high}] is empty; give the least and then the largest")

    @property
    def zoom_modes(self) -> tuple[ZoomMode, ...]:
        """The modes that the camera offers."""
        found = [ZoomMode.OFF]
        if self.digital_zoom > 1.0:
            found.append(ZoomMode.DIGITAL_ONLY)
        if self.optical_zoom > 1.0:
            found.append(ZoomMode.ANALOG_ONLY)
        if len(found) > 2:
            found.append(ZoomMode.MIXED)
        return tuple(found)

    @property
    def exposure_modes(self) -> tuple[ExposureMode, ...]:
        """The modes that the camera offers: priority of the aperture only if it can be changed."""
        fixed = self.aperture[0] == self.aperture[1]
        return tuple(mode for mode in ExposureMode if not (fixed and mode is ExposureMode.APERTURE_PRIORITY))

    @property
    def iso_levels(self) -> tuple[int, ...]:
        """The sensitivities that the camera offers."""
        return tuple(level for level in ISO_LEVELS if level <= self.max_iso)

    @property
    def initial(self) -> ImagingSettings:
        """The settings until a client changes them: everything is automatic, and nothing is enlarged."""
        return ImagingSettings(zoom_mode=self.zoom_modes[-1], aperture=self.aperture[0])

    def max_zoom(self, mode: ZoomMode) -> float:
        """The largest factor in that mode."""
        return (self.optical_zoom if mode in (ZoomMode.MIXED, ZoomMode.ANALOG_ONLY) else 1.0) * (
            self.digital_zoom if mode in (ZoomMode.MIXED, ZoomMode.DIGITAL_ONLY) else 1.0
        )

    def zoom_factors(self, settings: ImagingSettings) -> tuple[float, float]:
        """The factors of the lens and of the enlargement; the lens comes first."""
        zoom = min(settings.zoom, self.max_zoom(settings.zoom_mode))
        optical = min(zoom, self.optical_zoom) if settings.zoom_mode is not ZoomMode.DIGITAL_ONLY else 1.0
        return optical, zoom / optical

    def focal_length(self, fov: float) -> float:
        """Focal length in metres, for a horizontal field of view in radians."""
        return self.sensor_width / 2.0 / math.tan(fov / 2.0)

    def exposures(self, settings: ImagingSettings) -> tuple[float, float]:
        """Smallest and largest exposure that the automatic may choose, as factors of the normal one; equal in MANUAL.

        In MANUAL with an automatic sensitivity, that of ISO 100 is taken.
        """
        times, sensitivities = self.exposure_time, (1.0, self.max_iso / ISO_LEVELS[0])
        number = settings.aperture if settings.exposure_mode in _SETS_APERTURE else self.aperture[0]
        if settings.exposure_mode in (ExposureMode.MANUAL, ExposureMode.SHUTTER_PRIORITY):
            times = (settings.shutter, settings.shutter)
        if settings.iso is not None:
            sensitivities = (settings.iso / ISO_LEVELS[0],) * 2
        elif settings.exposure_mode is ExposureMode.MANUAL:
            sensitivities = (1.0, 1.0)
        light = (self.aperture[0] / number) ** 2 / NORMAL_TIME
        return light * times[0] * sensitivities[0], light * times[1] * sensitivities[1]

    def gain(self, settings: ImagingSettings, exposure: float) -> float:
        """The amplification, 1 at ISO 100, of an exposure of `exposures`: the automatic exposes longer first."""
        if settings.iso is not None:
            return settings.iso / ISO_LEVELS[0]
        if settings.exposure_mode is ExposureMode.MANUAL:
            return 1.0
        longest = settings.shutter if settings.exposure_mode is ExposureMode.SHUTTER_PRIORITY else self.exposure_time[1]
        number = settings.aperture if settings.exposure_mode in _SETS_APERTURE else self.aperture[0]
        return max(1.0, exposure * NORMAL_TIME / longest * (number / self.aperture[0]) ** 2)


@dataclass(frozen=True, slots=True, kw_only=True)
class ImagingSettings:
    """The settings of a client."""

    zoom_mode: ZoomMode = ZoomMode.OFF
    zoom: float = 1.0
    """Factor by which things are larger than with the widest field of view."""
    focus_mode: FocusMode = FocusMode.AUTO_FOCUS
    focus: float = 1.0
    """0 is the nearest distance, 1 is infinity; its reciprocal distance changes evenly between them."""
    white_balance: WhiteBalance = WhiteBalance.AUTO
    imaging_mode: ImagingMode = ImagingMode.COLOR
    exposure_mode: ExposureMode = ExposureMode.AUTO
    metering_mode: MeteringMode = MeteringMode.AUTO
    shutter: float = NORMAL_TIME
    """Seconds, in MANUAL and SHUTTER_PRIORITY."""
    aperture: float = 2.8
    """F-number, in MANUAL and APERTURE_PRIORITY."""
    iso: int | None = None
    """None: automatic."""


_SETS_APERTURE: Final = (ExposureMode.MANUAL, ExposureMode.APERTURE_PRIORITY)

IDEAL: Final = ImagingSetup(shot_noise=0.0, read_noise=0.0)
"""A lens and a sensor without faults."""


def narrowed(fov: float, factor: float) -> float:
    """The field of view, in radians, in which things are larger by `factor`."""
    return 2.0 * math.atan(math.tan(fov / 2.0) / factor)
