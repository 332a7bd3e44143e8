"""Still images of a component's cameras (Still Image service, AS6060)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what was asked, and of whom

from __future__ import annotations

import asyncio
from contextlib import AbstractAsyncContextManager, nullcontext
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any, Final

from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v1_0.types import StillImageSensorErrorRec
from jauspy.messages.environment_sensing.v2_0.still_image import (
    QueryStillImageDataExt,
    QueryStillImageSensorConfiguration,
    ReportStillImageDataExt,
    ReportStillImageSensorConfiguration,
    SetStillImageSensorConfiguration,
)
from jauspy.messages.environment_sensing.v2_0.visual_sensor import ConfirmSensorConfiguration
from jauspy.ocu.connection import Connection, RetryPolicy
from jauspy.ocu.control import DEFAULT_AUTHORITY, Control
from jauspy.ocu.state import datetime_of
from jauspy.platform.video_settings import FRAME_SIZES, MAX_IMAGE_REPORT, frame_size
from jauspy.protocol.delivery import Delivery

Configuration = ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec

LARGE_IMAGE_DELIVERY: Final = Delivery(max_message=MAX_IMAGE_REPORT)
"""Delivery settings of an OCU that requests large images: by default messages have up to 1 MiB."""
FORMATS: Final = ReportStillImageSensorConfiguration.StillImageFormat
ALL_FIELDS: Final = 0xFF
"""Presence vector of a query for all fields."""
QUERIES_PER_TIMEOUT: Final = 4
"""Times that the image is queried within the timeout."""
CAMERA_WAIT: Final = 2.0
"""Seconds; a component that takes longer to report no image has waited for its camera, and is queried again."""


@dataclass(frozen=True, slots=True)
class Photo:
    """An image as the content of a file; `format` is the format's name in JAUS (JPEG, PNG), `taken` the time in UTC."""

    content: bytes
    format: str
    sensor: int
    taken: datetime | None


async def take_photo(connection: Connection, id: JausID, wanted: Configuration, timeout: float) -> Photo:
    """Take a still image; if necessary, the camera is configured for it, and restored afterwards."""
    sensor = wanted.sensor_id
    before = await _query_configuration(connection, id, sensor)
    if all(getattr(wanted, name) in (None, getattr(before, name)) for name in ("frame_size", "still_image_format")):
        return await _query_image(connection, id, sensor, timeout)
    control: AbstractAsyncContextManager[Any] = nullcontext()
    if id not in connection.controls:
        control = Control(connection, id, DEFAULT_AUTHORITY, connection.retry)
    async with control:
        await _configure(connection, id, wanted)
        try:
            return await _query_image(connection, id, sensor, timeout)
        finally:
            await _configure(connection, id, before)


def configuration(sensor: int, size: tuple[int, int] | None, format: str | None) -> Configuration:
    """The configuration as JAUS has it, where None stays as it is; `ConfigError` lists the possible values."""
    number = frame_size(*size) if size else None
    if size and number is None:
        known = ", ".join(f"{width}x{height}" for width, height in sorted(set(FRAME_SIZES.values())))
        raise ConfigError(f"JAUS has no images of {size[0]}x{size[1]}; the sizes are {known}")
    if format is not None and format.upper() not in FORMATS.__members__:
        raise ConfigError(f"JAUS has no image format {format!r}; there are {', '.join(FORMATS.__members__)}")
    return Configuration(sensor, number, FORMATS[format.upper()] if format else None)


async def _query_configuration(connection: Connection, id: JausID, sensor: int) -> Configuration:
    record = QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec(sensor, ALL_FIELDS)
    report = await connection.query(id, QueryStillImageSensorConfiguration([record]))
    assert isinstance(report, ReportStillImageSensorConfiguration)
    if not report.still_image_sensor_configuration_list:
        raise RequestError(f"{id} has no sensor {sensor}")
    return report.still_image_sensor_configuration_list[0]


async def _configure(connection: Connection, id: JausID, wanted: Configuration) -> None:
    kind = SetStillImageSensorConfiguration
    record = kind.StillImageSensorConfigurationRec(wanted.sensor_id, wanted.frame_size, wanted.still_image_format)
    answer = await connection.query(id, kind(kind.RequestIdRec(1), [record]), expects=ConfirmSensorConfiguration)
    assert isinstance(answer, ConfirmSensorConfiguration)
    for confirmation in answer.confirm_sensor_list:
        if isinstance(confirmation, StillImageSensorErrorRec):
            raise RequestError(f"{id} refuses that for sensor {confirmation.sensor_id}: {confirmation.error_message}")


async def _query_image(connection: Connection, id: JausID, sensor: int, timeout: float) -> Photo:
    record = QueryStillImageDataExt.QueryStillImageDataRec(
        sensor, QueryStillImageDataExt.ReportCoordinateSystem.NATIVE, ALL_FIELDS
    )
    query, clock = QueryStillImageDataExt([record]), asyncio.get_running_loop().time
    end = clock() + timeout
    too_late = ResponseTimeout(
        f"{id} sent no picture of sensor {sensor} in {timeout:g} s: its camera may still be starting, or "
        "its machine be busy; ask again, or allow more time"
    )
    while (queried_at := clock()) < end:
        # Fragments get lost. When the query is sent again while the image is under way, the camera takes no second one.
        retry = RetryPolicy((end - queried_at) / QUERIES_PER_TIMEOUT, QUERIES_PER_TIMEOUT - 1)
        try:
            report = await connection.query(id, query, retry=retry)
        except ResponseTimeout as error:
            raise too_late from error
        assert isinstance(report, ReportStillImageDataExt)
        if (photo := _photo(report)) is not None:
            return photo
        if clock() - queried_at < CAMERA_WAIT:
            raise RequestError(
                f"{id} has no picture of sensor {sensor}: there is no such sensor, too much is asked of it, or "
                "its robot has no extra 'video'; see the robot's log"
            )
    raise too_late


def _photo(report: ReportStillImageDataExt) -> Photo | None:
    for picture in report.still_image_data_list:
        if picture.image_frame is not None:
            number = picture.image_frame.format
            taken = None if picture.time_stamp is None else datetime_of(picture.time_stamp, datetime.now(UTC))
            return Photo(picture.image_frame.data, getattr(number, "name", str(number)), picture.sensor_id, taken)
    return None
