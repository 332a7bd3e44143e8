"""Time: tells and sets the component's date and time of day (AS5710)."""

from __future__ import annotations

from datetime import datetime

from jauspy.messages.core import ReportTime, SetTime
from jauspy.services.service import Service
from jauspy.services.units import date_stamp, time_stamp


class Time(Service, urn="urn:jaus:jss:core:Time"):
    """UTC. Setting it keeps an offset to the wall clock; the machine's own clock is never touched."""

    def set_time(self, msg: SetTime) -> None:
        """Take over what the message has; a date that no calendar has is counted and ignored."""
        try:
            wanted = _combined(self.host.utc_time, msg)
        except ValueError as error:
            self.host.count("impossible_time", str(error))
            return
        self.host.clock_offset = wanted - self.host.utc_now()

    def report_time(self) -> ReportTime:
        """Time of day and date."""
        now = self.host.utc_time
        return ReportTime(time_stamp=time_stamp(now), date_stamp=date_stamp(now))


def _combined(now: datetime, msg: SetTime) -> datetime:
    parts: dict[str, int] = {}
    if (time := msg.time_stamp) is not None:
        parts |= {"day": time.day, "hour": time.hour, "minute": time.minutes, "second": time.seconds}
        parts |= {"microsecond": time.milliseconds * 1000}
    if (date := msg.date_stamp) is not None:
        parts |= {"year": 2000 + date.year, "month": date.month, "day": date.day}
    return now.replace(**parts)  # type: ignore[arg-type]  # all of these are numbers
