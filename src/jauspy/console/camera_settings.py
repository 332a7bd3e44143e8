"""Reads, describes and sets the settings of a camera and of the robot's lights, by the reported capabilities."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Awaitable, Iterable
from contextlib import AbstractAsyncContextManager, nullcontext
from dataclasses import dataclass, fields
from typing import Any, Final

from jauspy.console.languages import sentence
from jauspy.errors import JausError, RequestError
from jauspy.messages.environment_sensing.v2_0.digital_video import (
    QueryDigitalVideoSensorCapabilitiesExt,
    QueryDigitalVideoSensorConfiguration,
    SetDigitalVideoSensorConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.h264_video_encoding import (
    QueryH264VideoEncodingCapabilities,
    QueryH264VideoEncodingConfiguration,
    SetH264VideoEncodingConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
    ConfirmSensorConfiguration,
    QueryVisualSensorCapabilities,
    QueryVisualSensorConfiguration,
    SetVisualSensorConfiguration,
)
from jauspy.messages.ugv import QueryIlluminationConfiguration, QueryIlluminationState, SetIlluminationState
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.robot import ComponentClient
from jauspy.ocu.service import ServiceClient
from jauspy.platform.video_settings import FRAME_SIZES

VIDEO: Final = "DigitalVideo"
ENCODING: Final = "H264VideoEncoding"
LENS: Final = "VisualSensor"
LIGHTS: Final = "IlluminationService"
LIGHT_CHECKS: Final = 5
LIGHT_CHECK_INTERVAL: Final = 0.1
"""Seconds between two queries whether a light was switched: JAUS has no answer to a command that is ignored."""
VARIABLE_LEVELS: Final = 15
"""Highest level of a light that has levels."""

_Lens = SetVisualSensorConfiguration
_LENS_MODES: Final = (
    ("zoom_mode", sentence("zoom by"), "zoom_modes", _Lens.ZoomMode),
    ("focus_mode", sentence("focus"), "focus_modes", _Lens.FocusMode),
    ("exposure_mode", sentence("exposure"), "exposure_modes", _Lens.ExposureMode),
    ("metering_mode", sentence("metering"), "metering_modes", _Lens.MeteringMode),
    ("light_sensitivity", sentence("sensitivity"), "light_sensitivity_levels", _Lens.LightSensitivity),
    ("white_balance", sentence("white balance"), "white_balance", _Lens.WhiteBalance),
    ("imaging_mode", sentence("image"), "imaging_modes", _Lens.ImagingMode),
)
"""Field of the configuration, label, bit field of the capabilities, and the numbers, in the order of the bits."""
_PRESETS: Final = {0: sentence("low latency"), 1: sentence("slow connection"), 5: sentence("best quality")}


@dataclass(frozen=True, slots=True)
class Setting:
    """One setting: a choice if it has `choices`, otherwise a number between `low` and `high`."""

    service: str
    field: str
    label: str
    value: float | int | None
    choices: dict[int, str] | None = None
    low: float = 0.0
    high: float = 0.0
    step: float = 1.0
    unit: str = ""


async def read_settings(component: ComponentClient, sensor: int = 1) -> tuple[list[Setting], list[str]]:
    """The settings that the component offers for a sensor, with their present values; and what could not be read."""
    readers = ((VIDEO, _read_video), (ENCODING, _read_encoding), (LENS, _read_lens), (LIGHTS, _read_lights))
    offered = [(name, read) for name, read in readers if component.info.find(name)]
    found = await asyncio.gather(*(_tried(read(component.service(name), sensor)) for name, read in offered))
    return [setting for settings, _ in found for setting in settings], [said for _, said in found if said]


async def _tried(reading: Awaitable[list[Setting]]) -> tuple[list[Setting], str]:
    try:
        return await reading, ""
    except JausError as error:
        return [], str(error)


async def sensor_name(component: ComponentClient, sensor: int = 1) -> str:
    """The reported name of the sensor; the component's name if there is none."""
    if component.info.find(LENS):
        record = QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec(sensor, 0)
        report = await component.service(LENS).query(QueryVisualSensorCapabilities([record]))
        for capabilities in report.visual_sensor_capabilities_list:
            if str(capabilities.sensor_name):
                return str(capabilities.sensor_name)
    return component.info.name


async def write_setting(
    component: ComponentClient, setting: Setting, value: float, sensor: int = 1, authority: int = DEFAULT_AUTHORITY
) -> None:
    """Write a setting; control of the component is taken for this, unless it is held.

    Raises `JausError` with the reason.
    """
    service = component.service(setting.service)
    control: AbstractAsyncContextManager[Any] = nullcontext()
    if not component.is_controlled:
        control = service.control(authority)
    async with control:
        if setting.service == LIGHTS:
            await _switch_light(service, setting.field, round(value))
        else:
            await _configure(service, _request(setting, value, sensor))


