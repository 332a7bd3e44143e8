"""Efforts in percent, as messages carry them."""

from __future__ import annotations

from datetime import datetime
from typing import Final

from jauspy.messages.core import DateStamp, TimeStamp
from jauspy.platform.vectors import Transform, X, Y, Z, scaled

STEP: Final = 200.0 / 65535.0
"""Of a percentage from -100 to 100 in 16 bits. Zero lies between two steps: it arrives half a step off."""


def percent(value: float | None) -> float:
    """An effort that a message holds; zero when it was meant to be, or was left out."""
    return 0.0 if value is None or abs(value) < STEP else value


def time_stamp(at: datetime) -> TimeStamp:
    """Day of the month and time of day, to the millisecond."""
    return TimeStamp(
        milliseconds=at.microsecond // 1000, seconds=at.second, minutes=at.minute, hour=at.hour, day=at.day
    )


def date_stamp(at: datetime) -> DateStamp:
    """The date; JAUS counts years from 2000."""
    return DateStamp(day=at.day, month=at.month, year=at.year - 2000)


def epoch_seconds(at: datetime) -> tuple[int, int] | tuple[None, None]:
    """Whole seconds since 1970, and the nanoseconds after them; a client may set a year that 32 bits do not reach."""
    seconds = int(at.timestamp())
    return (seconds, at.microsecond * 1000) if 0 <= seconds <= 0xFFFFFFFF else (None, None)


JAUS_FROM_REP_103: Final = Transform((X, scaled(Y, -1.0), scaled(Z, -1.0)))
"""A half turn about x; its own inverse. It takes the frame of a vehicle, and that of a sensor on it, to JAUS's."""


def jaus_frame(frame: Transform) -> Transform:
    """A frame in another one, when both are turned to JAUS's axes; its own inverse."""
    return JAUS_FROM_REP_103 @ frame @ JAUS_FROM_REP_103
