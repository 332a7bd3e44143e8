"""Still images of a component's cameras (AS6060 StillImage)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
from contextlib import AbstractAsyncContextManager, nullcontext
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.messages.core import TimeStamp
from jauspy.messages.environment_sensing.v1_0.types import StillImageSensorErrorRec
from jauspy.messages.environment_sensing.v2_0.still_image import (
    QueryStillImageDataExt,
    QueryStillImageSensorConfiguration,
    ReportStillImageDataExt,
    ReportStillImageSensorConfiguration,
    SetStillImageSensorConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.ocu.connection import Connection
from jauspy.platform.stills import MAX_REPORT
from jauspy.protocol.delivery import Delivery
from jauspy.services.environment_sensing.frame_sizes import SIZES, number_of

if TYPE_CHECKING:
    from jauspy.ocu.service import ServiceClient

Configuration = ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec

LARGE_IMAGE_DELIVERY: Final = Delivery(max_message=MAX_REPORT)
"""For an OCU that wants large pictures: by default messages have up to 1 MiB."""

FORMATS: Final = ReportStillImageSensorConfiguration.StillImageFormat
ALL_FIELDS: Final = 0xFF
IMAGE_QUERIES: Final = 4
CAMERA_WAIT: Final = 2.0
"""Seconds; who says later than this that there is no picture has waited for one, and may have it when asked again."""


@dataclass(frozen=True, slots=True)
class Photo:
    """A picture as a file's content; `format` as JAUS calls it (JPEG, PNG); `taken`: time of day, UTC."""

    content: bytes
    format: str
    sensor: int
    taken: TimeStamp | None


async def photograph(link: Connection, service: ServiceClient, wanted: Configuration, timeout: float) -> Photo:
    """As `ServiceClient.still`."""
    sensor = wanted.sensor_id
    before = await _configuration(service, sensor)
    if all(getattr(wanted, name) in (None, getattr(before, name)) for name in ("frame_size", "still_image_format")):
        return await _taken(service, sensor, timeout)
    control: AbstractAsyncContextManager[Any] = nullcontext() if service.id in link.controls else service.control()
    async with control:
        await _set(service, wanted)
        try:
            return await _taken(service, sensor, timeout)
        finally:
            await _set(service, before)


def configuration(sensor: int, size: tuple[int, int] | None, format: str | None) -> Configuration:
    """Settings as JAUS has them; `ConfigError` lists what there is. None stays as it is."""
    number = number_of(*size) if size else None
    if size and number is None:
        known = ", ".join(f"{width}x{height}" for width, height in sorted(set(SIZES.values())))
        raise ConfigError(f"JAUS has no images of {size[0]}x{size[1]}; the sizes are {known}")
    if format is not None and format.upper() not in FORMATS.__members__:
        raise ConfigError(f"JAUS has no image format {format!r}; there are {', '.join(FORMATS.__members__)}")
    return Configuration(sensor, number, FORMATS[format.upper()] if format else None)


async def _configuration(service: ServiceClient, sensor: int) -> Configuration:
    record = QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec(sensor, ALL_FIELDS)
    report = await service.query(QueryStillImageSensorConfiguration([record]))
    if not report.still_image_sensor_configuration_list:
        raise RequestError(f"{service.id} has no sensor {sensor}")
    return report.still_image_sensor_configuration_list[0]


async def _set(service: ServiceClient, wanted: Configuration) -> None:
    kind = SetStillImageSensorConfiguration
    record = kind.StillImageSensorConfigurationRec(wanted.sensor_id, wanted.frame_size, wanted.still_image_format)
    answer = await service.query(kind(kind.RequestIdRec(1), [record]), expects=ConfirmSensorConfiguration)
    for each in answer.confirm_sensor_list:
        if isinstance(each, StillImageSensorErrorRec):
            raise RequestError(f"{service.id} refuses that for sensor {each.sensor_id}: {each.error_message}")


async def _taken(service: ServiceClient, sensor: int, timeout: float) -> Photo:
    record = QueryStillImageDataExt.QueryStillImageDataRec(
        sensor, QueryStillImageDataExt.ReportCoordinateSystem.NATIVE, ALL_FIELDS
    )
    query, clock = QueryStillImageDataExt([record]), asyncio.get_running_loop().time
    end = clock() + timeout
    late = ResponseTimeout(
        f"{service.id} sent no picture of sensor {sensor} in {timeout:g} s: its camera may still be starting, or "
        "its machine be busy; ask again, or allow more time"
    )
    while (began := clock()) < end:
        # Pieces get lost. Asked again while the picture is under way, the camera takes no second one.
        try:
            report = await service.query(query, timeout=(end - began) / IMAGE_QUERIES, retries=IMAGE_QUERIES - 1)
        except ResponseTimeout as error:
            raise late from error
        if (photo := _photo(report)) is not None:
            return photo
        if clock() - began < CAMERA_WAIT:
            raise RequestError(
                f"{service.id} has no picture of sensor {sensor}: there is no such sensor, too much is asked of it, or "
                "its robot has no extra 'video'; the robot's log tells"
            )
    raise late


def _photo(report: ReportStillImageDataExt) -> Photo | None:
    for each in report.still_image_data_list:
        if each.image_frame is not None:
            number = each.image_frame.format
            return Photo(each.image_frame.data, getattr(number, "name", str(number)), each.sensor_id, each.time_stamp)
    return None