def _request(setting: Setting, value: float, sensor: int) -> Any:
    number: Any = value if setting.service == LENS and setting.choices is None else round(value)
    if setting.service == VIDEO:
        video = SetDigitalVideoSensorConfiguration
        both: dict[str, Any] = {"minimum_bit_rate": number, "maximum_bit_rate": number}
        values = both if setting.field == "maximum_bit_rate" else {setting.field: number}
        return video(video.RequestIdRec(1), [video.DigitalVideoSensorConfigurationRec(sensor, **values)])
    if setting.service == ENCODING:
        coding = SetH264VideoEncodingConfiguration
        record = coding.H264ConfigurationRec(sensor, **{setting.field: number})
        return coding(coding.RequestIdRec(1), [coding.H264ConfigurationSequence(record)])
    return _Lens(_Lens.RequestIdRec(1), [_Lens.VisualSensorConfigurationRec(sensor, **{setting.field: number})])


async def _configure(service: ServiceClient, request: Any) -> None:
    answer = await service.query(request, expects=ConfirmSensorConfiguration)
    for confirmation in answer.confirm_sensor_list:
        if (said := getattr(confirmation, "error_message", None)) is not None:
            raise RequestError(sentence("{service} refuses that: {said}", service=service.id, said=said))


async def _switch_light(service: ServiceClient, name: str, level: int) -> None:
    report = await service.query(QueryIlluminationState())
    kind = SetIlluminationState.Illumination
    present = {field.name: getattr(report.illumination, field.name) for field in fields(kind)}
    await service.send(SetIlluminationState(kind(**{**present, name: level})), ack=True)
    for _ in range(LIGHT_CHECKS):
        report = await service.query(QueryIlluminationState())
        if getattr(report.illumination, name) == level:
            return
        await asyncio.sleep(LIGHT_CHECK_INTERVAL)
    raise RequestError(
        sentence(
            "{service} did not switch {name}; some robots do so in the state READY only",
            service=service.id,
            name=name.replace("_", " "),
        )
    )


async def _rows(service: ServiceClient, *queries: Any) -> list[Any]:
    """The first record of the list in each report; None where it is empty."""
    reports = await asyncio.gather(*(service.query(query) for query in queries))
    lists = (next(value for value in _values(report) if isinstance(value, list)) for report in reports)
    return [next(iter(sensors), None) for sensors in lists]


def _values(report: Any) -> Iterable[Any]:
    """The values of the fields of a message."""
    return (getattr(report, field.name) for field in fields(report))


async def _read_video(service: ServiceClient, sensor: int) -> list[Setting]:
    able, now = QueryDigitalVideoSensorCapabilitiesExt, QueryDigitalVideoSensorConfiguration
    can, is_now = await _rows(
        service,
        able([able.QueryDigitalVideoSensorCapabilitiesRec(sensor, 0xFF)]),
        now([now.QueryDigitalVideoConfigurationRec(sensor, 0xFF)]),
    )
    if can is None or is_now is None:
        return []
    found = []
    if can.supported_frame_sizes is not None:
        sizes = dict(zip(FRAME_SIZES, _bits(can.supported_frame_sizes), strict=False))
        pixels = {int(size): FRAME_SIZES[size] for size, offered in sizes.items() if offered}
        ordered = sorted(pixels, key=lambda size: (math.prod(pixels[size]), size))
        choices = {size: "{} x {}".format(*pixels[size]) for size in ordered}
        found.append(Setting(VIDEO, "frame_size", sentence("size"), is_now.frame_size, choices))
    if can.maximum_frame_rate:
        low, high = can.minimum_frame_rate or 1, can.maximum_frame_rate
        found.append(
            Setting(
                VIDEO,
                "frame_rate",
                sentence("pictures"),
                is_now.frame_rate,
                None,
                low=low,
                high=high,
                step=1,
                unit="/s",
            )
        )
    if can.maximum_bit_rate:
        low, high = can.minimum_bit_rate or 0, can.maximum_bit_rate
        rates = {rate: f"{rate / 1000:g} Mbit/s" for rate in (100, 250, 500, 1000, 2000, 4000, 8000, 16000, 32000)}
        offered_rates = {rate: text for rate, text in rates.items() if low <= rate <= high}
        if (present := is_now.maximum_bit_rate) is not None:
            offered_rates.setdefault(present, f"{present / 1000:g} Mbit/s")
        found.append(
            Setting(VIDEO, "maximum_bit_rate", sentence("bit rate"), present, dict(sorted(offered_rates.items())))
        )
    return found


