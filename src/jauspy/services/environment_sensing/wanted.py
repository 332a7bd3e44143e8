"""Which sensors a query or command is about."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Final, Protocol, TypeVar

ALL_SENSORS: Final = 0
"""The id that stands for all sensors."""

MAX_SENSORS: Final = 64
"""Sensors that one answer is about: a query may name 65535, and one of them may be all of them."""


class SensorRecord(Protocol):
    """What a query says of a sensor."""

    @property
    def sensor_id(self) -> int:
        """Its id, or 0 for all."""
        ...


RecordT = TypeVar("RecordT", bound=SensorRecord)


def requested_sensors(
    records: Sequence[RecordT], sensors: Collection[int], *, known_only: bool = False
) -> list[tuple[int, RecordT]]:
    """Each sensor that is asked for, once, with the first record about it; unknown ones too unless `known_only`."""
    found: dict[int, RecordT] = {}
    for record in records:
        for sensor in sensors if record.sensor_id == ALL_SENSORS else (record.sensor_id,):
            if sensor in sensors or not known_only:
                found.setdefault(sensor, record)
        if len(found) >= MAX_SENSORS:
            break
    return list(found.items())[:MAX_SENSORS]
