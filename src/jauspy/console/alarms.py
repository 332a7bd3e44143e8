"""The alarms of one page: shown while their cause lasts and until they are acknowledged; a new cause sounds again."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

MAX_ALARMS: Final = 32
"""Alarms that are kept; the oldest whose cause has ended goes first."""


@dataclass(frozen=True, slots=True)
class Alarm:
    """One alarm: `key` names its cause, `text` tells it and may change while it lasts."""

    key: str
    text: str
    is_urgent: bool = False
    """True for what needs the operator at once; it sounds until it is acknowledged."""
    is_acknowledged: bool = False
    has_ended: bool = False


class Alarms:
    """The alarms in the order of the causes that were given last, the most important first."""

    def __init__(self) -> None:
        self._alarms: dict[str, Alarm] = {}

    def __len__(self) -> int:
        return len(self._alarms)

    def update(self, causes: Iterable[Alarm]) -> list[Alarm]:
        """Take all causes that there are now; returns the alarms that are new."""
        now = {alarm.key: alarm for alarm in causes}
        new = []
        for key, alarm in list(self._alarms.items()):
            if key not in now and alarm.is_acknowledged:
                del self._alarms[key]
            elif key not in now:
                self._alarms[key] = replace(alarm, has_ended=True)
        for key, alarm in now.items():
            before = self._alarms.get(key)
            if before is None or before.has_ended:
                new.append(alarm)
            is_known = before is not None and before.is_acknowledged and not before.has_ended
            self._alarms[key] = replace(alarm, is_acknowledged=is_known)
        self._alarms = {key: self._alarms[key] for key in (*now, *(self._alarms.keys() - now.keys()))}
        while len(self._alarms) > MAX_ALARMS:
            ended = (key for key, alarm in self._alarms.items() if alarm.has_ended)
            del self._alarms[next(ended, next(iter(self._alarms)))]
        return new

    def acknowledge(self) -> list[Alarm]:
        """Acknowledge all alarms, and forget those whose cause has ended; returns those that were not acknowledged."""
        open_ones = [alarm for alarm in self._alarms.values() if not alarm.is_acknowledged]
        self._alarms = {
            key: replace(alarm, is_acknowledged=True) for key, alarm in self._alarms.items() if not alarm.has_ended
        }
        return open_ones

    @property
    def shown(self) -> Sequence[Alarm]:
        """All alarms: those first that are not acknowledged, urgent ones before others."""
        return sorted(self._alarms.values(), key=lambda alarm: (alarm.is_acknowledged, not alarm.is_urgent))

    @property
    def is_loud(self) -> bool:
        """True while an urgent alarm is not acknowledged."""
        return any(alarm.is_urgent and not alarm.is_acknowledged for alarm in self._alarms.values())
