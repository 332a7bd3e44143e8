"""Conversions to values of messages: efforts in percent, time stamps in UTC, texts in Latin-1."""

from __future__ import annotations

from datetime import datetime
from typing import Final

from jauspy.messages.core import DateStamp, TimeStamp

PERCENT_STEP: Final = 200.0 / 65535.0
"""Step of a percentage from -100 to 100 in 16 bits. Zero lies between two steps and so is received half a step off."""


def effort_or_zero(value: float | None) -> float:
    """An effort from a message, -100..100; 0.0 when it is within one step of zero, or left out."""
    return 0.0 if value is None or abs(value) < PERCENT_STEP else value


def time_stamp(moment: datetime) -> TimeStamp:
    """Day of the month and time of day, to the millisecond."""
    return TimeStamp(
        milliseconds=moment.microsecond // 1000,
        seconds=moment.second,
        minutes=moment.minute,
        hour=moment.hour,
        day=moment.day,
    )


def date_stamp(moment: datetime) -> DateStamp:
    """The date; JAUS counts years from 2000."""
    return DateStamp(day=moment.day, month=moment.month, year=moment.year - 2000)


def epoch_seconds(moment: datetime) -> tuple[int, int] | tuple[None, None]:
    """Whole seconds since 1970, and the nanoseconds after them; a client may set a year that 32 bits do not reach."""
    seconds = int(moment.timestamp())
    return (seconds, moment.microsecond * 1000) if 0 <= seconds <= 0xFFFFFFFF else (None, None)


MAX_TEXT: Final = 255
"""Characters of a counted string in the messages of the cell."""


def sent_text(text: str) -> str:
    """The text in Latin-1, with question marks for other characters; cut off with an ellipsis where it is too long."""
    sent = text.encode("latin-1", errors="replace").decode("latin-1")
    return sent if len(sent) <= MAX_TEXT else f"{sent[: MAX_TEXT - 3]}..."
