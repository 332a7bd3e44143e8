"""Time stamps of reports, in UTC."""

from __future__ import annotations

from datetime import datetime

from jauspy.messages.core import DateStamp, TimeStamp


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