async def _read_encoding(service: ServiceClient, sensor: int) -> list[Setting]:
    able, now = QueryH264VideoEncodingCapabilities, QueryH264VideoEncodingConfiguration
    can, is_now = await _rows(
        service,
        able([able.QueryH264VideoEncodingRec(sensor)]),
        now([now.QueryH264VideoEncodingRec(sensor)]),
    )
    presets = getattr(can, "supported_presets", None)
    if presets is None or is_now is None:
        return []
    offered = [number for number, bit in enumerate(_bits(presets)) if bit]
    names = SetH264VideoEncodingConfiguration.Preset
    known = {int(name): name.name.lower().replace("_", " ") for name in names} | _PRESETS
    choices = {number: known[number] for number in offered if number in known}
    record = getattr(is_now, "h264_configuration_rec", is_now)
    return [Setting(ENCODING, "preset", sentence("quality"), record.preset, choices)]


async def _read_lens(service: ServiceClient, sensor: int) -> list[Setting]:
    able, now = QueryVisualSensorCapabilities, QueryVisualSensorConfiguration
    can, is_now = await _rows(
        service,
        able([able.QueryVisualSensorCapabilitiesRec(sensor, 0xFFFF)]),
        now([now.QueryVisualSensorConfigurationRec(sensor, 0xFFFF)]),
    )
    if can is None or is_now is None:
        return []
    found = []
    for field, label, bits, numbers in _LENS_MODES:
        offered = getattr(can, bits, None)
        if offered is not None:
            names = {int(number): number.name.lower().replace("_", " ") for number in numbers}
            able_to = dict(zip(names, _bits(offered), strict=False))
            choices = {number: name for number, name in names.items() if able_to.get(number)}
            found.append(Setting(LENS, field, label, getattr(is_now, field), choices))
    if is_now.zoom_level is not None and is_now.zoom_mode != _Lens.ZoomMode.OFF:
        found.insert(
            0, Setting(LENS, "zoom_level", sentence("zoom"), is_now.zoom_level, None, low=0, high=100, step=1, unit="%")
        )
    if is_now.focus_value is not None and is_now.focus_mode == _Lens.FocusMode.MANUAL_FOCUS:
        found.append(
            Setting(
                LENS,
                "focus_value",
                sentence("focus, near to far"),
                is_now.focus_value,
                None,
                low=0,
                high=100,
                step=1,
                unit="%",
            )
        )
    exposure = _Lens.ExposureMode
    if can.maximum_shutter_speed and is_now.exposure_mode in (exposure.MANUAL, exposure.SHUTTER_PRIORITY):
        low, high = can.minimum_shutter_speed or 0.0, can.maximum_shutter_speed
        found.append(
            Setting(
                LENS,
                "shutter_speed",
                sentence("exposure time"),
                is_now.shutter_speed,
                None,
                low=low,
                high=high,
                step=0.001,
                unit="s",
            )
        )
    if can.maximum_aperture and is_now.exposure_mode in (exposure.MANUAL, exposure.APERTURE_PRIORITY):
        low, high = can.minimum_aperture or 0.0, can.maximum_aperture
        if high > low:
            found.append(
                Setting(
                    LENS,
                    "aperture",
                    sentence("aperture"),
                    is_now.aperture,
                    None,
                    low=low,
                    high=high,
                    step=0.1,
                    unit="f",
                )
            )
    return [setting for setting in found if setting.choices is None or len(setting.choices) > 1]


async def _read_lights(service: ServiceClient, _: int) -> list[Setting]:
    can, is_now = await asyncio.gather(
        service.query(QueryIlluminationConfiguration()), service.query(QueryIlluminationState())
    )
    types, state = next(iter(_values(can))), is_now.illumination
    found = []
    for field in fields(type(state)):
        if field.name.startswith("reserved") or not getattr(types, field.name, 0):
            continue
        label = field.name.replace("_", " ").replace("light1", "light 1").replace("ir ", "infrared ")
        value = int(getattr(state, field.name))
        if field.name.startswith("variable"):
            found.append(Setting(LIGHTS, field.name, label, value, None, low=0, high=VARIABLE_LEVELS))
        else:
            found.append(Setting(LIGHTS, field.name, label, value, {0: sentence("off"), 1: sentence("on")}))
    return found


def _bits(field: Any) -> list[int]:
    """The bits of a bit field in their order, without those that are reserved."""
    return [int(getattr(field, bit.name)) for bit in fields(field) if not bit.name.startswith("reserved")]
